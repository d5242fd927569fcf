// SPDX-License-Identifier: MIT
#pragma once

#include "raycast/ray/caster.h"

namespace csgcast::test {

Solid scaled(const Solid& solid, double factor);
Point scaled(Point p, double factor);

/// A scene and the same scene larger by a power of two, asked the same.
class Twins {
 public:
  /// Both scenes must outlive the twins.
  Twins(const Scene& scene, const Scene& large, double factor) : factor_(factor), plain_(scene), large_(large) {}

  /// Whether a ray of the scene and the same ray of the large one get the same answers: lists on the whole line and
  /// from the origin, with the attribution of each end, first hit and any hit. If the direction grows with the scene
  /// every t is the same, else it grows, bit by bit.
  bool agree(const Ray& ray, bool direction_grows);
  /// Whether a point has the same location and part.
  bool agree(Point p);
  /// Whether both casters did the same work so far: every count is equal.
  bool worked_alike() const;

 private:
  bool same(const Crossing& a, const Crossing& b) const;
  bool same_face(const Crossing& a, const Crossing& b, Passage passage);
  bool same_lists(Span span);
  bool same_first_hit();

  double factor_;
  double times_ = 1;  ///< what t grows by
  Caster plain_;
  Caster large_;
  IntervalList list_;
  IntervalList large_list_;
};

}  // namespace csgcast::test
