// SPDX-License-Identifier: MIT
#include "measure/search/shared_space.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "csg/base/precondition.h"
#include "measure/search/refinement.h"
#include "measure/sheet/estimate.h"
#include "measure/sheet/piece_cut.h"
#include "measure/sheet/piece_forms.h"

namespace csgcast::detail {
namespace {

constexpr std::size_t most_cuts = 6000;
constexpr int deepest = 150;
constexpr double next_to_nothing = 0x1p-36;
// Below this size, coordinates in space do not distinguish places.
constexpr double least_half = 0x1p-44;

/// A piece that may hold something.
struct Candidate {
  Piece piece;
  Estimate estimate;
  int depth = 0;
};

class PlaceSearch {
 public:
  /// `left_aside`: a piece that may hold no more than this share of its box is not cut.
  PlaceSearch(const Space& space, const LineTest& test, double left_aside)
      : space_(space), cutter_(space), test_(test), left_aside_(left_aside) {}

  SearchResult operator()() {
    add(cutter_.whole(), 0);
    // The search goes down first, into the half that probably holds more. Then it takes the largest piece that was left
    // aside.
    while (!open_.empty() && !witness_ && cuts_ < most_cuts) {
      std::pop_heap(open_.begin(), open_.end(), holds_less);
      Candidate next = std::move(open_.back());
      open_.pop_back();
      dive(std::move(next));
    }
    SearchResult result;
    result.witness = witness_;
    for (const Candidate& candidate : open_) left_over_ += volume_of(candidate.piece.box);
    const double scale = space_.scale();
    result.is_empty = !witness_ && left_over_ == 0;
    result.most_volume = left_over_ * scale * scale * scale;
    return result;
  }

 private:
  static double volume_of(const CellBox& box) {
    const Vector size = box.upper - box.lower;
    return size.x * size.y * size.z;
  }
  static double likely(const Candidate& candidate) {
    return candidate.estimate.moments.volume + candidate.estimate.volume_error;
  }
  static bool holds_less(const Candidate& a, const Candidate& b) { return likely(a) < likely(b); }

  void dive(Candidate candidate) {
    while (!witness_ && cuts_ < most_cuts) {
      const Vector half = 0.5 * (candidate.piece.box.upper - candidate.piece.box.lower);
      if (candidate.depth > deepest || std::fmax(half.x, std::fmax(half.y, half.z)) < least_half) {
        left_over_ += volume_of(candidate.piece.box);
        return;
      }
      ++cuts_;
      auto [below, above] = cut_apart(cutter_, candidate.piece, candidate.estimate.split);
      const std::size_t before = open_.size();
      add(std::move(below), candidate.depth + 1);
      add(std::move(above), candidate.depth + 1);
      const std::size_t added = open_.size() - before;
      if (added == 0 || witness_) return;
      if (added == 2 && holds_less(open_[before + 1], open_[before])) std::swap(open_[before], open_[before + 1]);
      candidate = std::move(open_.back());
      open_.pop_back();
      if (added == 2) std::push_heap(open_.begin(), open_.end(), holds_less);  // this adds the other one
    }
    open_.push_back(std::move(candidate));
    std::push_heap(open_.begin(), open_.end(), holds_less);
  }

  /// Tests a piece, and puts it behind the heap unless it holds nothing.
  void add(Piece piece, int depth) {
    if (piece.is_constant() && !piece.value()) return;
    Candidate candidate{std::move(piece), {}, depth};
    candidate.estimate = estimate(space_, candidate.piece);
    try_line(candidate);
    if (likely(candidate) <= left_aside_ * volume_of(candidate.piece.box)) {
      left_over_ += likely(candidate);
    } else {
      open_.push_back(std::move(candidate));
    }
  }

  /// Tries the line that the surfaces cross most steeply, through the middle of what probably is there.
  void try_line(const Candidate& candidate) {
    if (witness_) return;
    const PieceForms forms(space_, candidate.piece);
    const bool is_clear = !candidate.piece.is_crowded() && forms.are_known;
    const Moments& m = candidate.estimate.moments;
    Vector through = forms.middle;
    if (m.volume > 0) {
      for (std::size_t i = 0; i < 3; ++i)
        through[i] = std::clamp(m.first[i] / m.volume, candidate.piece.box.lower[i], candidate.piece.box.upper[i]);
    }
    if (is_clear && forms.surely_hold(through - forms.middle)) {
      witness_ = space_.in_scene(through);
      return;
    }
    Vector along{1, 0, 0};
    double steepest = 0;
    for (std::size_t i = 0; i < forms.count; ++i) {
      const Vector g = forms.f[i].gradient;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!(std::fabs(g[axis]) * forms.half[axis] > steepest)) continue;
        steepest = std::fabs(g[axis]) * forms.half[axis];
        along = {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
      }
    }
    witness_ = test_(space_.in_scene(through), space_.turned_back(along));
  }

  const Space& space_;
  PieceCutter cutter_;
  const LineTest& test_;
  const double left_aside_;
  std::vector<Candidate> open_;  // a heap
  std::optional<Point> witness_;
  std::size_t cuts_ = 0;
  double left_over_ = 0;
};

}  // namespace

SearchResult find_place(const Space& space, const LineTest& test) {
  CSGCAST_PRECONDITION(space.is_bounded() || space.is_empty());
  return PlaceSearch(space, test, next_to_nothing)();
}

bool is_nothing(const Space& space) {
  const LineTest none = [](Point, Vector) { return std::optional<Point>(); };
  const SearchResult found = PlaceSearch(space, none, 0)();
  return !found.witness && found.is_empty;
}

Measured volume_of(const Space& space) {
  CSGCAST_PRECONDITION(space.is_bounded() || space.is_empty());
  MeasureOptions options;
  options.relative_error = 1e-2;
  options.relative_area_error = HUGE_VAL;
  options.most_pieces = 20'000;
  const Totals totals = refine(space, options);
  const double scale = space.scale();
  return scaled(scale * scale * scale, totals.moments.volume, totals.volume_error);
}

}  // namespace csgcast::detail
