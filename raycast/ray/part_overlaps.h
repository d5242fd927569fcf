// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "raycast/ray/caster.h"

namespace csgcast {

/// Where a ray is inside two parts at once.
struct PartOverlap {
  PartId first;  ///< of the two the one that comes first in the file
  PartId second;
  Interval common;  ///< ends as those of Caster::intervals
};

/// Where two parts are on one ray: those that only touch have nothing in common, and parts overlap here exactly if they
/// do on the exact line. Working memory of one thread.
class PartOverlaps {
 public:
  /// For each pair of parts of the caster's scene where its present ray is in both, within the span: by where they end
  /// on the ray, then in file order. At most `most` of them are listed; what is returned is how many there are. Time
  /// and memory: those of a list for each part, plus what is listed. The vector is overwritten.
  std::uint64_t find(Caster& caster, Span span, std::size_t most, std::vector<PartOverlap>& overlaps);

 private:
  struct End {
    Crossing at;
    PartId part;
    Passage passage = Passage::entry;
  };
  struct Inside {
    PartId part;
    std::size_t since = 0;  // the place of its entry among the ends
  };

  void collect(Caster& caster, Span span);
  void enter(PartId part, std::size_t end);
  Inside leave(PartId part);
  // Adds what the part that leaves there has in common with those that the ray is in.
  void list(const Inside& leaving, const Crossing& at, std::size_t most, std::vector<PartOverlap>& overlaps) const;

  IntervalList list_;
  std::vector<End> ends_;
  std::vector<Inside> inside_;        // in no order
  std::vector<std::uint32_t> place_;  // of each part that the ray is in, in inside_
};

}  // namespace csgcast
