// SPDX-License-Identifier: MIT
#include "measure/search/refinement.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "csg/base/precondition.h"
#include "measure/sheet/piece_cut.h"

namespace csgcast::detail {
namespace {

/// A sum of many numbers, nearly as exact as if it were rounded only once. Source: Neumaier.
class Sum {
 public:
  void add(double x) {
    const double next = sum_ + x;
    rest_ += std::fabs(sum_) >= std::fabs(x) ? (sum_ - next) + x : (x - next) + sum_;
    sum_ = next;
  }
  double value() const { return sum_ + rest_; }

 private:
  double sum_ = 0;
  double rest_ = 0;
};

double volume_of(const CellBox& box) {
  const Vector size = box.upper - box.lower;
  return size.x * size.y * size.z;
}

/// A piece that may be cut further, and its estimate.
struct Part {
  Piece piece;
  Estimate estimate;
};

struct Sums {
  Sum volume, area, volume_error, area_error;
  std::array<Sum, 3> first;
  std::array<Sum, 6> second;

  void add(const Estimate& e, double sign = 1) {
    volume.add(sign * e.moments.volume);
    area.add(sign * e.area);
    volume_error.add(sign * e.volume_error);
    area_error.add(sign * e.area_error);
    for (std::size_t i = 0; i < 3; ++i) first[i].add(sign * e.moments.first[i]);
    for (std::size_t i = 0; i < 6; ++i) second[i].add(sign * e.moments.second[i]);
  }
};

class Refinement {
 public:
  Refinement(const Space& space, const MeasureOptions& options, const std::function<void(const Progress&)>& tell)
      : space_(space), options_(options), tell_(tell), cutters_([this] { return PieceCutter(space_); }) {}

  Totals run() {
    Part whole{cutters_.local().whole(), {}};
    whole.estimate = estimate(space_, whole.piece);
    keep(std::move(whole));
    do {
      // Where faces nearly coincide, or are not resolved yet, a cut makes areas less certain.
      if (area_error() < least_area_error_) {
        least_area_error_ = area_error();
        best_area_ = now_.area.value();
      }
    } while (!is_as_asked() && is_worth_more() && refine());
    return totals();
  }

 private:
  // At most this many parts are cut side by side, and no more than make up this share of the error.
  static constexpr std::size_t most_at_once = 4096;
  static constexpr double share_at_once = 0.25;
  static constexpr std::size_t pieces_of_leaf = 512;

  struct Ranked {
    double blame;
    std::uint32_t part;
    friend bool operator<(const Ranked& a, const Ranked& b) {
      return a.blame != b.blame ? a.blame < b.blame : a.part > b.part;
    }
  };

  void keep(Part part) {
    ++pieces_;
    now_.add(part.estimate);
    const Estimate& e = part.estimate;
    if (e.volume_error == 0 && e.area_error == 0) return certain_.add(e);  // such a part needs no place of its own
    std::uint32_t at = static_cast<std::uint32_t>(parts_.size());
    if (free_.empty()) {
      parts_.emplace_back();
    } else {
      at = free_.back();
      free_.pop_back();
    }
    ranking_.push_back({blame(e), at});
    std::push_heap(ranking_.begin(), ranking_.end());
    parts_[at] = std::move(part);
  }

  double volume_error() const { return std::fmax(now_.volume_error.value(), 0); }
  double area_error() const { return std::fmax(now_.area_error.value(), 0); }
  bool volume_is_as_asked() const {
    return volume_error() <= options_.relative_error * (std::fabs(now_.volume.value()) - volume_error());
  }
  bool area_is_as_asked() const {
    if (std::isinf(options_.relative_area_error)) return true;
    return area_error() <= options_.relative_area_error * (now_.area.value() - area_error());
  }
  bool is_as_asked() const { return ranking_.empty() || (volume_is_as_asked() && area_is_as_asked()); }

  /// The share of a part in the error that is still too large. The area counts in proportion to its error, compared
  /// with the solid's.
  double blame(const Estimate& e) const {
    return (blames_volume_ ? e.volume_error : 0) + (blames_area_ ? area_weight_ * e.area_error : 0);
  }

  /// The ranking changes when either volume or area reaches its target. The area gets a weight that makes the two
  /// errors comparable.
  void rank_again() {
    const bool volume = !volume_is_as_asked();
    const bool area = !area_is_as_asked();
    if (volume == blames_volume_ && area == blames_area_ && pieces_ < 2 * ranked_at_) return;
    blames_volume_ = volume;
    blames_area_ = area;
    ranked_at_ = pieces_;
    area_weight_ = volume ? volume_error() / area_error() : 1;
    if (!volume) last_error_ = HUGE_VAL;
    for (Ranked& ranked : ranking_) ranked.blame = blame(parts_[ranked.part].estimate);
    std::make_heap(ranking_.begin(), ranking_.end());
  }

  /// False if cuts have improved next to nothing for a long time. Then only rounding is left, or the solid has no
  /// volume, or faces nearly coincide. With many leaves it takes many pieces before any leaf is resolved.
  bool is_worth_more() {
    rank_again();
    const double error = blames_volume_ ? volume_error() : area_error();
    if (volume_error() <= 0x1p-160 * volume_of(space_.box())) return false;
    if (error < 0.9 * last_error_) {
      last_error_ = error;
      pieces_then_ = pieces_;
    }
    return pieces_ <= 4 * pieces_then_ + 16384 + pieces_of_leaf * space_.scene().leaves().size();
  }

  /// The relative error. For a value of zero it is infinite, unless the value is certain.
  static double relative(double error, double value) { return error == 0 ? 0 : error / std::fabs(value); }

  /// The progress from an error of 1 to the error that was asked for, counted in digits.
  static double share_done(double error, double asked) {
    if (!(asked < 1)) return 1;
    return std::clamp(std::log(std::fmin(error, 1)) / std::log(asked), 0.0, 1.0);
  }

  /// The smaller of the shares of volume and area.
  Progress progress() const {
    const double error = relative(volume_error(), now_.volume.value());
    const double volume = share_done(error, options_.relative_error);
    const double area = share_done(relative(area_error(), now_.area.value()), options_.relative_area_error);
    return {std::fmin(volume, area), error};
  }

  /// Cuts the parts with the largest share in the error. Returns false if there would be too many parts, or the caller
  /// has had enough.
  bool refine() {
    const Progress now = progress();
    tell_(now);
    if (options_.is_enough && options_.is_enough(*now.relative_error)) return false;
    const double all = (blames_volume_ ? volume_error() : 0) + (blames_area_ ? area_weight_ * area_error() : 0);
    std::vector<std::uint32_t> chosen;
    for (double sum = 0; !ranking_.empty() && sum < share_at_once * all && chosen.size() < most_at_once;) {
      std::pop_heap(ranking_.begin(), ranking_.end());
      sum += ranking_.back().blame;
      chosen.push_back(ranking_.back().part);
      ranking_.pop_back();
    }
    if (pieces_ + chosen.size() > options_.most_pieces) {
      for (const std::uint32_t part : chosen) ranking_.push_back({0, part});
      return false;
    }
    std::vector<std::array<Part, 2>> halves(chosen.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chosen.size(), 16), [&](const auto& range) {
      PieceCutter& cutter = cutters_.local();
      for (std::size_t k = range.begin(); k != range.end(); ++k) {
        const Part& part = parts_[chosen[k]];
        auto [lower, upper] = cut(cutter, part);
        halves[k][0].piece = std::move(lower);
        halves[k][1].piece = std::move(upper);
        for (Part& half : halves[k]) half.estimate = estimate(space_, half.piece);
      }
    });
    for (const std::uint32_t part : chosen) {
      now_.add(parts_[part].estimate, -1);
      parts_[part] = {};
      free_.push_back(part);
      --pieces_;
    }
    for (auto& pair : halves) {
      for (Part& half : pair) keep(std::move(half));
    }
    return true;
  }

  /// Crowded pieces are cut across the axis that is best for that, for example for layers side by side.
  static std::pair<Piece, Piece> cut(PieceCutter& cutter, const Part& part) {
    return part.piece.is_crowded() ? cut_apart(cutter, part.piece, part.estimate.split)
                                   : cut_across(cutter, part.piece, part.estimate.split);
  }

  // Sums the parts anew, not what was added and taken away on the way.
  Totals totals() {
    Sums sums = certain_;
    Totals result;
    std::sort(ranking_.begin(), ranking_.end(), [](const Ranked& a, const Ranked& b) { return a.part < b.part; });
    for (const Ranked& ranked : ranking_) {
      const Estimate& e = parts_[ranked.part].estimate;
      sums.add(e);
      for (std::size_t i = 0; i < 3; ++i) result.first_error[i] += e.volume_error * e.reach[i];
      for (std::size_t k = 0; k < 6; ++k) {
        const auto [i, j] = Moments::pair[k];
        result.second_error[k] += e.volume_error * e.reach[i] * e.reach[j];
      }
    }
    result.volume_error = sums.volume_error.value();
    result.area_error = sums.area_error.value();
    result.moments.volume = sums.volume.value();
    result.area = sums.area.value();
    if (least_area_error_ < result.area_error) {
      result.area = best_area_;
      result.area_error = least_area_error_ + 0x1p-40 * best_area_;
    }
    for (std::size_t i = 0; i < 3; ++i) result.moments.first[i] = sums.first[i].value();
    for (std::size_t i = 0; i < 6; ++i) result.moments.second[i] = sums.second[i].value();
    result.pieces = pieces_;
    const bool asks_for_area = !std::isinf(options_.relative_area_error) && !ranking_.empty();
    const bool area_is_fine =
        !asks_for_area || result.area_error <= options_.relative_area_error * (result.area - result.area_error);
    result.is_as_asked = ranking_.empty() || (volume_is_as_asked() && area_is_fine);
    return result;
  }

  const Space& space_;
  const MeasureOptions& options_;
  const std::function<void(const Progress&)>& tell_;
  tbb::enumerable_thread_specific<PieceCutter> cutters_;
  std::vector<Part> parts_;
  std::vector<std::uint32_t> free_;  // vacant places in parts_
  std::vector<Ranked> ranking_;      // a heap of the other places
  Sums certain_;
  Sums now_;
  std::size_t pieces_ = 0;
  bool blames_volume_ = true;
  bool blames_area_ = false;
  double area_weight_ = 0;
  std::size_t ranked_at_ = 0;
  double last_error_ = HUGE_VAL;
  double least_area_error_ = HUGE_VAL;
  double best_area_ = 0;
  std::size_t pieces_then_ = 0;
};

}  // namespace

Measured scaled(double factor, double value, double error) {
  Measured result{factor * value, factor * (1 + 0x1p-20) * (error + 0x1p-46 * std::fabs(value))};
  if (!std::isfinite(result.value) || !std::isfinite(result.error)) result.error = HUGE_VAL;
  if (value != 0 || error != 0) result.error += 4 * std::numeric_limits<double>::denorm_min();
  return result;
}

Totals refine(const Space& space, const MeasureOptions& options, const std::function<void(const Progress&)>& tell) {
  CSGCAST_PRECONDITION(space.is_bounded() || space.is_empty());
  return Refinement(space, options, tell).run();
}

}  // namespace csgcast::detail
