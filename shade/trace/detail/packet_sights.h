// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "raycast/packets/packet_caster.h"
#include "shade/film/camera.h"
#include "shade/film/samples.h"
#include "shade/trace/detail/face_buffers.h"
#include "shade/trace/detail/sight.h"
#include "shade/trace/report.h"

namespace csgcast::detail {

struct ShadingCode;

/// What many samples of a picture see without light: the same as look_along and length_inside, bit for bit. The working
/// memory of one thread.
class PacketSights {
 public:
  /// Both must outlive it. Precondition: camera.rays_are_in_range().
  PacketSights(const Cells& cells, const Camera& camera, std::string_view instructions);

  /// What each sample sees goes where it belongs.
  void look(const Samples& samples, std::span<Sight> sights);
  /// How long each sample's ray is inside the solid.
  void measure(const Samples& samples, std::span<double> lengths);

  RenderReport report() const;

 private:
  RayArrays rays_of(const Samples& samples, std::size_t first);
  Sight sight(std::size_t i) const;

  const Scene& scene_;
  const Camera& camera_;
  const ShadingCode& code_;
  PacketCaster caster_;
  std::uint64_t primary_ = 0;
  Vectors origin_, direction_;
  FaceBuffers faces_;
  std::vector<std::uint32_t> leaf_;
  IntervalBatch intervals_;
};

}  // namespace csgcast::detail
