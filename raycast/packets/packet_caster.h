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

/// The interval lists of many rays. The intervals of ray i are intervals[offsets[i]] to intervals[offsets[i + 1]],
/// exclusive.
struct IntervalBatch {
  std::vector<Interval> intervals;
  std::vector<EndFace> faces;        ///< the faces at the entry and the exit of each interval; empty if not asked for
  std::vector<std::size_t> offsets;  ///< rays + 1

  std::span<const Interval> of(std::size_t ray) const {
    return std::span(intervals).subspan(offsets[ray], offsets[ray + 1] - offsets[ray]);
  }
};

/// Answers many rays at once, with a ray in each lane of the machine's vector registers. The answers are the same as
/// Caster's, to the last bit. The caster is correct for any rays, and fast if rays next to each other in the arrays
/// have similar directions. Rays that lanes cannot decide go to a Caster, one by one.
///
/// The working memory of one thread.
class PacketCaster {
 public:
  /// The number of rays that share a register.
  enum class Width : std::uint8_t { packet, single };

  /// The cells must outlive the caster. `instructions` is one of instruction_sets(); an empty name means the best one.
  explicit PacketCaster(const Cells& cells, Width width = Width::packet, std::string_view instructions = {});
  ~PacketCaster();
  PacketCaster(PacketCaster&&) noexcept;

  /// The instruction sets that this machine has, the best first.
  static std::vector<std::string_view> instruction_sets();
  /// Throws Error(usage) for a name that is neither empty nor one of them.
  static void check_instructions(std::string_view name);

  const Scene& scene() const;

  /// The first crossing of each ray between 0 and its end: Caster::first_hit. Rays may depart from surfaces, as in
  /// Caster::begin. Rounding::close is several times as fast; then t is what double gives (docs/accuracy.md), not the
  /// nearest double.
  void first_hits(const RayArrays& rays, const HitArrays& hits, Rounding rounding = Rounding::nearest);
  /// For each ray: 1 if it meets the inside of the solid, else 0, as Caster::any_hit. Precondition: there is room for
  /// as many numbers as rays.
  void any_hits(const RayArrays& rays, std::span<std::uint8_t> hits);
  /// Says what is reported about the ends of intervals.
  enum class Ends : std::uint8_t {
    bare,   ///< the crossings only
    looks,  ///< also what the faces there show, as Caster::attribute tells it; the leaf only if it is known anyway
    faces,  ///< also the leaves that own the faces, and the normals
  };
  /// All intervals of each ray: Caster::intervals. The batch is overwritten.
  void intervals(const RayArrays& rays, IntervalBatch& batch, Rounding rounding = Rounding::nearest,
                 Ends ends = Ends::bare);
  /// The results of Caster::first_hit and attribute, for pictures. t is that of Rounding::close.
  void first_faces(const RayArrays& rays, const FaceArrays& faces);

  /// The same for rays in [0, infinity), or in a span. Precondition: there are as many hits as rays.
  void first_hits(std::span<const Ray> rays, std::span<std::optional<Hit>> hits, Rounding rounding = Rounding::nearest);
  void any_hits(std::span<const Ray> rays, std::span<std::uint8_t> hits);
  void intervals(std::span<const Ray> rays, IntervalBatch& batch, Span span = {}, Rounding rounding = Rounding::nearest,
                 Ends ends = Ends::bare);

  /// The same with pointers (detail/caster_pointers.h), for callers that cast rays one by one and for which checks and
  /// copies of arrays are too slow. The preconditions are those of the arrays.
  struct RayPointers;
  struct FacePointers;
  void first_faces(const RayPointers& rays, const FacePointers& faces);
  void intervals(const RayPointers& rays, IntervalBatch& batch, Rounding rounding, Ends ends);

  /// The places in the arrays of the last call's rays that lanes could not decide and left to the caster.
  std::span<const std::uint32_t> left_to_caster() const;

  PacketCounts counts() const;
  /// The work done for rays that were left to the caster.
  CasterCounts caster_counts() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace csgcast
