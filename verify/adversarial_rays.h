// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "verify/scene_places.h"

namespace csgcast::verify {

/// Makes rays at which plain floating point fails, for any scene. Working memory for one thread.
class AdversarialRays {
 public:
  /// The scene must outlive it.
  explicit AdversarialRays(const Scene& scene) : places_(scene) {}

  /// The names of the kinds of rays, in order. The first kind is plain random rays; all others are hard.
  static std::span<const std::string_view> kinds();

  /// Appends up to `most` rays of a kind. There are fewer, or none, if the scene has no place for them (a ball has no
  /// edges), or if they would be out of range. The rays depend only on the scene and the random source.
  void make(std::size_t kind, Random& random, std::size_t most, std::vector<Ray>& rays);

 private:
  struct Kind;
  static const std::span<const Kind> table;

  void random_rays(Random& random);
  void edges(Random& random);
  void vertices(Random& random);
  void along_axes(Random& random);
  void in_faces(Random& random);
  void tangents(Random& random);
  void grazing(Random& random);
  void generators(Random& random);
  void centers(Random& random);
  void starting_on_surfaces(Random& random);
  void bisected(Random& random);
  void from_far_away(Random& random);
  void nudged(Random& random);
  void reversed(Random& random);
  void scaled(Random& random);

  void add(Point origin, Vector direction);
  void through(Random& random, Point p, Vector along);
  void through_corner(Random& random, std::size_t count);
  std::optional<Point> special_point(Random& random);
  std::optional<Ray> base(Random& random);
  bool see(Point eye, Vector direction, std::vector<SurfaceId>& seen);

  ScenePlaces places_;
  std::vector<Ray> made_;  // the rays made by the present call of a kind
  IntervalList list_;
  std::vector<SurfaceId> at_a_;
  std::vector<SurfaceId> seen_;
};

}  // namespace csgcast::verify
