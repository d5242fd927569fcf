// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "csg/base/error.h"

namespace csgcast {

/// Whether faces that were meant to coincide, but differ by the rounding of the scene's own numbers, become one surface
/// when a scene is compiled. The answer is then that of the welded scene. What "the same but for rounding" means is
/// derived in docs/welding.md; what does not weld stays apart, however close.
struct Welding {
  enum class Mode : unsigned char {
    off,      ///< surfaces are the same only if they are equal
    derived,  ///< also if they are equal but for rounding: of each number given, by half an ulp, and of the transforms
    by_hand,  ///< and those at most `tolerance` times the size of the scene apart over the leaves that own them
  };
  Mode mode = Mode::off;
  double tolerance = 0;            ///< of by_hand: above 0, and at most `greatest_tolerance`
  bool lists_near_misses = false;  ///< fill WeldReport::near_misses

  static constexpr double greatest_tolerance = 0x1p-7;

  static Welding derived() { return {Mode::derived, 0, false}; }
  static Welding by_hand(double relative) { return {Mode::by_hand, relative, false}; }
};

/// Two surfaces of leaves that touch or overlap, nearly the same but not welded.
struct NearMiss {
  Place first;  ///< the statements that made them
  Place second;
  double gap;  ///< how far they are apart at most over these leaves, in the scene's unit of length
};

/// What welding did.
struct WeldReport {
  std::size_t surfaces = 0;  ///< how many became another one
  std::size_t clusters = 0;  ///< how many surfaces took others in
  double widest = 0;         ///< how far one of them moved at most over its leaf, in the scene's unit of length
  /// True if the work was cut short: some surfaces that nearly coincide with very many others were left as they are.
  bool incomplete = false;
  double size = 0;                    ///< of the scene: what tolerances are relative to; without one none welds by hand
  std::size_t near_miss_count = 0;    ///< pairs of surfaces, if asked for
  std::vector<NearMiss> near_misses;  ///< the nearest of each pair of statements, nearest first; `most_near_misses`
  double suggested_tolerance =
      0;  ///< would weld the near misses up to the last jump of their gaps by more than ten; 0: none

  static constexpr std::size_t most_near_misses = 10;
};

}  // namespace csgcast
