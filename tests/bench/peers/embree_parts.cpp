// SPDX-License-Identifier: MIT
#include "tests/bench/peers/embree_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "csg/base/length.h"
#include "tests/bench/embree_handles.h"
#include "tests/bench/peers/embree_packets.h"
#include "tests/bench/peers/events.h"
#include "tests/bench/peers/lane_rays.h"

namespace csgcast::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

enum class Aim : std::uint8_t { gather, nearest };

// What the callbacks need of the packet under way, behind the context that Embree hands to them.
template <std::size_t lanes>
struct Gathering : RTCIntersectContext {
  Gathering(const RayBatch& all, std::size_t first) : rays(all, first) {
    rtcInitIntersectContext(this);
    if (lanes > 1) flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  }
  LaneRays<lanes> rays;
  std::array<std::vector<Event>, lanes>* events = nullptr;  // of Aim::gather
  std::array<double, lanes> nearest{};                      // of Aim::nearest
};

// The parts of one kind, which are one geometry.
template <class P>
struct Group {
  std::vector<P> parts;
  std::vector<std::uint32_t> numbers;  // in the tree
  std::vector<Box> boxes;
  Aim aim = Aim::gather;
};

template <class P>
void bounds_callback(const RTCBoundsFunctionArguments* arguments) {
  const Box& box = static_cast<const Group<P>*>(arguments->geometryUserPtr)->boxes[arguments->primID];
  RTCBounds& bounds = *arguments->bounds_o;
  constexpr float up = std::numeric_limits<float>::infinity();
  bounds.lower_x = std::nextafter(static_cast<float>(box.lower.x), -up);
  bounds.lower_y = std::nextafter(static_cast<float>(box.lower.y), -up);
  bounds.lower_z = std::nextafter(static_cast<float>(box.lower.z), -up);
  bounds.upper_x = std::nextafter(static_cast<float>(box.upper.x), up);
  bounds.upper_y = std::nextafter(static_cast<float>(box.upper.y), up);
  bounds.upper_z = std::nextafter(static_cast<float>(box.upper.z), up);
}

template <std::size_t lanes>
void take(const RTCIntersectFunctionNArguments& arguments, unsigned place, std::size_t lane, Stretch found,
          std::uint32_t number, Aim aim) {
  if (!(found.entry < found.exit && found.exit > 0)) return;
  auto& gathering = *static_cast<Gathering<lanes>*>(arguments.context);
  if (aim == Aim::gather) {
    std::vector<Event>& events = (*gathering.events)[lane];
    events.push_back({greater(found.entry, 0), number, 1});
    events.push_back({found.exit, number, -1});
  } else if (found.entry < gathering.nearest[lane]) {
    gathering.nearest[lane] = found.entry;
    RTCRayN* const rays = RTCRayHitN_RayN(arguments.rayhit, arguments.N);
    RTCRayN_tfar(rays, arguments.N, place) =
        std::nextafter(static_cast<float>(found.entry), std::numeric_limits<float>::infinity());
    RTCHitN_geomID(RTCRayHitN_HitN(arguments.rayhit, arguments.N), arguments.N, place) = arguments.geomID;
  }
}

template <class P, std::size_t lanes>
void intersect_callback(const RTCIntersectFunctionNArguments* arguments) {
  const auto& group = *static_cast<const Group<P>*>(arguments->geometryUserPtr);
  const auto& rays = static_cast<const Gathering<lanes>*>(arguments->context)->rays;
  const P& part = group.parts[arguments->primID];
  const std::uint32_t number = group.numbers[arguments->primID];
  if (arguments->N == lanes) {
    alignas(64) double entry[lanes];
    alignas(64) double exit[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const Stretch found = stretch(part, rays, lane);
      entry[lane] = found.entry;
      exit[lane] = found.exit;
    }
    for (unsigned lane = 0; lane < lanes; ++lane) {
      if (arguments->valid[lane] != 0)
        take<lanes>(*arguments, lane, lane, {entry[lane], exit[lane]}, number, group.aim);
    }
    return;
  }
  // Where the rays of a packet part, Embree goes on with fewer of them.
  for (unsigned place = 0; place < arguments->N; ++place) {
    if (arguments->valid[place] == 0) continue;
    const std::size_t lane = RTCRayN_id(RTCRayHitN_RayN(arguments->rayhit, arguments->N), arguments->N, place);
    take<lanes>(*arguments, place, lane, stretch(part, rays, lane), number, group.aim);
  }
}

// The parts in a scene of Embree's, for packets of so many lanes.
template <std::size_t lanes>
class PartScene {
 public:
  PartScene(const PeerScene& scene, Aim aim) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_.get())) {
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
    // Embree's rays are ours rounded to float: by this far at most are they beside them within the scene.
    const double distance = length(scene.compiled.bounds().center() - scene.rays[0].origin()) + scene.size;
    const Vector margin{distance * 0x1p-22, distance * 0x1p-22, distance * 0x1p-22};
    for (std::size_t i = 0; i < scene.tree.parts.size(); ++i) {
      const Part& part = scene.tree.parts[i];
      Box box = bounds_of(part);
      box = {box.lower - margin, box.upper + margin};
      const auto number = static_cast<std::uint32_t>(i);
      const auto* const frustum = std::get_if<Frustum>(&part);
      if (const auto* ball = std::get_if<Ball>(&part)) {
        add(balls_, *ball, number, box);
      } else if (const auto* brick = std::get_if<Brick>(&part)) {
        add(bricks_, *brick, number, box);
      } else if (frustum->bottom_radius == frustum->top_radius) {
        add(rods_, Rod{*frustum}, number, box);
      } else {
        add(frustums_, *frustum, number, box);
      }
    }
    attach(balls_, aim);
    attach(bricks_, aim);
    attach(rods_, aim);
    attach(frustums_, aim);
    rtcCommitScene(scene_.get());
  }
  PartScene(const PartScene&) = delete;

  RTCScene get() const { return scene_.get(); }

 private:
  template <class P>
  static void add(Group<P>& group, const P& part, std::uint32_t number, const Box& box) {
    group.parts.push_back(part);
    group.numbers.push_back(number);
    group.boxes.push_back(box);
  }

  template <class P>
  void attach(Group<P>& group, Aim aim) {
    if (group.parts.empty()) return;
    group.aim = aim;
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(group.parts.size()));
    rtcSetGeometryUserData(geometry, &group);
    rtcSetGeometryBoundsFunction(geometry, bounds_callback<P>, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_callback<P, lanes>);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
  }

  Group<Ball> balls_;
  Group<Brick> bricks_;
  Group<Rod> rods_;
  Group<Frustum> frustums_;
  OwnedEmbree<RTCDevice> device_;
  OwnedEmbree<RTCScene> scene_;
};

template <std::size_t lanes>
class PartsEngine : public Engine {
 public:
  explicit PartsEngine(const PeerScene& scene)
      : gathering_(scene, Aim::gather),
        nearest_(scene, Aim::nearest),
        state_(scene.tree),
        is_union_(scene.tree.is_union_of_parts()) {}

  std::string name() const override {
    return lanes == 1 ? "Embree, our parts, single rays" : fmt::format("Embree, our parts, packets of {}", lanes);
  }

  void first_hits(const RayBatch& rays, std::span<double> t) override {
    for (std::size_t i = 0; i < rays.size(); i += lanes) {
      if (is_union_) {
        Gathering<lanes> context(rays, i);
        context.nearest.fill(infinity);
        trace(nearest_, rays, i, context);
        std::copy(context.nearest.begin(), context.nearest.end(), t.begin() + static_cast<std::ptrdiff_t>(i));
        continue;
      }
      gather(rays, i);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        double& first = t[i + lane] = infinity;
        for_each_boundary(events_[lane], state_, [&first](double at) {
          first = at;
          return false;
        });
      }
    }
  }

  void intervals(const RayBatch& rays, IntervalTable& table) override {
    for (std::size_t i = 0; i < rays.size(); i += lanes) {
      gather(rays, i);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        for_each_boundary(events_[lane], state_, [&table](double at) {
          table.ends.push_back(at);
          return true;
        });
        table.end_ray();
      }
    }
  }

 private:
  static void trace(const PartScene<lanes>& scene, const RayBatch& rays, std::size_t first, Gathering<lanes>& context) {
    alignas(64) EmbreeRays<lanes> query;
    load<lanes>(rays, first, query);
    intersect(scene.get(), &context, query);
  }

  // Sorted events of each lane.
  void gather(const RayBatch& rays, std::size_t first) {
    for (std::vector<Event>& events : events_) events.clear();
    Gathering<lanes> context(rays, first);
    context.events = &events_;
    trace(gathering_, rays, first, context);
    for (std::vector<Event>& events : events_) sort_events(events);
  }

  PartScene<lanes> gathering_;
  PartScene<lanes> nearest_;
  std::array<std::vector<Event>, lanes> events_;
  TreeState state_;
  bool is_union_;
};

}  // namespace

Engines embree_parts_engines(const PeerScene& scene) {
  Engines engines;
  engines.push_back(std::make_unique<PartsEngine<1>>(scene));
  engines.push_back(std::make_unique<PartsEngine<8>>(scene));
  engines.push_back(std::make_unique<PartsEngine<16>>(scene));
  return engines;
}

}  // namespace csgcast::bench
