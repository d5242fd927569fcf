// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "raycast/cells/cells.h"
#include "raycast/packets/packet_counts.h"
#include "raycast/packets/ray_arrays.h"
#include "raycast/ray/caster.h"

namespace csgcast {

/// The interval lists of many rays: those of ray i are intervals[offsets[i]] to intervals[offsets[i + 1]], exclusive.
struct IntervalBatch {
  std::vector<Interval> intervals;
  std::vector<EndFace> faces;        ///< of the entry and the exit of each interval; empty if they were not asked for
  std::vector<std::size_t> offsets;  ///< rays + 1

  std::span<const Interval> of(std::size_t ray) const {
    return std::span(intervals).subspan(offsets[ray], offsets[ray + 1] - offsets[ray]);
  }
};

/// Answers many rays at once, a ray in each lane of the machine's vector registers: the same answers as Caster's, to
/// the last bit. Fast for rays that go about the same way, next to each other in the span; right for any. Rays that
/// lanes cannot decide go to a Caster, one by one.
///
/// The working memory of one thread.
class PacketCaster {
 public:
  /// How many rays share a register.
  enum class Width : std::uint8_t { packet, single };

  /// The cells must outlive the caster. `instructions`: one of instruction_sets(); by default the best.
  explicit PacketCaster(const Cells& cells, Width width = Width::packet, std::string_view instructions = {});
  ~PacketCaster();
  PacketCaster(PacketCaster&&) noexcept;

  /// Those that this machine has, the best first.
  static std::vector<std::string_view> instruction_sets();
  /// Throws Error(usage) for a name that is neither empty nor one of them.
  static void check_instructions(std::string_view name);

  const Scene& scene() const;

  /// The first crossing of each ray from 0 to its end: Caster::first_hit. Rays that depart are not asked for it.
  /// Rounding::close is several times as fast: then t is what double gives (docs/accuracy.md), not the nearest one.
  void first_hits(const RayArrays& rays, const HitArrays& hits, Rounding rounding = Rounding::nearest);
  /// 1 if a ray meets the inside of the solid, else 0: Caster::any_hit. Precondition: room for as many as rays.
  void any_hits(const RayArrays& rays, std::span<std::uint8_t> hits);
  /// What is told of the ends of intervals.
  enum class Ends : std::uint8_t {
    bare,   ///< the crossings
    looks,  ///< and what the faces there show, as Caster::attribute tells it; the leaf only where that is known anyway
    faces,  ///< and whose they are, and their normals
  };
  /// All intervals of each ray: Caster::intervals. Overwrites the batch.
  void intervals(const RayArrays& rays, IntervalBatch& batch, Rounding rounding = Rounding::nearest,
                 Ends ends = Ends::bare);
  /// What Caster::first_hit and attribute say, for pictures. t: Rounding::close.
  void first_faces(const RayArrays& rays, const FaceArrays& faces);

  /// The same for rays in [0, infinity), or in a span. Precondition: as many hits as rays.
  void first_hits(std::span<const Ray> rays, std::span<std::optional<Hit>> hits, Rounding rounding = Rounding::nearest);
  void any_hits(std::span<const Ray> rays, std::span<std::uint8_t> hits);
  void intervals(std::span<const Ray> rays, IntervalBatch& batch, Span span = {}, Rounding rounding = Rounding::nearest,
                 Ends ends = Ends::bare);

  /// The same as pointers (detail/caster_pointers.h): for callers that cast rays one by one, where the checks and
  /// copies of arrays are too slow. Preconditions: those of the arrays.
  struct RayPointers;
  struct FacePointers;
  void first_faces(const RayPointers& rays, const FacePointers& faces);
  void intervals(const RayPointers& rays, IntervalBatch& batch, Rounding rounding, Ends ends);

  /// The rays of the last call that lanes could not decide, and that went to the caster: their places in the arrays.
  std::span<const std::uint32_t> left_to_caster() const;

  PacketCounts counts() const;
  /// What the rays cost that were left to it.
  CasterCounts caster_counts() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace csgcast
