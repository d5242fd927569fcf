// SPDX-License-Identifier: MIT
#include "measure/search/extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "csg/base/precondition.h"
#include "csg/base/truth_table.h"
#include "measure/search/farthest.h"
#include "measure/sheet/piece_forms.h"

namespace csgcast::detail {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// In units of the space. Nobody needs a smaller error, and a face of a solid may be nearly flat.
constexpr double good_enough = 0x1p-34;
constexpr std::size_t most_cuts = 20000;
constexpr std::size_t cuts_between_dives = 64;
constexpr double least_half = 0x1p-44;  // coordinates round by this much
// Coordinates in space and their sums are below 8, and round by less than this.
constexpr double rounding = 0x1p-46;

/// Finds how far a solid reaches along one direction. The most promising pieces come first.
class Search {
 public:
  Search(const Space& space, Vector direction) : space_(space), cutter_(space), direction_(direction) {}

  /// The least and the greatest possible reach. Nothing if the solid is empty.
  std::optional<Range> operator()() {
    if (const std::optional<Open> whole = opened(cutter_.whole())) open_.push(*whole);
    while (!open_.empty() && cuts_ < most_cuts && open_.top().most > std::fmax(reached_, left_) + good_enough) {
      Open open = open_.top();
      open_.pop();
      if (cuts_ % cuts_between_dives == 0) {
        dive(std::move(open));
      } else {
        for (const std::optional<Open>& half : cut(open)) {
          if (half) open_.push(*half);
        }
      }
    }
    double most = std::fmax(reached_, left_);
    if (!open_.empty()) most = std::fmax(most, open_.top().most);
    if (std::isinf(most)) return std::nullopt;
    return Range{reached_, most + rounding};
  }

 private:
  struct Open {
    double most = 0;  // no point of the solid in the piece is farther
    std::size_t split = 0;
    Piece piece;
    friend bool operator<(const Open& a, const Open& b) { return a.most < b.most; }
  };

  static double middle_of(const Open& open) {
    return 0.5 * (open.piece.box.lower[open.split] + open.piece.box.upper[open.split]);
  }

  /// Cuts a piece. What may reach farther than what is known remains of its halves.
  std::array<std::optional<Open>, 2> cut(const Open& open) {
    ++cuts_;
    auto [lower, upper] = cutter_.cut(open.piece, open.split, middle_of(open));
    std::optional<Open> first = opened(lower);
    return {std::move(first), opened(upper)};
  }

  /// Follows the more promising half, again and again, to a point that is certainly inside. Where a solid is thin,
  /// pieces must be as small as that, and there are very many.
  void dive(Open open) {
    constexpr std::size_t most_dive = 160;
    for (std::size_t i = 0; i < most_dive && cuts_ < most_cuts; ++i) {
      const double before = reached_;
      auto [first, second] = cut(open);
      if (first && second && first->most < second->most) std::swap(first, second);
      if (!first) std::swap(first, second);
      if (second) open_.push(*std::move(second));
      if (!first) return;
      open = *std::move(first);
      if (reached_ > before) break;
    }
    open_.push(std::move(open));
  }

  /// What a piece may reach; nothing if that is no farther than what is known.
  std::optional<Open> opened(const Piece& piece) {
    const Vector half = 0.5 * (piece.box.upper - piece.box.lower);
    const double middle = dot(direction_, 0.5 * (piece.box.upper + piece.box.lower));
    const double corner =
        middle + std::fabs(direction_.x) * half.x + std::fabs(direction_.y) * half.y + std::fabs(direction_.z) * half.z;
    if (piece.is_constant()) {
      if (piece.value()) reached_ = std::fmax(reached_, corner - rounding);
      return std::nullopt;
    }
    const PieceForms forms(space_, piece);
    double most = corner;
    if (!piece.is_crowded() && forms.are_known) {
      if (middle > reached_ && forms.surely_hold({})) reached_ = middle - rounding;
      const std::optional<double> by_planes = most_by_planes(forms, middle);
      if (!by_planes) return std::nullopt;
      most = std::fmin(most, *by_planes + rounding);
    }
    const std::size_t split = half.x >= half.y && half.x >= half.z ? 0 : half.y >= half.z ? 1 : 2;
    if (half[split] < least_half) {
      left_ = std::fmax(left_, most);  // cutting it further is not worthwhile
      return std::nullopt;
    }
    return most > reached_ ? std::optional<Open>({most, split, piece}) : std::nullopt;
  }

  /// Bounds how far a piece's points may reach beyond what is known to be reached. Nothing if there are no such points.
  std::optional<double> most_by_planes(const PieceForms& forms, double middle) {
    std::array<LinearForm, Piece::most_surfaces> planes{};
    std::array<double, Piece::most_surfaces> off{};
    for (std::size_t i = 0; i < forms.count; ++i) {
      const LocalForm& f = forms.f[i];
      const Range bend = forms.bend_of(f);
      planes[i] = {f.value + bend.middle(), f.gradient};
      off[i] = bend.half() + 2 * f.slack;  // this also covers the rounding of cuts
    }
    const auto corner = farthest_corner(std::span(planes).first(forms.count), std::span(off).first(forms.count),
                                        forms.table, forms.half, direction_, reached_ - middle);
    if (!corner) return std::nullopt;
    // A point a little further in may be certain to be inside.
    for (int exponent = -40; exponent <= -2; exponent += 2) {
      const Vector d = corner->place + std::ldexp(1.0, exponent) * (corner->inner - corner->place);
      const double reach = middle + dot(direction_, d) - rounding;
      if (reach <= reached_) break;
      if (!forms.surely_hold(d)) continue;
      reached_ = reach;
      break;
    }
    return middle + corner->reach;
  }

  const Space& space_;
  PieceCutter cutter_;
  Vector direction_;
  std::priority_queue<Open> open_;
  std::size_t cuts_ = 0;
  double reached_ = -infinity;  // the reach of a point that is certainly inside
  double left_ = -infinity;     // the reach of pieces that were given up
};

}  // namespace

Extent extent_of(const Space& space) {
  CSGCAST_PRECONDITION(space.is_bounded() || space.is_empty());
  Extent extent;
  const auto axes = space.axes();
  const Point center = space.scene().frame().center;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vector direction{axes[0][axis], axes[1][axis], axes[2][axis]};
    const std::optional<Range> up = Search(space, direction)();
    const std::optional<Range> down = Search(space, -direction)();
    if (!up || !down) return {};
    extent.box.upper[axis] = center[axis] + space.scale() * up->high;
    extent.box.lower[axis] = center[axis] - space.scale() * down->high;
    // If no point is known to be inside, the solid may be anywhere between the two sides.
    const double width = up->high + down->high;
    const double gap = std::fmin(width, std::fmax(up->high - up->low, down->high - down->low));
    // When they are scaled and moved, they round by half an ulp each.
    extent.error = std::fmax(extent.error, space.scale() * (gap + rounding) + 0x1p-51 * std::fabs(center[axis]));
  }
  return extent;
}

}  // namespace csgcast::detail
