// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "measure/sheet/piece_forms.h"
#include "measure/sheet/sheet.h"
#include "raycast/cells/pieces.h"

namespace csgcast::detail {

/// A surface that is one sheet over the rectangle of a piece's box.
struct SheetOfPiece {
  std::size_t surface = 0;  ///< the index of the surface in the piece
  Sheet sheet;
  double least_slope = 0;  ///< |df/dz| in the box
};

/// A curve x(y) in the rectangle at which the columns change. There a sheet leaves the box by its top or bottom, two
/// sheets cross, or a surface stands upright.
struct Curve {
  LocalForm form;
  std::optional<std::size_t> wall;  ///< the surface that stands upright on the curve
  Sheet x;                          ///< over y
  double least_slope = 0;           ///< |df/dx| in the rectangle
};

/// A part of a piece's columns, [low, high] in y, in which no curve begins or ends.
struct YRange {
  double low = 0;
  double high = 0;
};

/// Divides a piece into columns over a rectangle (docs/measuring.md, "Sheets"). Each surface must be a sheet or
/// upright. All changes from column to column must be along curves that do not cross each other.
class ColumnLayout {
 public:
  ColumnLayout(const PieceForms& forms, Sheet::Axes axes) : forms_(forms), axes_(axes) {}

  /// Returns false if the piece is not like that.
  bool find();

  const std::vector<SheetOfPiece>& sheets() const { return sheets_; }
  const std::vector<Curve>& curves() const { return curves_; }
  /// The ranges. A range ends where a curve meets a side of the rectangle.
  std::vector<YRange> ranges() const;

  double hx() const { return forms_.half[axes_.x]; }
  double hy() const { return forms_.half[axes_.y]; }
  double hz() const { return forms_.half[axes_.up]; }
  /// A surface's form at a point.
  double form_at(std::size_t surface, double x, double y, double z) const;
  const PieceForms& forms() const { return forms_; }
  Sheet::Axes axes() const { return axes_; }
  bool is_sheet(std::size_t surface) const { return kind_[surface] == Kind::sheet; }

 private:
  enum class Kind : std::uint8_t { sheet, upright, without_effect };

  bool find_surfaces();
  bool find_crossings();
  bool has_no_effect(std::size_t i) const;
  int side_of_box(const LocalForm& form) const;
  int side_along(const LocalForm& f, const LocalForm& g) const;
  LocalForm at_height(const LocalForm& form, double z) const;
  std::optional<LocalForm> crossing(const LocalForm& f, const LocalForm& g) const;
  LocalForm on_plane(const LocalForm& form, const LocalForm& plane) const;
  bool add_curve(const LocalForm& form, std::optional<std::size_t> wall);

  const PieceForms& forms_;
  Sheet::Axes axes_;
  std::array<Kind, Piece::most_surfaces> kind_{};
  std::vector<SheetOfPiece> sheets_;
  std::vector<Curve> curves_;
};

}  // namespace csgcast::detail
