// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "raycast/packets/packet_caster.h"
#include "shade/film/camera.h"
#include "shade/film/view.h"
#include "shade/trace/detail/face_buffers.h"
#include "shade/trace/report.h"
#include "shade/trace/tracer.h"

namespace csgcast::detail {

struct ShadingCode;
struct Samples;
struct ShadingPoints;
struct ShadowRays;

/// Shades many samples of a picture at once, in lanes: the same light as Tracer's, bit for bit. All rays of one depth
/// are traced together: those of the camera, then those that mirrors reflect, .. Samples that see an opaque face from
/// inside go to a Tracer, one by one. The working memory of one thread.
class PacketTracer {
 public:
  /// Whether packets can make the picture: nothing in the scene lets light through, and rays are traced at all.
  static bool suits(const Scene& scene, const View& view, const Camera& camera);

  /// All must outlive the packet tracer. Precondition: suits().
  PacketTracer(const Cells& cells, const View& view, const Camera& camera, Tracer& tracer,
               std::string_view instructions);

  /// The light that samples show; those that follow each other should be neighbours. Their colours go where they
  /// belong: colors[samples.place[i]].
  void trace(const Samples& samples, std::span<Rgb> colors);

  /// What was done so far, without the tracer's counts.
  RenderReport report() const;

 private:
  void resize(std::size_t count);
  void see();
  bool sort_out(std::span<Rgb> colors);
  void trace_alone(std::size_t ray, Rgb& color);
  void look_outside();
  void shade(std::span<Rgb> colors);
  void reflect(std::span<Rgb> colors);
  void leave(std::size_t ray, Rgb& color) const;
  bool reflect(std::size_t ray, std::size_t to, std::span<Rgb> colors);
  void add_light(const LightDescription& light, const ShadingPoints& points);
  void depart(const ShadowRays& shadows);

  const ShadingCode& code_;
  const Scene& scene_;
  const View& view_;
  const Camera& camera_;
  Tracer& tracer_;
  PacketCaster caster_;
  RenderReport report_;
  bool has_mirrors_ = false;

  // By ray of the present depth: where its sample's colour belongs, what its light counts, where it starts; and the
  // face that it sees.
  int depth_ = 0;
  std::size_t count_ = 0;
  std::vector<std::uint32_t> ray_place_, ray_departure_;
  std::vector<std::uint8_t> ray_departs_positive_;
  std::vector<Rgb> weight_;
  Vectors origin_, direction_;
  FaceBuffers faces_;
  std::vector<std::uint8_t> is_plain_;
  std::vector<std::uint8_t> leads_away_;  // all 0 where no side of the scene does
  Vectors color_;
  // By shadow ray, close together.
  Vectors shadow_origin_, path_, light_;
  std::vector<std::uint32_t> sample_, departure_;
  std::vector<std::uint8_t> departs_positive_, blocked_;
  Numbers ones_;
};

}  // namespace csgcast::detail
