// SPDX-License-Identifier: MIT
#include "csg/text/statement/detail/leaf_statement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "csg/base/digits.h"
#include "csg/solid/leaf_shape.h"
#include "csg/solid/primitives.h"

namespace csgcast::text {
namespace {

/// A leaf and what makes it.
struct Candidate {
  Node node;
  Solid solid;
};

std::optional<double> exact(const Dyadic& a) {
  const double low = a.rounded_down();
  return low == a.rounded_up() ? std::optional(low) : std::nullopt;
}

bool makes(const Candidate& candidate, const LeafShape& shape) {
  if (candidate.solid.kind() != Solid::Kind::leaf) return false;
  const FormList& forms = candidate.solid.shape().forms;
  return forms.size() == shape.forms.size() && std::equal(forms.begin(), forms.end(), shape.forms.begin());
}

void set_center(Node& node) { add_argument(node, "center", {true}); }

Candidate cube_of(const Box& bounds) {
  const bool is_centered = bounds.lower.x < 0;
  const Vector upper{bounds.upper.x, bounds.upper.y, bounds.upper.z};
  const Vector size = is_centered ? 2 * upper : upper;
  Candidate result{statement("cube"), box(size, is_centered ? Centering::centered : Centering::corner)};
  add_argument(result.node, "size", list_value(size));
  if (is_centered) set_center(result.node);
  return result;
}

Candidate ball_of(const LeafShape& shape) {
  const Vector r = shape.semi_axes.value_or(Vector{});
  const bool is_sphere = shape.kind == LeafKind::sphere;
  Candidate result{statement(word(shape.kind)), is_sphere ? sphere(r.x) : ellipsoid(r)};
  add_argument(result.node, "r", is_sphere ? number_value(r.x) : list_value(r));
  return result;
}

Candidate cylinder_of(const LeafShape& shape) {
  if (shape.discs.size() != 2) return {};
  const auto [bottom, top] = std::pair(shape.discs[0], shape.discs[1]);
  const bool is_centered = bottom.z < 0;
  const double height = is_centered ? 2 * top.z : top.z;
  Candidate result{statement("cylinder"),
                   cylinder(height, bottom.radius, top.radius, is_centered ? Centering::centered : Centering::corner)};
  add_argument(result.node, "h", number_value(height));
  if (bottom.radius == top.radius) {
    add_argument(result.node, "r", number_value(bottom.radius));
  } else {
    add_argument(result.node, "r1", number_value(bottom.radius));
    add_argument(result.node, "r2", number_value(top.radius));
  }
  if (is_centered) set_center(result.node);
  return result;
}

Candidate paraboloid_of(const Box& bounds) {
  Candidate result{statement("paraboloid"), paraboloid(bounds.upper.z, bounds.upper.x)};
  add_argument(result.node, "h", number_value(bounds.upper.z));
  add_argument(result.node, "r", number_value(bounds.upper.x));
  return result;
}

/// The wider of its radii bounds it. The squares of the two differ by a coefficient, exactly; the root is what that
/// rounds to, or a neighbour.
Candidate hyperboloid_of(const LeafShape& shape) {
  const double height = 2 * shape.bounds.upper.z;
  const double widest = shape.bounds.upper.x;
  const Dyadic four_differences = shape.forms.front().coefficient[QuadricForm::zz];  // waist² - r²
  const bool is_barrel = four_differences.sign() > 0;
  const Dyadic difference = (is_barrel ? four_differences : -four_differences).scaled(-2);
  const double square = (Dyadic(widest) * Dyadic(widest) - difference).rounded_down();
  double narrow = std::sqrt(std::fmax(square, 0));
  constexpr int neighbours = 3;
  for (int i = 0; i < neighbours; ++i) narrow = std::nextafter(narrow, 0);
  for (int i = 0; i <= 2 * neighbours; ++i, narrow = std::nextafter(narrow, HUGE_VAL)) {
    const double r = is_barrel ? narrow : widest;
    const double waist = is_barrel ? widest : narrow;
    Candidate result{statement("hyperboloid"), hyperboloid(height, r, waist)};
    if (!makes(result, shape)) continue;
    add_argument(result.node, "h", number_value(height));
    add_argument(result.node, "r", number_value(r));
    add_argument(result.node, "waist", number_value(waist));
    return result;
  }
  return {};
}

Candidate primitive_of(const LeafShape& shape) {
  switch (shape.kind) {
    case LeafKind::cube:
      return cube_of(shape.bounds);
    case LeafKind::sphere:
    case LeafKind::ellipsoid:
      return ball_of(shape);
    case LeafKind::cylinder:
      return cylinder_of(shape);
    case LeafKind::paraboloid:
      return paraboloid_of(shape.bounds);
    case LeafKind::hyperboloid:
      return hyperboloid_of(shape);
    default:
      return {};
  }
}

using Coefficients = std::array<double, QuadricForm::term_count>;

/// Those of a quadric's matrix halved where they count twice.
std::optional<Coefficients> exact_coefficients(const QuadricForm& form) {
  Coefficients result;
  for (std::size_t term = 0; term < result.size(); ++term) {
    const bool is_mixed = term == QuadricForm::xy || term == QuadricForm::xz || term == QuadricForm::yz;
    const auto value = exact(is_mixed ? form.coefficient[term].scaled(-1) : form.coefficient[term]);
    if (!value) return std::nullopt;
    result[term] = *value;
  }
  return result;
}

std::optional<Node> quadric_or_plane(const QuadricForm& form) {
  using Form = QuadricForm;
  const auto c = exact_coefficients(form);
  if (!c) return std::nullopt;
  const Vector linear{(*c)[Form::x], (*c)[Form::y], (*c)[Form::z]};
  if (form.is_plane()) {
    Node node = statement("halfspace");
    add_argument(node, "n", list_value(linear));
    add_argument(node, "d", number_value(-(*c)[Form::one]));
    return node;
  }
  List rows;
  for (std::size_t i = 0; i < 3; ++i) {
    rows.push_back(list_value(
        {(*c)[Form::second_degree(i, 0)], (*c)[Form::second_degree(i, 1)], (*c)[Form::second_degree(i, 2)]}));
  }
  Node node = statement("quadric");
  add_argument(node, "A", {std::move(rows)});
  add_argument(node, "b", list_value(linear));
  add_argument(node, "c", number_value((*c)[Form::one]));
  return node;
}

Node hull_of(const std::vector<Point>& points, Vector error) {
  List list;
  for (const Point& p : points) list.push_back(list_value({p.x, p.y, p.z}));
  Node node = statement("convex");
  add_argument(node, "points", {std::move(list)});
  if (error != Vector{}) add_argument(node, "error", list_value(error));
  return node;
}

std::optional<Node> planes_of(const FormList& forms) {
  List list;
  for (const QuadricForm& form : forms) {
    const auto c = exact_coefficients(form);
    if (!c || !form.is_plane()) return std::nullopt;
    list.push_back({List{number_value((*c)[QuadricForm::x]), number_value((*c)[QuadricForm::y]),
                         number_value((*c)[QuadricForm::z]), number_value(-(*c)[QuadricForm::one])}});
  }
  Node node = statement("convex");
  add_argument(node, "planes", {std::move(list)});
  return node;
}

/// Unions and intersections of half-spaces. None of an intersection of nothing: there is no such statement.
std::optional<Node> truth_formula_of(const LeafShape& shape) {
  const TruthFormula& terms = *shape.inside;
  std::vector<Node> nodes(terms.size());
  for (std::size_t i = terms.size(); i-- > 0;) {  // operands come after their operators
    const TruthTerm& term = terms[i];
    if (term.op == TruthTerm::Op::condition) {
      const QuadricForm form = shape.forms[term.condition];
      std::optional<Node> side = quadric_or_plane(term.is_contrary ? -form : form);
      if (!side) return std::nullopt;
      nodes[i] = std::move(*side);
      continue;
    }
    if (term.op == TruthTerm::Op::intersect && term.size == 1) return std::nullopt;
    nodes[i] = statement(term.op == TruthTerm::Op::unite ? "union" : "intersection");
    nodes[i].has_block = true;
    for (std::size_t k = i + 1; k < i + term.size; k += terms[k].size) nodes[i].children.push_back(std::move(nodes[k]));
  }
  return std::move(nodes.front());
}

/// As Node::digits counts them. Lists nest a few levels deep here.
std::uint8_t most_digits(const Value& value) {
  if (const auto* number = std::get_if<double>(&value.data))
    return *number == std::trunc(*number) ? 0 : static_cast<std::uint8_t>(digits_used(*number));
  std::uint8_t most = 0;
  if (const auto* list = std::get_if<List>(&value.data)) {
    for (const Value& entry : *list) most = std::max(most, most_digits(entry));
  }
  return most;
}

}  // namespace

Value number_value(double number) { return {number}; }

Value list_value(const Vector& v) { return {List{number_value(v.x), number_value(v.y), number_value(v.z)}}; }

Node statement(std::string name) {
  Node node;
  node.name = std::move(name);
  return node;
}

void add_argument(Node& node, std::string name, Value value) {
  node.digits = std::max(node.digits, most_digits(value));
  node.arguments.push_back({std::move(name), std::move(value)});
}

std::optional<Node> leaf_statement(const LeafShape& shape) {
  if (!shape.others.empty()) return std::nullopt;
  if (shape.inside != nullptr) return truth_formula_of(shape);
  Candidate primitive = primitive_of(shape);
  if (makes(primitive, shape)) return std::move(primitive.node);
  if (!shape.vertices.empty()) return hull_of(shape.vertices, shape.error.axes);
  if (shape.forms.size() == 1) return quadric_or_plane(shape.forms.front());
  return planes_of(shape.forms);
}

}  // namespace csgcast::text
