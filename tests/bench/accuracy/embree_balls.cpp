// SPDX-License-Identifier: MIT
#include "tests/bench/accuracy/embree_balls.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>

#include "tests/bench/accuracy/ball_families.h"
#include "tests/bench/accuracy/stopwatch.h"
#include "tests/bench/embree_handles.h"

namespace csgcast::bench {
namespace {

constexpr int passes = 5;

OwnedEmbree<RTCScene> make_scene(RTCDevice device, const std::vector<Ball>& balls) {
  OwnedEmbree<RTCScene> scene(rtcNewScene(device));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* next = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 4 * sizeof(float), balls.size()));
  for (const Ball& ball : balls) {
    for (const double number : {ball.center.x, ball.center.y, ball.center.z, ball.radius})
      *next++ = static_cast<float>(number);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene.get());
  return scene;
}

std::optional<double> first_hit(RTCScene scene, const Ray& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(ray.origin().x);
  query.ray.org_y = static_cast<float>(ray.origin().y);
  query.ray.org_z = static_cast<float>(ray.origin().z);
  query.ray.dir_x = static_cast<float>(ray.direction().x);
  query.ray.dir_y = static_cast<float>(ray.direction().y);
  query.ray.dir_z = static_cast<float>(ray.direction().z);
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0U;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return static_cast<double>(query.ray.tfar);
}

}  // namespace

std::optional<FirstHits> ask_embree(std::span<const Sample> samples) {
  const OwnedEmbree<RTCDevice> device(rtcNewDevice("threads=1"));
  FirstHits answer;
  std::vector<double> seconds(passes);
  for (const Sample& sample : samples) {
    const std::optional<std::vector<Ball>> balls = balls_of(sample.solid);
    if (!balls) return std::nullopt;
    const OwnedEmbree<RTCScene> scene = make_scene(device.get(), *balls);
    for (const Ray& ray : sample.rays) answer.t.push_back(first_hit(scene.get(), ray));
    for (double& sum : seconds) {
      const Stopwatch watch;
      for (const Ray& ray : sample.rays) first_hit(scene.get(), ray);
      sum += watch.seconds();
    }
  }
  std::nth_element(seconds.begin(), seconds.begin() + passes / 2, seconds.end());
  answer.nanoseconds = seconds[passes / 2] / static_cast<double>(answer.t.size()) * 1e9;
  return answer;
}

}  // namespace csgcast::bench
