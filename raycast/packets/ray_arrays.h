// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace csgcast {

/// Rays as arrays with one number for each ray, in the scene's coordinates. They must be within Ray::in_range. All
/// arrays are as long as origin[0], except that optional arrays may be empty.
struct RayArrays {
  std::array<std::span<const double>, 3> origin{};
  std::array<std::span<const double>, 3> direction{};
  std::span<const std::uint32_t> departure{};  ///< the surface that each ray starts on (Departure); empty: none does
  std::span<const std::uint8_t> departs_positive{};  ///< 1 if the ray goes to the surface's positive side, else 0
  bool whole_line = false;                           ///< true: rays start at -infinity, not at 0; then no ray departs
  std::span<const double> end{};                     ///< the t up to which each ray is asked; empty: infinity

  std::size_t count() const { return origin[0].size(); }
};

/// The first crossings of rays with the solid's boundary. Each array has room for at least one number for each ray. An
/// optional array that is empty is not filled.
struct HitArrays {
  enum State : std::uint8_t { none, entry, exit };

  std::span<std::uint8_t> state{};      ///< if there is no hit, the other numbers mean nothing
  std::span<double> t{};                ///< Crossing::t
  std::span<std::uint32_t> surface{};   ///< SurfaceId
  std::span<std::uint8_t> root{};       ///< Crossing::root; may be empty if t is not rounded
  std::span<std::uint8_t> is_inside{};  ///< 1: the ray starts inside the solid, else 0; may be empty
};

/// The faces at these crossings.
struct FaceArrays : HitArrays {
  std::array<std::span<double>, 3> point{};   ///< Attribution::point
  std::array<std::span<double>, 3> normal{};  ///< unit, out of the solid
  std::span<std::uint32_t> look{};            ///< LookId
  std::span<std::uint8_t> comes_positive{};   ///< 1 if Attribution::front is the positive side, else 0
  std::span<std::uint32_t> leaf{};            ///< LeafId; may be empty
};

}  // namespace csgcast
