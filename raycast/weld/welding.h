// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "csg/base/error.h"

namespace csgcast {

/// Says how compile() treats faces that were meant to coincide but differ by the rounding of the scene's own numbers.
/// Welded faces become one surface, and the answer is that of the welded scene. Faces that do not weld stay apart,
/// however close they are. docs/welding.md derives what counts as equal up to rounding.
struct Welding {
  enum class Mode : unsigned char {
    off,      ///< surfaces weld only if they are equal
    derived,  ///< also if they are equal up to the rounding of each given number by half an ulp, and of transforms
    by_hand,  ///< also if they are at most `tolerance` times the scene's size apart over the leaves that own them
  };
  Mode mode = Mode::off;
  double tolerance = 0;            ///< for by_hand: above 0, and at most `greatest_tolerance`
  bool lists_near_misses = false;  ///< if true, WeldReport::near_misses is filled

  static constexpr double greatest_tolerance = 0x1p-7;

  static Welding derived() { return {Mode::derived, 0, false}; }
  static Welding by_hand(double relative) { return {Mode::by_hand, relative, false}; }
};

/// Two surfaces of leaves that touch or overlap. They are nearly the same, but were not welded.
struct NearMiss {
  Place first;  ///< the statements that made the two surfaces
  Place second;
  double gap;  ///< the greatest distance between the two over these leaves, in the scene's unit of length
};

/// What welding did.
struct WeldReport {
  std::size_t surfaces = 0;  ///< the number of surfaces that became another one
  std::size_t clusters = 0;  ///< the number of surfaces that took others in
  double widest = 0;         ///< the farthest that a surface moved over its leaf, in the scene's unit of length
  /// True if the work was cut short: some surfaces that nearly coincide with very many others were left as they are.
  bool incomplete = false;
  /// The size of the scene, to which tolerances are relative. 0 if the scene has none; then nothing is welded by hand.
  double size = 0;
  std::size_t near_miss_count = 0;  ///< the number of pairs of surfaces, if near misses were asked for
  /// The nearest miss of each pair of statements, nearest first. At most `most_near_misses` are listed.
  std::vector<NearMiss> near_misses;
  /// A tolerance that would weld the near misses up to the last jump of their gaps by a factor of more than ten. 0 if
  /// there is no such jump.
  double suggested_tolerance = 0;

  static constexpr std::size_t most_near_misses = 10;
};

}  // namespace csgcast
