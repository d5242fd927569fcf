// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raycast/ray/caster.h"

namespace csgcast {

/// A stretch of a ray that is inside two parts at once.
struct PartOverlap {
  PartId first;  ///< the part that comes first in the file
  PartId second;
  Interval common;  ///< its ends are like those of Caster::intervals
};

/// Finds the stretches of a ray that are inside two parts at once. Parts that only touch do not overlap. Two parts
/// overlap here exactly if they do on the exact line. The object holds the working memory of one thread.
class PartOverlaps {
 public:
  /// Lists the stretches of the caster's present ray that are inside both of two parts, within the span. Overlaps are
  /// sorted by where they end on the ray, then in file order. At most `most` are listed; the total number is returned.
  /// Time and memory are those of an interval list for each part, plus what is listed. The vector is overwritten.
  std::uint64_t find(Caster& caster, Span span, std::size_t most, std::vector<PartOverlap>& overlaps);

 private:
  struct End {
    Crossing at;
    PartId part;
    Passage passage = Passage::entry;
  };
  struct Inside {
    PartId part;
    std::size_t since = 0;  // the index of its entry in ends_
  };

  void collect(Caster& caster, Span span);
  void enter(PartId part, std::size_t end);
  Inside leave(PartId part);
  // Adds the overlaps of a part that the ray leaves at a crossing with the parts that the ray is still in.
  void list(const Inside& leaving, const Crossing& at, std::size_t most, std::vector<PartOverlap>& overlaps) const;

  IntervalList list_;
  std::vector<End> ends_;
  std::vector<Inside> inside_;        // the parts that the ray is in, in no order
  std::vector<std::uint32_t> place_;  // by part: where it stands in inside_, if the ray is in it
};

}  // namespace csgcast
