// SPDX-License-Identifier: MIT
#include "measure/section/section_arcs.h"

#include <cmath>
#include <optional>
#include <queue>
#include <utility>

#include "csg/base/precondition.h"
#include "measure/sheet/column_layout.h"
#include "measure/sheet/piece_cut.h"
#include "measure/sheet/piece_forms.h"

namespace csgcast::detail {
namespace {

// Corners smaller than this, in units of the space, are not cut any more.
constexpr double least_corner = 0x1p-38;
constexpr std::size_t pieces_between_looks = 256;

/// Finds the arcs in the pieces of a section's space. It cuts pieces in which curves cross.
class Tracer {
 public:
  explicit Tracer(const Space& space) : space_(space), cutter_(space) {}

  ArcTrace operator()(std::size_t most_pieces, const std::function<void()>& look_up) {
    open_.push(sized(cutter_.whole()));
    for (std::size_t pieces = 0; !open_.empty(); ++pieces) {
      if (pieces % pieces_between_looks == 0) look_up();
      const Sized next = open_.top();
      open_.pop();
      const Piece& piece = next.piece;
      if (piece.is_constant() || add_arcs(piece)) continue;
      if (next.size < least_corner || pieces > most_pieces) {
        trace_.corners.push_back(piece.box);
        continue;
      }
      const Vector size = piece.box.upper - piece.box.lower;
      const std::size_t axis = size.x >= size.y ? 0 : 1;
      auto [below, above] = cut_across(cutter_, piece, axis);
      open_.push(sized(std::move(below)));
      open_.push(sized(std::move(above)));
    }
    return std::move(trace_);
  }

 private:
  struct Sized {
    double size;
    Piece piece;
    friend bool operator<(const Sized& a, const Sized& b) { return a.size < b.size; }
  };

  static Sized sized(Piece piece) {
    const Vector size = piece.box.upper - piece.box.lower;
    return {std::fmax(size.x, size.y), std::move(piece)};
  }

  /// Returns false if the piece must be cut.
  bool add_arcs(const Piece& piece) {
    if (piece.is_crowded()) return false;
    const PieceForms forms(space_, piece);
    if (!forms.are_known) return false;
    for (const bool swaps : {false, true}) {
      ColumnLayout layout(forms, swaps ? Sheet::Axes{1, 0, 2} : Sheet::Axes{0, 1, 2});
      if (!layout.find() || !layout.sheets().empty()) continue;
      for (const YRange range : layout.ranges()) {
        for (const Curve& curve : layout.curves()) add_arc(layout, curve, range);
      }
      return true;
    }
    return false;
  }

  void add_arc(const ColumnLayout& layout, const Curve& curve, YRange range) {
    const auto x_at = [&](double y) { return curve.x.height() + curve.x.away_at(y, 0); };
    const double y = 0.5 * (range.low + range.high);
    if (!(std::fabs(x_at(y)) < layout.hx())) return;
    const PieceForms& forms = layout.forms();
    std::size_t state = 0;
    for (std::size_t i = 0; i < forms.count; ++i) {
      if (i != *curve.wall && layout.form_at(i, x_at(y), y, 0) > 0) state |= std::size_t{1} << i;
    }
    const std::size_t positive = state | std::size_t{1} << *curve.wall;
    if (forms.table.at(state) == forms.table.at(positive)) return;
    const bool is_inside_right = forms.table.at(positive) == curve.x.rises();
    const auto [ax, ay, up] = layout.axes();
    const auto place = [&](double at) {
      Planar p{};
      p[ax] = forms.middle[ax] + x_at(at);
      p[ay] = forms.middle[ay] + at;
      return p;
    };
    Arc arc{place(range.low), place(y), place(range.high), forms.surface[*curve.wall]};
    // For an arc that goes up along y, the left side is towards lower x, if x and y are right-handed.
    if (is_inside_right == (ax == 0)) std::swap(arc.from, arc.to);
    trace_.arcs.push_back(arc);
    trace_.displaced = std::fmax(trace_.displaced, curve.form.slack / curve.least_slope);
  }

  const Space& space_;
  PieceCutter cutter_;
  std::priority_queue<Sized> open_;
  ArcTrace trace_;
};

}  // namespace

ArcTrace trace_arcs(const Space& space, std::size_t most_pieces, const std::function<void()>& look_up) {
  CSGCAST_PRECONDITION(space.is_bounded() || space.is_empty());
  return Tracer(space)(most_pieces, look_up);
}

}  // namespace csgcast::detail
