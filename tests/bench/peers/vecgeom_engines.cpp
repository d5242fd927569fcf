// SPDX-License-Identifier: MIT
#include <VecGeom/management/GeoManager.h>
#include <VecGeom/volumes/LogicalVolume.h>
#include <VecGeom/volumes/UnplacedBooleanVolume.h>
#include <VecGeom/volumes/UnplacedBox.h>
#include <VecGeom/volumes/UnplacedCone.h>
#include <VecGeom/volumes/UnplacedMultiUnion.h>
#include <VecGeom/volumes/UnplacedOrb.h>
#include <VecGeom/volumes/UnplacedTube.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <type_traits>

#include "tests/bench/peers/engines.h"

namespace csgcast::bench {
namespace {

using vecgeom::GeoManager;
using vecgeom::LogicalVolume;
using vecgeom::Transformation3D;
using vecgeom::VPlacedVolume;
using vecgeom::VUnplacedVolume;
using VecgeomVector = vecgeom::Vector3D<double>;

/// How a node of many children becomes volumes.
enum class Manner : std::uint8_t {
  chain,        ///< one Boolean volume of two after the other
  multi_union,  ///< many children of a union, or of what a difference subtracts, are one volume with a hierarchy
};

/// Fewer children are a chain in any case.
constexpr std::size_t wide = 8;

/// VecGeom's tolerances and pushes are lengths, 1e-9 and 1e-6. In a scene of about this size they are what they were
/// made for: small beside the parts, and large beside rounding.
constexpr double scene_size = 1000;

// Where VecGeom takes a part to have its middle.
Point middle(const Ball& ball) { return ball.center; }
Point middle(const Brick& brick) { return brick.lower + 0.5 * (brick.upper - brick.lower); }
Point middle(const Frustum& frustum) {
  Point p = frustum.bottom;
  p[frustum.axis] += frustum.height / 2;
  return p;
}

/// Volumes live as long as the program: VecGeom keeps track of them.
///
/// Its intersection of two asks the left one for the way out without taking the ray to the left one's coordinates
/// (1.2.1, BooleanIntersectionImplementation.h). So an intersection is built in the coordinates of its first child.
class VolumeBuilder {
 public:
  VolumeBuilder(const PartTree& tree, double scale, Manner manner) : tree_(tree), scale_(scale), manner_(manner) {}

  const VPlacedVolume* root() { return place(static_cast<std::uint32_t>(tree_.nodes.size() - 1), {}); }

 private:
  using Nodes = std::span<const std::uint32_t>;

  static const VPlacedVolume* placed(const VUnplacedVolume* volume, const Transformation3D& where = {}) {
    return (new LogicalVolume(volume))->Place(new Transformation3D(where));
  }

  template <vecgeom::BooleanOperation operation>
  static const VUnplacedVolume* combined(const VPlacedVolume* left, const VPlacedVolume* right) {
    return GeoManager::MakeInstance<vecgeom::UnplacedBooleanVolume<operation>>(operation, left, right);
  }

  const VUnplacedVolume* shape(const Ball& ball) const {
    return GeoManager::MakeInstance<vecgeom::UnplacedOrb>(scale_ * ball.radius);
  }

  const VUnplacedVolume* shape(const Brick& brick) const {
    const Vector half = scale_ / 2 * (brick.upper - brick.lower);
    return GeoManager::MakeInstance<vecgeom::UnplacedBox>(half.x, half.y, half.z);
  }

  const VUnplacedVolume* shape(const Frustum& f) const {
    constexpr double around = 2 * std::numbers::pi;
    const double half = scale_ * f.height / 2, bottom = scale_ * f.bottom_radius, top = scale_ * f.top_radius;
    if (bottom == top) return GeoManager::MakeInstance<vecgeom::UnplacedTube>(0., top, half, 0., around);
    return GeoManager::MakeInstance<vecgeom::UnplacedCone>(0., bottom, 0., top, half, 0., around);
  }

  Transformation3D moved_by(Vector offset) const { return {scale_ * offset.x, scale_ * offset.y, scale_ * offset.z}; }

  template <class P>
  const VPlacedVolume* place(const P& part, Point origin) const {
    const Vector o = scale_ * (middle(part) - origin);
    if constexpr (std::is_same_v<P, Frustum>) {
      // Its own axis is z. After the offset come nine entries of the matrix that takes the world's axes to its own:
      // what becomes of x, of y, of z.
      if (part.axis == 0) return placed(shape(part), {o.x, o.y, o.z, 0, 0, 1, 1, 0, 0, 0, 1, 0});
      if (part.axis == 1) return placed(shape(part), {o.x, o.y, o.z, 0, 1, 0, 0, 0, 1, 1, 0, 0});
    }
    return placed(shape(part), {o.x, o.y, o.z});
  }

  // Everything is placed in coordinates that are the world's but for their origin.
  const VPlacedVolume* place(std::uint32_t index, Point origin) {
    const PartNode& node = tree_.nodes[index];
    const Nodes children = node.children;
    switch (node.op) {
      case PartNode::Op::part:
        return std::visit([&](const auto& part) { return place(part, origin); }, tree_.parts[node.part]);
      case PartNode::Op::unite:
        return united(children, origin);
      case PartNode::Op::intersect:
        return intersected(children, origin);
      default:
        if (manner_ == Manner::chain) return chain<vecgeom::kSubtraction>(children, origin);
        return placed(combined<vecgeom::kSubtraction>(place(children[0], origin), united(children.subspan(1), origin)));
    }
  }

  const VPlacedVolume* united(Nodes nodes, Point origin) {
    if (manner_ == Manner::chain || nodes.size() < wide) return chain<vecgeom::kUnion>(nodes, origin);
    auto* volume = new vecgeom::UnplacedMultiUnion;
    for (const std::uint32_t node : nodes) volume->AddNode(place(node, origin));
    volume->Close();
    return placed(volume);
  }

  const VPlacedVolume* intersected(Nodes nodes, Point origin) {
    std::vector<std::uint32_t> order(nodes.begin(), nodes.end());
    const auto straight = std::find_if(order.begin(), order.end(), [this](std::uint32_t node) {
      const auto* frustum = std::get_if<Frustum>(&tree_.parts[tree_.nodes[node].part]);
      return tree_.nodes[node].op != PartNode::Op::part || !frustum || frustum->axis == 2;
    });
    if (straight != order.end()) std::iter_swap(order.begin(), straight);
    const PartNode& first = tree_.nodes[order[0]];
    Point own = origin;
    if (first.op == PartNode::Op::part)
      own = std::visit([](const auto& part) { return middle(part); }, tree_.parts[first.part]);
    return placed(chain<vecgeom::kIntersection>(order, own)->GetUnplacedVolume(), moved_by(own - origin));
  }

  template <vecgeom::BooleanOperation operation>
  const VPlacedVolume* chain(Nodes nodes, Point origin) {
    const VPlacedVolume* volume = place(nodes[0], origin);
    for (const std::uint32_t node : nodes.subspan(1)) volume = placed(combined<operation>(volume, place(node, origin)));
    return volume;
  }

  const PartTree& tree_;
  double scale_;
  Manner manner_;
};

class VecgeomEngine : public Engine {
 public:
  VecgeomEngine(const PeerScene& scene, Manner manner)
      : manner_(manner),
        scale_(scene_size / scene.size),
        volume_(VolumeBuilder(scene.tree, scale_, manner).root()->GetUnplacedVolume()) {}

  std::string name() const override {
    return manner_ == Manner::chain ? "VecGeom, chains of Booleans" : "VecGeom, multi-unions";
  }

  void first_hits(const RayBatch& rays, std::span<double> t) override {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto [origin, direction] = scaled(rays.list()[i]);
      const double distance = volume_->DistanceToIn(origin, direction, vecgeom::kInfLength);
      t[i] = distance < vecgeom::kInfLength ? distance / scale_ : std::numeric_limits<double>::infinity();
    }
  }

  // In and out again, and each time a little further, as its navigators do, so that the surface is behind. Where it
  // takes a point that it entered at for one outside, each further push is twice as long.
  void intervals(const RayBatch& rays, IntervalTable& table) override {
    for (const Ray& ray : rays.list()) {
      const auto [origin, direction] = scaled(ray);
      double t = 0;
      double push = vecgeom::kPushTolerance;
      while (true) {
        const double in = volume_->DistanceToIn(origin + t * direction, direction, vecgeom::kInfLength);
        if (!(in < vecgeom::kInfLength)) break;
        const double entry = t + in;
        t = entry + push;
        const double out = volume_->DistanceToOut(origin + t * direction, direction, vecgeom::kInfLength);
        if (out > 0) {
          table.ends.push_back(entry / scale_);
          table.ends.push_back((t + out) / scale_);
          t += out;
          push = vecgeom::kPushTolerance;
        } else {
          push *= 2;
        }
        t += push;
      }
      table.end_ray();
    }
  }

 private:
  // Its directions are unit ones; so are the cameras'.
  std::pair<VecgeomVector, VecgeomVector> scaled(const Ray& ray) const {
    const Point o = ray.origin();
    const Vector d = ray.direction();
    return {{scale_ * o.x, scale_ * o.y, scale_ * o.z}, {d.x, d.y, d.z}};
  }

  Manner manner_;
  double scale_;
  const VUnplacedVolume* volume_;
};

// Whether the tree has a union, or a subtrahend, that a multi-union could be.
bool has_wide_union(const PartTree& tree) {
  for (const PartNode& node : tree.nodes) {
    if (node.op == PartNode::Op::unite && node.children.size() >= wide) return true;
    if (node.op == PartNode::Op::subtract && node.children.size() > wide) return true;
  }
  return false;
}

}  // namespace

Engines vecgeom_engines(const PeerScene& scene) {
  constexpr std::size_t longest_chain = 500;  // each link calls the one before it
  Engines engines;
  if (scene.tree.parts.size() <= longest_chain)
    engines.push_back(std::make_unique<VecgeomEngine>(scene, Manner::chain));
  if (has_wide_union(scene.tree)) engines.push_back(std::make_unique<VecgeomEngine>(scene, Manner::multi_union));
  return engines;
}

}  // namespace csgcast::bench
