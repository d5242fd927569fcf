// SPDX-License-Identifier: MIT
#include "tests/support/planted.h"

#include <algorithm>
#include <cmath>

#include "csg/base/length.h"
#include "csg/exact/packed_form.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/primitives.h"
#include "raycast/line/exact_root.h"

namespace csgcast::test {
namespace {

using Form = QuadricForm;
using detail::ExactRoot;
using detail::Sides;

const std::array<Form, 3>& planes_of(const Surface& surface) {
  return dynamic_cast<const ThreePlanes&>(*surface.other).planes();
}

bool precedes(const Form& a, const Form& b) {
  return std::lexicographical_compare(a.coefficient.begin(), a.coefficient.end(), b.coefficient.begin(),
                                      b.coefficient.end());
}

// A plane along a line: value + slope t.
struct Linear {
  Dyadic value;
  Dyadic slope;
};

std::array<Linear, 3> along(const Line& line, const Surface& surface) {
  std::array<Linear, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& c = planes_of(surface)[i].coefficient;
    result[i].value = planes_of(surface)[i].at(line.ray.origin());
    for (std::size_t axis = 0; axis < 3; ++axis)
      result[i].slope += c[Form::x + axis] * Dyadic(line.ray.direction()[axis]);
  }
  return result;
}

struct Roots {
  std::vector<ExactRoot> at;
  bool positive_before = true;
};

void add_root(std::vector<ExactRoot>& roots, const ExactRoot& root) {
  const auto place = std::find_if(roots.begin(), roots.end(), [&](const ExactRoot& other) { return root <= other; });
  if (place != roots.end() && std::is_eq(root <=> *place)) {
    roots.erase(place);  // of even multiplicity it is no crossing
  } else {
    roots.insert(place, root);
  }
}

Roots whole_line(const Line& line, const Surface& surface) {
  Roots found;
  int sign_before = 1;
  for (const Linear& plane : along(line, surface)) {
    const int slope = plane.slope.sign();
    sign_before *= slope == 0 ? plane.value.sign() : -slope;
    if (slope != 0) add_root(found.at, ExactRoot::quotient(-plane.value, plane.slope));
  }
  if (sign_before == 0) return {};  // the line lies in a plane
  found.positive_before = sign_before > 0;
  return found;
}

// f is 0 at the start by definition, f = t g: after the start it changes its sign at the roots of g, from the side that
// is given to that of the far end. If their number does not lead there, one more change is at the start.
Roots after_departure(const Line& line, const Surface& surface) {
  const auto [p, q, r] = along(line, surface);
  const Dyadic c1 = p.slope * q.value * r.value + p.value * q.slope * r.value + p.value * q.value * r.slope;
  const Dyadic c2 = p.slope * q.slope * r.value + p.slope * q.value * r.slope + p.value * q.slope * r.slope;
  const Dyadic c3 = p.slope * q.slope * r.slope;
  Roots found;
  found.positive_before = line.departure_side == Sense::positive;
  if (c2.is_zero() && c3.is_zero()) {  // linear along the line: the slope tells the side
    if (!c1.is_zero()) found.positive_before = c1.sign() > 0;
    return found;
  }
  const unsigned count = c3.is_zero() ? 1 : 2;
  for (unsigned root = 0; root < count; ++root) {
    const ExactRoot at = ExactRoot::of(c3, c2, c1, root);
    if (at.d.sign() >= 0 && at > ExactRoot(Dyadic())) add_root(found.at, at);
  }
  const bool positive_after = (c3.is_zero() ? c2 : c3).sign() > 0;
  if ((found.at.size() % 2 != 0) == (positive_after == found.positive_before))
    found.at.insert(found.at.begin(), ExactRoot(Dyadic()));
  return found;
}

Roots roots_of(const Line& line, SurfaceId id, const Surface& surface) {
  return id == line.departure ? after_departure(line, surface) : whole_line(line, surface);
}

double nearest(const ExactRoot& root) {
  double guess = (root.p.nearest() + root.s * std::sqrt(std::fmax(root.d.nearest(), 0))) / root.q.nearest();
  // Steps to the neighbour as long as the point halfway to it lies on this side of the root; ties go to even.
  for (const double far : {HUGE_VAL, -HUGE_VAL}) {
    for (int steps = 0; steps < 64; ++steps) {
      const double next = std::nextafter(guess, far);
      const ExactRoot halfway((Dyadic(guess) + Dyadic(next)).scaled(-1));
      const auto order = root <=> halfway;
      const bool is_beyond = far > 0 ? order > 0 : order < 0;
      if (!is_beyond && !(order == 0 && halfway.p.nearest() == next)) break;
      guess = next;
    }
  }
  return guess;
}

LineCrossings written(const Line& line, const std::vector<double>& ts, bool positive_before, double error) {
  LineCrossings found;
  found.positive_before = positive_before;
  found.count = static_cast<std::uint8_t>(ts.size());
  found.error = error / line.in_frame.unit;
  const auto tau = [&](double t) { return t / line.in_frame.unit - line.in_frame.shift; };
  std::span<double> to = found.few;
  if (ts.size() > 2) found.many = to = line.memory->room_for(ts.size());
  std::transform(ts.begin(), ts.end(), to.begin(), tau);
  return found;
}

// The rung of floating point: certain of lines that are clearly not parallel to any of the planes, and whose roots lie
// clearly apart. The tests' numbers are small, so a margin of 1e-9 is far above all rounding.
std::optional<LineCrossings> in_double(const Line& line, SurfaceId id, const Surface& surface) {
  if (id == line.departure) return std::nullopt;
  std::vector<double> ts;
  bool positive = true;
  for (const Linear& plane : along(line, surface)) {
    const double slope = plane.slope.nearest();
    if (std::fabs(slope) < 1e-3) return std::nullopt;
    ts.push_back(-plane.value.nearest() / slope);
    positive = positive == (slope < 0);
  }
  std::sort(ts.begin(), ts.end());
  if (ts[1] - ts[0] < 1e-6 || ts[2] - ts[1] < 1e-6 || std::fmax(-ts[0], ts[2]) > 1e3) return std::nullopt;
  return written(line, ts, positive, 1e-9);
}

LineCrossings exactly(const Line& line, SurfaceId id, const Surface& surface) {
  const Roots roots = roots_of(line, id, surface);
  std::vector<double> ts;
  double most = 0;
  for (const ExactRoot& root : roots.at) {
    ts.push_back(nearest(root));
    most = std::fmax(most, std::fabs(ts.back()));
  }
  return written(line, ts, roots.positive_before, 0x1p-50 * (most + 16 * line.in_frame.unit));
}

ExactRoot exact_root(const Line& line, const CrossingView& crossing) {
  return roots_of(line, crossing.id, *crossing.surface).at[crossing.root];
}

int sign_at(const Surface& surface, Point p) {
  int sign = 1;
  for (const Form& plane : planes_of(surface)) sign *= plane.at(p).sign();
  return sign;
}

// By the products' signs at the corners: planes' values are exact there.
Sides sides_in(const Surface& surface, const Frame& frame, const CellBox& box) {
  int sign = 1;
  for (const Form& plane : planes_of(surface)) {
    int of_plane = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
      Point p;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double u = ((corner >> axis) & 1) != 0 ? box.upper[axis] : box.lower[axis];
        p[axis] = frame.center[axis] + std::ldexp(u, frame.exponent);
      }
      const int here = plane.at(p).sign();
      if (here == 0 || (corner > 0 && here != of_plane)) return Sides::both;
      of_plane = here;
    }
    sign *= of_plane;
  }
  return sign > 0 ? Sides::positive : Sides::negative;
}

Vector gradient_at(const Surface& surface, const Frame& /*frame*/, Point p) {
  std::array<double, 3> value;
  std::array<Vector, 3> slope;
  for (std::size_t i = 0; i < 3; ++i) {
    const Form& plane = planes_of(surface)[i];
    value[i] = plane.at(p).nearest();
    for (std::size_t axis = 0; axis < 3; ++axis) slope[i][axis] = plane.coefficient[Form::x + axis].nearest();
  }
  return value[1] * value[2] * slope[0] + value[0] * value[2] * slope[1] + value[0] * value[1] * slope[2];
}

const SurfaceKind three_planes{
    .name = "three planes",
    .most_crossings = 3,
    .takes_other = [](const OtherForm& form) { return dynamic_cast<const ThreePlanes*>(&form) != nullptr; },
    .in_double = in_double,
    .in_twofold = [](const Line&, SurfaceId, const Surface&) -> std::optional<LineCrossings> { return std::nullopt; },
    .exactly = exactly,
    .uncertified = exactly,
    .twofold_root = [](const Line&, const CrossingView&) -> std::optional<detail::TwofoldRoot> { return std::nullopt; },
    .exact_root = exact_root,
    .nearest_t = [](const Line&, const CrossingView&) -> std::optional<double> { return std::nullopt; },
    .exact_nearest_t = [](const Line& line,
                          const CrossingView& crossing) { return nearest(exact_root(line, crossing)); },
    .sign_at = sign_at,
    .sides_in = sides_in,
    .has_lanes = false,
    .gradient = gradient_at};

Form plane(double nx, double ny, double nz, double offset) { return Form::plane(nx, ny, nz, offset); }

}  // namespace

std::shared_ptr<const OtherForm> ThreePlanes::moved(const ExactAffine& world_from_solid) const {
  std::array<Form, 3> planes;
  const FormMover mover(world_from_solid);
  std::transform(planes_.begin(), planes_.end(), planes.begin(), [&](const Form& f) { return mover.moved(f); });
  return std::make_shared<ThreePlanes>(planes);
}

OtherForm::Canonical ThreePlanes::canonical() const {
  std::array<Form, 3> planes;
  bool flipped = false;
  for (std::size_t i = 0; i < 3; ++i) {
    CanonicalForm form = csgcast::canonical(planes_[i]);
    planes[i] = std::move(form.form);
    flipped = flipped != form.flipped;
  }
  std::sort(planes.begin(), planes.end(), precedes);
  return {std::make_shared<ThreePlanes>(planes), flipped};
}

bool ThreePlanes::equals(const OtherForm& other) const {
  const auto* planes = dynamic_cast<const ThreePlanes*>(&other);
  return planes != nullptr && planes->planes_ == planes_;
}

std::uint64_t ThreePlanes::hash() const {
  std::uint64_t sum = 3;
  for (const Form& form : planes_) sum = 31 * sum + PackedForm(form).hash();
  return sum;
}

SurfaceKinds planted_kinds() {
  static const std::array<const SurfaceKind*, 3> kinds{surface_kinds()[0], surface_kinds()[1], &three_planes};
  return kinds;
}

Solid cut_cube(double a, double b, double c) {
  LeafShape shape;
  shape.others.push_back(
      std::make_shared<ThreePlanes>(std::array<Form, 3>{plane(1, 0, 0, -a), plane(0, 1, 0, -b), plane(0, 0, 1, -c)}));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector n;
    n[axis] = 1;
    shape.forms.push_back(plane(n.x, n.y, n.z, -1));
    shape.forms.push_back(plane(-n.x, -n.y, -n.z, 0));
  }
  shape.bounds = {{0, 0, 0}, {1, 1, 1}};
  return Solid::leaf(std::move(shape));
}

Solid cut_cube_of_boxes(double a, double b, double c) {
  std::vector<Solid> parts;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const bool x = (corner & 1) != 0, y = (corner & 2) != 0, z = (corner & 4) != 0;
    if ((x != y) != z) continue;  // an odd number of factors is positive, and so is the product
    const Vector size{x ? 1 - a : a, y ? 1 - b : b, z ? 1 - c : c};
    parts.push_back(transformed(box(size), translation({x ? a : 0, y ? b : 0, z ? c : 0})));
  }
  return unite(parts);
}

Solid l_prism(bool is_capped) {
  LeafShape shape;
  shape.forms.push_back(plane(-1, 0, 0, 0));
  shape.forms.push_back(plane(0, -1, 0, 0));
  shape.forms.push_back(plane(1, 0, 0, -1));
  shape.forms.push_back(plane(0, 1, 0, -2));
  shape.forms.push_back(plane(1, 0, 0, -2));
  shape.forms.push_back(plane(0, 1, 0, -1));
  const TruthFormula along_y = both(std::vector{condition(2), condition(3)});
  const TruthFormula along_x = both(std::vector{condition(4), condition(5)});
  if (!is_capped) {
    shape.bounds = {{0, 0, -HUGE_VAL}, {2, 2, HUGE_VAL}};
    shape.inside = std::make_shared<TruthFormula>(
        both(std::vector{condition(0), either(std::vector{along_y, along_x}), condition(1)}));
    return Solid::leaf(std::move(shape));
  }
  shape.bounds = {{0, 0, 0}, {2, 2, 1}};
  shape.forms.push_back(plane(0, 0, -1, 0));
  // The top twice, once from either side: the L is not above it.
  shape.forms.push_back(plane(0, 0, 1, -1));
  shape.forms.push_back(plane(0, 0, -1, 1));
  const std::vector<TruthFormula> all{condition(0), condition(1), condition(6), condition(7), condition(8, false)};
  const auto arm = [&](std::uint32_t a, std::uint32_t b) {
    std::vector<TruthFormula> conditions = all;
    conditions.push_back(condition(a));
    conditions.push_back(condition(b));
    return both(conditions);
  };
  shape.inside = std::make_shared<TruthFormula>(either(std::vector{arm(2, 3), arm(4, 5)}));
  return Solid::leaf(std::move(shape));
}

Solid l_prism_of_boxes() { return unite({box({1, 2, 1}), box({2, 1, 1})}); }

bool in_l_prism(const std::vector<bool>& holds) {
  const bool is_low = holds.size() == 6 || (holds[6] && holds[7] && !holds[8]);
  return is_low && holds[0] && holds[1] && ((holds[2] && holds[3]) || (holds[4] && holds[5]));
}

LeafFunction::Content Reluctant::in_box(std::span<const HalfSpace> half_spaces, LeafBox& box,
                                        TruthFormula& terms) const {
  const Box where = box.in_scene();
  if (!(longest(where.upper - where.lower) <= largest_)) return Content::open;
  const Content content = inner_->in_box(half_spaces, box, terms);
  return content == Content::terms && !tells_terms_ ? Content::open : content;
}

Scene with_reluctant_leaves(const Scene& scene, double largest, bool tells_terms) {
  SceneTables tables = scene.tables();
  for (Leaf& leaf : tables.leaves) {
    if (leaf.function == nullptr) continue;
    const auto inner = std::find_if(tables.functions.begin(), tables.functions.end(),
                                    [&](const auto& function) { return function.get() == leaf.function; });
    tables.functions.push_back(std::make_shared<Reluctant>(*inner, largest, tells_terms));
    leaf.function = tables.functions.back().get();
  }
  return Scene(std::move(tables));
}

}  // namespace csgcast::test
