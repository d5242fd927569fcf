// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "csg/base/ids.h"
#include "csg/base/progress.h"
#include "csg/base/vector.h"
#include "raycast/cells/cells.h"
#include "raycast/packets/ray_arrays.h"

namespace csgcast {

/// A place on a solid's boundary, and the distance from there to the opposite boundary, straight in against the normal.
struct ThinPlace {
  double thickness = 0;
  Point place;
  Normal normal;  ///< unit, out of the solid
  LeafId leaf;    ///< the leaf that the face belongs to
};

/// Measures how thick a solid is where rays meet it. The ray that goes in starts on the face itself (Departure),
/// without any epsilon. Its end is certified, for the rounded place and direction. The object is the working memory of
/// one thread.
class ThicknessProbe {
 public:
  /// The cells must outlive the probe.
  explicit ThicknessProbe(const Cells& cells);
  ~ThicknessProbe();
  ThicknessProbe(ThicknessProbe&&) noexcept;

  /// For each ray, gives the thickness at the first face by which it enters. The thickness is 0 if the ray enters by
  /// none, and infinite if nothing ends the solid. Precondition: there is one number for each ray.
  void first_faces(const RayArrays& rays, std::span<double> thickness);
  /// Examines every face that the rays meet.
  void all_faces(const RayArrays& rays);

  /// The thinnest place so far that is a wall: the normal of the far face is at most 60 degrees from the way in. Near
  /// corners there is no lower limit to the thickness.
  const std::optional<ThinPlace>& thinnest() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The thinnest of the places that rays meet: `samples` x `samples` rays along each axis of the scene, evenly spread
/// over its bounds, and two places for each of their intervals. The result is no bound, because between the rays the
/// solid may be thinner. Returns nothing for a solid that is empty or unbounded. Throws Cancelled.
std::optional<ThinPlace> find_thinnest(const Cells& cells, std::size_t samples, const ProgressCallback& callback = {});

}  // namespace csgcast
