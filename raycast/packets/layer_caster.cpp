// SPDX-License-Identifier: MIT
#include "raycast/packets/layer_caster.h"

#include <algorithm>
#include <cmath>

#include "csg/base/length.h"
#include "csg/base/precondition.h"
#include "raycast/line/box_line.h"
#include "raycast/packets/detail/caster_pointers.h"
#include "raycast/ray/layer_sweep.h"
#include "raycast/scene/even_looks.h"

namespace csgcast {
namespace {

constexpr std::size_t most_layers = 16;
constexpr std::size_t most_surfaces = 1u << 20;  // summed over the layers

std::weak_ordering by_t(const Crossing& a, const Crossing& b) {
  return a.t < b.t ? std::weak_ordering::less : std::weak_ordering::greater;
}

}  // namespace

bool LayerCells::suits(const Scene& scene) {
  const std::size_t layers = scene.layers().size();
  return layers > 0 && layers <= most_layers && layers * scene.surfaces().size() <= most_surfaces &&
         scene.bounded_leaves().is_finite();
}

LayerCells::LayerCells(const Scene& scene)
    : scene_(&scene),
      even_looks_(csgcast::even_looks(scene)),
      all_look_even_(std::find(even_looks_.begin(), even_looks_.end(), 0) == even_looks_.end()) {
  CSGCAST_PRECONDITION(suits(scene));
  for (const Layer& layer : scene.layers()) layers_.emplace_back(scene, layer.node);
}

// One ray in the form of arrays.
struct LayerCaster::Query {
  Query(const Ray& of, const std::optional<Departure>& from, double until, const Frame& frame)
      : ray(of), departure(from), end(until), unit(std::ldexp(1, frame.exponent) / longest(of.direction())) {
    pointers.count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      origin[axis] = of.origin()[axis];
      direction[axis] = of.direction()[axis];
      pointers.origin[axis] = &origin[axis];
      pointers.direction[axis] = &direction[axis];
    }
    if (from) {
      surface = from->surface.index();
      is_positive = from->side == Sense::positive ? 1 : 0;
      pointers.departure = &surface;
      pointers.departs_positive = &is_positive;
    }
    if (until < HUGE_VAL) pointers.end = &end;
  }
  Query(const Query&) = delete;

  bool may_meet(const Box& box) const {
    Span span{0, end};
    return detail::may_meet(box, ray, span);
  }

  const Ray& ray;
  const std::optional<Departure>& departure;
  std::array<double, 3> origin, direction;
  std::uint32_t surface = 0;
  std::uint8_t is_positive = 0;
  double end;
  double unit;  // the frame's unit, in t
  PacketCaster::RayPointers pointers;
  bool is_begun = false;  // true if the caster has begun the ray
};

LayerCaster::LayerCaster(const LayerCells& cells, Caster& caster, std::string_view instructions)
    : cells_(cells),
      scene_(cells.scene()),
      caster_(caster),
      meetings_(cells.layers().size()),
      lists_(meetings_.size()),
      spans_(meetings_.size()) {
  for (const Cells& layer : cells.layers()) casters_.emplace_back(layer, PacketCaster::Width::single, instructions);
}

void LayerCaster::meet(std::size_t layer, const Query& query) {
  Meeting& meeting = meetings_[layer];
  meeting.hits = meeting.is_inside = false;
  if (!query.may_meet(box_of(layer))) return;
  std::uint8_t state, is_inside, comes_positive, root;
  double t;
  std::uint32_t surface, look;
  double point[3], normal[3];
  PacketCaster::FacePointers faces;
  faces.state = &state;
  faces.is_inside = &is_inside;
  faces.t = &t;
  faces.surface = &surface;
  faces.root = &root;
  faces.look = &look;
  faces.comes_positive = &comes_positive;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    faces.point[axis] = &point[axis];
    faces.normal[axis] = &normal[axis];
  }
  casters_[layer].first_faces(query.pointers, faces);
  meeting.hits = state != FaceArrays::none;
  meeting.is_inside = is_inside != 0;
  if (!meeting.hits) return;
  meeting.enters = state == FaceArrays::entry;
  meeting.is_certain = casters_[layer].left_to_caster().empty();
  meeting.crossing = {t, SurfaceId(surface), root};
  meeting.face = {{},
                  {},
                  {},
                  LookId(look),
                  {point[0], point[1], point[2]},
                  as_normal({normal[0], normal[1], normal[2]}),
                  comes_positive != 0 ? Sense::positive : Sense::negative};
}

// The two must differ by far more than t may move by the errors of lanes' events, below 2^-32 in the frame, and by
// rounding.
bool LayerCaster::far_apart(const Crossing& a, const Crossing& b, const Query& query) const {
  const double margin = 0x1p-28 * query.unit + 0x1p-48 * (std::fabs(a.t) + std::fabs(b.t));
  return std::fabs(a.t - b.t) > margin;
}

std::weak_ordering LayerCaster::exact_order(const Crossing& a, const Crossing& b, Query& query) {
  if (a.surface == b.surface && a.surface.valid()) return a.root <=> b.root;
  if (!query.is_begun) caster_.begin(query.ray, query.departure);
  query.is_begun = true;
  return caster_.order(a, b);
}

std::weak_ordering LayerCaster::order(const Meeting& a, const Meeting& b, Query& query) {
  if (a.is_certain && b.is_certain && far_apart(a.crossing, b.crossing, query)) return by_t(a.crossing, b.crossing);
  return exact_order(a.crossing, b.crossing, query);
}

std::size_t LayerCaster::holder() const {
  for (std::size_t layer = 0; layer < meetings_.size(); ++layer)
    if (meetings_[layer].is_inside) return layer;
  return detail::no_layer;
}

LayerCaster::Outcome LayerCaster::look(const Ray& ray, const std::optional<Departure>& departure) {
  Query query(ray, departure, Span().to, scene_.frame());
  const Meeting* first = nullptr;
  for (std::size_t layer = 0; layer < meetings_.size(); ++layer) {
    meet(layer, query);
    const Meeting& meeting = meetings_[layer];
    if (meeting.hits && (first == nullptr || order(meeting, *first, query) < 0)) first = &meeting;
  }
  if (first == nullptr) return Outcome::none;
  const std::size_t from = holder();
  for (Meeting& meeting : meetings_) {
    meeting.hits = meeting.hits && (&meeting == first || order(meeting, *first, query) == 0);
    if (meeting.hits) meeting.is_inside = meeting.enters;
  }
  const std::size_t to = holder();
  if (to == from || detail::same_medium(scene_, from, to)) return Outcome::open;
  // This is the same rule as in each_change.
  const bool enters = to != detail::no_layer && meetings_[to].hits;
  const std::size_t layer = enters ? to : from;
  const Meeting& told = meetings_[layer];
  change_ = {{told.crossing, enters ? Passage::entry : Passage::exit},
             detail::region_of(scene_, from),
             detail::region_of(scene_, to),
             detail::is_opaque(scene_, to),
             scene_.layers()[layer].node};
  face_ = told.face;
  return Outcome::found;
}

void LayerCaster::look_through(const Ray& ray, const std::optional<Departure>& departure, double end,
                               std::vector<Interface>& changes, std::vector<LookId>& looks) {
  changes.clear();
  looks.clear();
  Query query(ray, departure, end, scene_.frame());
  bool are_certain = true;
  for (std::size_t layer = 0; layer < casters_.size(); ++layer) {
    spans_[layer] = {};
    if (!query.may_meet(box_of(layer))) continue;
    casters_[layer].intervals(query.pointers, lists_[layer], Rounding::close, PacketCaster::Ends::looks);
    are_certain = are_certain && casters_[layer].left_to_caster().empty();
    spans_[layer] = lists_[layer].intervals;
  }
  const auto order = [&](const Crossing& a, const Crossing& b) -> std::weak_ordering {
    if (std::isinf(a.t) || std::isinf(b.t)) return a.t == b.t ? std::weak_ordering::equivalent : by_t(a, b);
    return are_certain && far_apart(a, b, query) ? by_t(a, b) : exact_order(a, b, query);
  };
  detail::LayerSweep sweep(spans_, passed_, order);
  detail::each_change(scene_, sweep, [&](const Interface& change, std::size_t layer, std::size_t at) {
    changes.push_back(change);
    looks.push_back(lists_[layer].faces[at].look);
  });
}

PacketCounts LayerCaster::counts() const {
  PacketCounts sum;
  for (const PacketCaster& caster : casters_) sum += caster.counts();
  return sum;
}

CasterCounts LayerCaster::caster_counts() const {
  CasterCounts sum;
  for (const PacketCaster& caster : casters_) sum += caster.caster_counts();
  return sum;
}

}  // namespace csgcast
