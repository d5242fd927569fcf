// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "tests/bench/embree_handles.h"
#include "tests/bench/peers/embree_packets.h"
#include "tests/bench/peers/embree_parts.h"

namespace csgcast::bench {
namespace {

OwnedEmbree<RTCScene> make_scene(RTCDevice device, const PartTree& tree) {
  OwnedEmbree<RTCScene> scene(rtcNewScene(device));
  rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_MEDIUM);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* next = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                                           4 * sizeof(float), tree.parts.size()));
  for (const Part& part : tree.parts) {
    const auto& ball = std::get<Ball>(part);
    for (const double number : {ball.center.x, ball.center.y, ball.center.z, ball.radius})
      *next++ = static_cast<float>(number);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene.get());
  return scene;
}

class BallEngine : public Engine {
 public:
  explicit BallEngine(const PeerScene& scene)
      : device_(rtcNewDevice("threads=1")), scene_(make_scene(device_.get(), scene.tree)) {}

  bool knows_intervals() const override { return false; }
  void intervals(const RayBatch&, IntervalTable&) override {}

 protected:
  RTCScene scene() const { return scene_.get(); }

 private:
  OwnedEmbree<RTCDevice> device_;
  OwnedEmbree<RTCScene> scene_;
};

template <std::size_t lanes>
class BallPackets : public BallEngine {
 public:
  using BallEngine::BallEngine;

  std::string name() const override {
    return lanes == 1 ? "Embree, its spheres, single rays" : fmt::format("Embree, its spheres, packets of {}", lanes);
  }

  void first_hits(const RayBatch& rays, std::span<double> t) override {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (lanes > 1) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (std::size_t i = 0; i < rays.size(); i += lanes) {
      alignas(64) EmbreeRays<lanes> query;
      load<lanes>(rays, i, query);
      intersect(scene(), &context, query);
      for (unsigned lane = 0; lane < lanes; ++lane) t[i + lane] = hit_t<lanes>(query, lane);
    }
  }
};

class BallStreams : public BallEngine {
 public:
  using BallEngine::BallEngine;

  std::string name() const override { return "Embree, its spheres, streams"; }

  void first_hits(const RayBatch& rays, std::span<double> t) override {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    std::array<RTCRayHit, tile_rays> queries;
    for (std::size_t i = 0; i < rays.size(); i += queries.size()) {
      for (std::size_t k = 0; k < queries.size(); ++k) load<1>(rays, i + k, queries[k]);
      rtcIntersect1M(scene(), &context, queries.data(), queries.size(), sizeof(RTCRayHit));
      for (std::size_t k = 0; k < queries.size(); ++k) t[i + k] = hit_t<1>(queries[k], 0);
    }
  }
};

}  // namespace

Engines embree_ball_engines(const PeerScene& scene) {
  Engines engines;
  if (!scene.tree.is_union_of_balls()) return engines;
  engines.push_back(std::make_unique<BallPackets<1>>(scene));
  engines.push_back(std::make_unique<BallPackets<8>>(scene));
  engines.push_back(std::make_unique<BallPackets<16>>(scene));
  engines.push_back(std::make_unique<BallStreams>(scene));
  return engines;
}

Engines embree_engines(const PeerScene& scene) {
  Engines engines = embree_parts_engines(scene);
  for (auto& engine : embree_ball_engines(scene)) engines.push_back(std::move(engine));
  return engines;
}

}  // namespace csgcast::bench
