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

/// A box of a solid's space, with the tree's value in it as a function of the sides of the few surfaces that cross it.
struct Piece {
  static constexpr std::size_t most_surfaces = TruthTable::most_values;

  CellBox box;
  std::uint32_t count = 0;                              ///< the number of surfaces
  std::array<std::uint32_t, most_surfaces> surfaces{};  ///< SurfaceId
  /// Tells if points are inside, by the signs of the surfaces. The value true stands for a positive sign.
  TruthTable table;
  /// Set if the piece is a crowd, else null. A crowd is a piece that more surfaces cross, or in which a leaf is open
  /// (LeafFunction). A crowd's formula is stored here, and its table and surfaces mean nothing.
  struct Crowd;
  std::shared_ptr<const Crowd> crowd;

  /// Upper bound on the number of crossings of a line with the surfaces of a crowd.
  std::uint64_t crowd_crossings = 0;

  bool is_crowded() const { return crowd != nullptr; }
  bool is_constant() const { return crowd == nullptr && count == 0; }
  /// Precondition: the piece is constant.
  bool value() const {
    CSGCAST_PRECONDITION(is_constant());
    return table.at(0);
  }
};

/// Cuts a space into pieces. The space must outlive this. Working memory of one thread.
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
