// SPDX-License-Identifier: MIT
#include "measure/detail/extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "measure/detail/linear_cut.h"
#include "measure/detail/piece_forms.h"
#include "raycast/truth_table.h"

namespace csgcast::detail {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// In units of the space: nobody asks for more; and a solid may have a face that is bent next to nothing.
constexpr double good_enough = 0x1p-34;
constexpr std::size_t most_cuts = 20000;
// Coordinates and their sums in space are below 8 and round by less.
constexpr double rounding = 0x1p-46;

/// The point of a box about the origin farthest along a direction of those where a form is at most 0; nothing if it is
/// positive all over.
std::optional<Vector> farthest(Vector direction, const LinearForm& form, Vector half) {
  Vector d;
  std::array<std::size_t, 3> order{0, 1, 2};
  std::array<double, 3> price{};
  for (std::size_t i = 0; i < 3; ++i) {
    const bool is_up = direction[i] != 0 ? direction[i] > 0 : form.gradient[i] < 0;
    d[i] = is_up ? half[i] : -half[i];
    // What going back costs, for what it takes off the form.
    const double takes_off = is_up ? form.gradient[i] : -form.gradient[i];
    price[i] = takes_off > 0 ? std::fabs(direction[i]) / takes_off : infinity;
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return price[a] < price[b]; });
  for (const std::size_t i : order) {
    const double excess = form.at(d);
    if (!(excess > 0)) return d;
    if (std::isinf(price[i])) break;
    const double needed = excess / std::fabs(form.gradient[i]);
    d[i] += d[i] > 0 ? -std::fmin(needed, 2 * half[i]) : std::fmin(needed, 2 * half[i]);
  }
  // What is left is rounding, or it cannot be.
  const double size = std::fabs(form.value) + std::fabs(form.gradient.x) * half.x +
                      std::fabs(form.gradient.y) * half.y + std::fabs(form.gradient.z) * half.z;
  if (form.at(d) > rounding * size) return std::nullopt;
  return d;
}

/// How far a solid reaches along one direction, best first.
class Search {
 public:
  Search(const Space& space, Vector direction) : space_(space), cutter_(space), direction_(direction) {}

  /// The least and the greatest that it may be; nothing if no point was found in the solid.
  std::optional<Range> operator()() {
    add(cutter_.whole());
    for (std::size_t cuts = 0; !open_.empty() && cuts < most_cuts; ++cuts) {
      if (open_.top().most <= reached_ + good_enough) break;
      const Open open = open_.top();
      open_.pop();
      auto [lower, upper] = cutter_.cut(open.piece, open.split, middle_of(open));
      add(lower);
      add(upper);
    }
    if (std::isinf(reached_)) return std::nullopt;
    const double most = open_.empty() ? reached_ : std::fmax(reached_, open_.top().most);
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

  void add(const Piece& piece) {
    const Vector half = 0.5 * (piece.box.upper - piece.box.lower);
    const double middle = dot(direction_, 0.5 * (piece.box.upper + piece.box.lower));
    const double corner = middle + std::fabs(direction_.x) * half.x + std::fabs(direction_.y) * half.y +
                          std::fabs(direction_.z) * half.z;
    if (piece.is_constant()) {
      if (piece.value()) reached_ = std::fmax(reached_, corner - rounding);
      return;
    }
    const PieceForms forms(space_, piece);
    double most = corner;
    if (!piece.is_crowded() && forms.are_known) {
      if (is_inside(forms, piece, {})) reached_ = std::fmax(reached_, middle - rounding);
      const std::optional<double> by_surfaces = most_by_surfaces(forms, piece, middle);
      if (!by_surfaces) return;
      most = std::fmin(most, *by_surfaces);
    }
    if (most <= reached_) return;
    const std::size_t split = half.x >= half.y && half.x >= half.z ? 0 : half.y >= half.z ? 1 : 2;
    if (half[split] < 0x1p-44) return;  // its size is below what coordinates round
    open_.push({most + rounding, split, piece});
  }

  /// What the surfaces let a piece's points reach to that they all lie on one side of; nothing if there are none.
  std::optional<double> most_by_surfaces(const PieceForms& forms, const Piece& piece, double middle) {
    double most = infinity;
    for (std::size_t i = 0; i < forms.count; ++i) {
      for (const bool side : {false, true}) {
        if (restricted(piece.table, i, side) != 0) continue;
        // Inside the form is positive, or negative: turned so that it is at most 0.
        const double sign = side ? 1 : -1;
        const Range bend = forms.bend_of(forms.f[i]);
        const double off = bend.half() + forms.f[i].slack;
        const LinearForm form{sign * (forms.f[i].value + bend.middle()) - off, sign * forms.f[i].gradient};
        const std::optional<Vector> d = farthest(direction_, form, forms.half);
        if (!d) return std::nullopt;
        most = std::fmin(most, middle + dot(direction_, *d));
        try_inside(forms, piece, middle, *d, form.gradient, 4 * off);
      }
    }
    return most;
  }

  /// A point beside the farthest, a little way in, may be inside.
  void try_inside(const PieceForms& forms, const Piece& piece, double middle, Vector d, Vector gradient, double by) {
    const double squared = dot(gradient, gradient);
    if (!(squared > 0)) return;
    d = d - (by / squared) * gradient;
    for (std::size_t i = 0; i < 3; ++i) d[i] = std::clamp(d[i], -forms.half[i], forms.half[i]);
    const double reach = middle + dot(direction_, d) - rounding;
    if (reach > reached_ && is_inside(forms, piece, d)) reached_ = reach;
  }

  static bool is_inside(const PieceForms& forms, const Piece& piece, Vector d) {
    std::uint64_t table = piece.table;
    for (std::size_t i = 0; i < forms.count; ++i) {
      const LocalForm& f = forms.f[i];
      double value = f.value + dot(f.gradient, d);
      for (std::size_t k = 0; k < 6; ++k) {
        const auto [a, b] = Moments::pair[k];
        value += f.bend[k] * d[a] * d[b];
      }
      if (std::fabs(value) > 2 * f.slack) table = restricted(table, i, value > 0);
    }
    return ~table == 0;
  }

  const Space& space_;
  PieceCutter cutter_;
  Vector direction_;
  std::priority_queue<Open> open_;
  double reached_ = -infinity;
};

}  // namespace

Extent extent_of(const Space& space) {
  Extent extent;
  const auto axes = space.axes();
  const Point center = space.scene().frame().center;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vector direction{axes[0][axis], axes[1][axis], axes[2][axis]};
    const std::optional<Range> up = Search(space, direction)();
    const std::optional<Range> down = Search(space, -direction)();
    if (!up || !down) return {};
    // Scaled and moved they round by half an ulp each.
    const double error = space.scale() * (std::fmax(up->high - up->low, down->high - down->low) + rounding);
    extent.box.upper[axis] = center[axis] + space.scale() * up->high;
    extent.box.lower[axis] = center[axis] - space.scale() * down->high;
    extent.error = std::fmax(extent.error, error + 0x1p-51 * std::fabs(center[axis]));
  }
  return extent;
}

}  // namespace csgcast::detail
