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

/// A place on a solid's boundary, and how far it is from there straight in, against the normal, to the boundary again.
struct ThinPlace {
  double thickness = 0;
  Point place;
  Normal normal;  ///< unit, out of the solid
  LeafId leaf;    ///< whose face it is
};

/// Tells how thick a solid is where rays meet it. The ray that goes in starts on the face itself (Departure), with no
/// epsilon; where it ends is certified, for the place and direction as they were rounded. The working memory of one
/// thread.
class ThicknessProbe {
 public:
  /// The cells must outlive the probe.
  explicit ThicknessProbe(const Cells& cells);
  ~ThicknessProbe();
  ThicknessProbe(ThicknessProbe&&) noexcept;

  /// Tells the thickness at the first face that each ray enters by: 0 where it enters by none, infinite where nothing
  /// ends the solid. Precondition: as many numbers as rays.
  void first_faces(const RayArrays& rays, std::span<double> thickness);
  /// Looks at every face that the rays meet.
  void all_faces(const RayArrays& rays);

  /// The thinnest place so far that is a wall: the far face is at most 60 degrees from square to the way in. Towards
  /// corners solids are as thin as one likes.
  const std::optional<ThinPlace>& thinnest() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The thinnest of the places that `samples` x `samples` rays along each axis of the scene, evenly spread over its
/// bounds, meet, two for each of their intervals. No bound: between the rays the solid may be thinner. Nothing for a
/// solid that is empty or unbounded. Throws Cancelled.
std::optional<ThinPlace> find_thinnest(const Cells& cells, std::size_t samples, const ProgressCallback& callback = {});

}  // namespace csgcast
