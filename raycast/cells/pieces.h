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
  std::uint32_t count = 0;                              ///< of the surfaces
  std::array<std::uint32_t, most_surfaces> surfaces{};  ///< SurfaceId
  /// Whether points are inside, by the signs of the surfaces: true is positive.
  TruthTable table;
  /// What pieces are that more surfaces cross; then table and surfaces say nothing.
  struct Crowd;
  std::shared_ptr<const Crowd> crowd;

  bool is_crowded() const { return crowd != nullptr; }
  bool is_constant() const { return crowd == nullptr && count == 0; }
  /// Precondition: it is constant.
  bool value() const {
    CSGCAST_PRECONDITION(is_constant());
    return table.at(0);
  }
};

/// Cuts space into pieces; the working memory of one thread. The space must outlive it.
class PieceCutter {
 public:
  explicit PieceCutter(const Space& space);
  ~PieceCutter();
  PieceCutter(PieceCutter&&) noexcept;

  /// All of space. Precondition: it is bounded.
  Piece whole();
  /// What is below and above a place on an axis, which lies within the piece's box.
  std::pair<Piece, Piece> cut(const Piece& piece, std::size_t axis, double at);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace csgcast
