// SPDX-License-Identifier: MIT
#include "raycast/cells/space.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "csg/base/precondition.h"
#include "raycast/cells/detail/section_ground.h"
#include "raycast/cells/detail/space_content.h"
#include "raycast/cells/formula/leaf_terms.h"
#include "raycast/surface/kind.h"

namespace csgcast {
namespace {

// A node near which a tree has more terms is not examined for its effect, because that takes time by the third power of
// their number.
constexpr std::size_t most_terms_of_effect = 2048;

}  // namespace

Space::Space(const Scene& scene, NodeId node, std::span<const NodeId> less)
    : content_(std::make_shared<const Content>(Content{
          std::make_shared<const detail::CellGround>(scene, node),
          scene.node(node).box.is_null() ? detail::Formula() : detail::formula_of_difference(scene, node, less)})),
      box_(content_->ground->box),
      node_(node),
      is_bounded_(content_->ground->is_bounded) {}

Space::Space(Content content, CellBox box, NodeId node)
    : content_(std::make_shared<const Content>(std::move(content))), box_(box), node_(node) {}

Space::~Space() = default;
Space::Space(Space&&) noexcept = default;
Space::Space(const Space&) = default;

Space Space::common(NodeId a, NodeId b) const {
  const auto& ground = content_->ground;
  const Box shared = intersection(scene().node(a).box, scene().node(b).box);
  if (shared.is_null()) return {Content{ground, {}}, ground->box};
  const bool is_bounded = shared.is_finite();
  Space result(Content{ground, detail::formula_of_common(scene(), a, b)},
               is_bounded ? ground->box_of(shared) : ground->box);
  result.is_bounded_ = is_bounded;
  return result;
}

Space Space::effect_of(NodeId node, bool as_everything, const Box& reach) const {
  const auto& ground = content_->ground;
  if (reach.is_null()) return {Content{ground, {}}, ground->box};
  if (!reach.is_finite()) return unbounded();
  const CellBox box = ground->tight_box_of(reach);
  // Turned forms are valid only for places near the frame.
  if (ground->axes && !detail::near_frame(box)) return unbounded();
  auto formula = detail::formula_of_effect(scene(), node_, node, as_everything, reach, most_terms_of_effect);
  return formula ? Space(Content{ground, std::move(*formula)}, box) : unbounded();
}

Space Space::section(Vector normal, double distance) const {
  CSGCAST_PRECONDITION(is_bounded() && is_finite(normal) && longest(normal) > 0);
  auto [ground, misses] = detail::section_ground(*content_->ground, node_, normal, distance);
  const CellBox own = ground->box;
  return {Content{std::move(ground), misses ? detail::Formula() : content_->formula}, own, node_};
}

Space Space::unbounded() const {
  Space result(Content{content_->ground, {}}, content_->ground->box);
  result.is_bounded_ = false;
  return result;
}

const Scene& Space::scene() const { return content_->ground->scene; }
bool Space::is_empty() const { return content_->formula.is_constant() && !content_->formula.value; }
const CellForm& Space::form(std::uint32_t surface) const { return content_->ground->forms[surface]; }
bool Space::is_known(std::uint32_t surface) const {
  return surface < scene().surfaces().size() && scene().surfaces()[surface].in_range;
}

std::uint64_t Space::most_crossings(std::uint32_t surface) const {
  const auto of_surface = [&](SurfaceId id) {
    return std::uint64_t{std::max(scene().surface(id).kind->most_crossings, std::uint8_t{2})};
  };
  const LeafId leaf = detail::leaf_of(scene(), SurfaceId(surface));
  if (!leaf.valid()) return of_surface(SurfaceId(surface));
  std::uint64_t sum = 0;
  for (const HalfSpace& half_space : scene().half_spaces(scene().leaf(leaf))) sum += of_surface(half_space.surface);
  return sum;
}

bool Space::is_plane(std::uint32_t surface) const { return scene().surfaces()[surface].is_plane; }
double Space::scale() const { return std::ldexp(1.0, scene().frame().exponent); }

std::array<Vector, 3> Space::axes() const {
  if (content_->ground->axes) return content_->ground->axes->rounded();
  return {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};
}

Vector Space::turned_back(Vector v) const {
  const auto rows = axes();
  return v.x * rows[0] + v.y * rows[1] + v.z * rows[2];
}

Point Space::in_scene(Vector u) const { return scene().frame().center + scale() * turned_back(u); }

}  // namespace csgcast
