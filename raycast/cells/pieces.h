// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "csg/base/precondition.h"
#include "csg/base/truth_table.h"
#include "raycast/cells/space.h"

namespace csgcast {

/// A box of a solid's space with what the tree comes to in it, as a function of the sides of the few surfaces that
/// cross it.
struct Piece {
  static constexpr std::size_t most_surfaces = TruthTable::most_values;

  CellBox box;
  std::uint32_t count = 0;                              ///< the number of surfaces
  std::array<std::uint32_t, most_surfaces> surfaces{};  ///< SurfaceId
  /// Tells if points are inside, by the signs of the surfaces: true is positive.
  TruthTable table;
  /// Of a crowd: a piece that more surfaces cross, or in which a leaf is open (LeafFunction). A crowd's formula is kept
  /// here, and its table and surfaces say nothing. Else null.
  struct Crowd;
  std::shared_ptr<const Crowd> crowd;

  /// At most so often a line meets the surfaces of a crowd.
  std::uint64_t crowd_crossings = 0;

  bool is_crowded() const { return crowd != nullptr; }
  bool is_constant() const { return crowd == nullptr && count == 0; }
  /// Precondition: the piece is constant.
  bool value() const {
    CSGCAST_PRECONDITION(is_constant());
    return table.at(0);
  }
};

/// Cuts a space, which must outlive this, into pieces. Working memory of one thread.
class PieceCutter {
 public:
  explicit PieceCutter(const Space& space);
  ~PieceCutter();
  PieceCutter(PieceCutter&&) noexcept;

  /// The whole space as one piece. Precondition: the space is bounded.
  Piece whole();
  /// The parts of a piece below and above a place on an axis. Precondition: the place lies within the piece's box.
  std::pair<Piece, Piece> cut(const Piece& piece, std::size_t axis, double at);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace csgcast
