// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "csg/base/truth_table.h"
#include "measure/sheet/column_layout.h"
#include "measure/sheet/estimate.h"
#include "measure/sheet/gauss.h"

// This file handles pieces whose surfaces are sheets over a rectangle, or upright (docs/measuring.md, "Sheets").

namespace csgcast::detail {
namespace {

// The rounding of an integral's terms, relative to the greatest of them.
constexpr double rounding = 0x1p-46;

/// A vertical line through a box: runs from sheet to sheet. The integral of z^n over the inside is a sum over the ends
/// of runs: the integral up to the end, times the step there. Ends are the top and bottom of the box, and sheets.
struct Column {
  struct End {
    const SheetOfPiece* sheet = nullptr;
    int step = 0;  ///< the value above less the value below
  };
  std::array<End, Piece::most_surfaces> ends{};
  std::size_t count = 0;
  int at_top = 0;  ///< the value at the top
  int at_bottom = 0;

  std::span<const End> sheets() const { return std::span(ends).first(count); }
};

/// A side of a strip: either a curve or a side of the rectangle.
struct Side {
  const Curve* curve = nullptr;
  double x = 0;  ///< used without a curve

  double at(double y) const { return curve != nullptr ? curve->x.height() + curve->x.away_at(y, 0) : x; }
  double middle() const { return curve != nullptr ? curve->x.height() : x; }
  /// Bound on its distance from the middle for |y| <= reach. Nothing if it is not analytic there.
  std::optional<double> away(double reach) const {
    if (curve == nullptr) return 0.0;
    const Sheet::Bounds bounds = curve->x.bounds({reach, 0});
    return bounds.is_analytic() ? std::optional(bounds.away) : std::nullopt;
  }
};

class SheetEstimator {
 public:
  explicit SheetEstimator(const ColumnLayout& layout) : layout_(layout) {}

  std::optional<Estimate> operator()();

 private:
  double hx() const { return layout_.hx(); }
  double hy() const { return layout_.hy(); }
  double hz() const { return layout_.hz(); }

  bool add_range(YRange range);
  std::optional<Column> column_at(double x, double y, const Curve* wall) const;
  bool add_strip(YRange range, const Side& left, const Side& right, const Column& column);
  bool add_wall(YRange range, const Curve& curve, const Column& column);
  bool add_rule_errors(YRange range, const Side& left, const Side& right, const Column& column);
  void add_column(double x, double y, double w, const Column& column);
  void add_slacks();
  Estimate finished() const;

  const ColumnLayout& layout_;
  Moments sums_;  // about the middle; the axes are in the order x, y, up
  Estimate estimate_;
  Polydisc reach_;
  double z_reach_ = 0;
};

std::optional<Estimate> SheetEstimator::operator()() {
  for (const SheetOfPiece& sheet : layout_.sheets()) {
    if (!sheet.sheet.bounds({hx(), hy()}).is_sound()) return std::nullopt;
  }
  reach_ = {hx(), hy()};
  z_reach_ = hz();
  for (const YRange range : layout_.ranges()) {
    if (!add_range(range)) return std::nullopt;
  }
  add_slacks();
  return finished();
}

/// Adds the strips and walls of a range, from left to right.
bool SheetEstimator::add_range(YRange range) {
  const double y = 0.5 * (range.low + range.high);
  std::vector<Side> sides{{nullptr, -hx()}};
  for (const Curve& curve : layout_.curves()) {
    const Side side{&curve, 0};
    if (std::fabs(side.at(y)) < hx()) sides.push_back(side);
  }
  std::sort(sides.begin() + 1, sides.end(), [&](const Side& a, const Side& b) { return a.at(y) < b.at(y); });
  sides.push_back({nullptr, hx()});
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const double x = 0.5 * (sides[i - 1].at(y) + sides[i].at(y));
    const std::optional<Column> column = column_at(x, y, nullptr);
    if (!column || !add_strip(range, sides[i - 1], sides[i], *column)) return false;
    const Curve* const curve = sides[i].curve;
    if (curve == nullptr || !curve->wall) continue;
    const std::optional<Column> faces = column_at(sides[i].at(y), y, curve);
    if (!faces || !add_wall(range, *curve, *faces)) return false;
  }
  return true;
}

/// The content of the column at a place. At a wall, it is where the value differs on the wall's two sides. Nothing if
/// that is not certain.
std::optional<Column> SheetEstimator::column_at(double x, double y, const Curve* wall) const {
  struct Place {
    double z;
    const SheetOfPiece* sheet;
  };
  std::array<Place, Piece::most_surfaces + 1> places{};  // in ascending order
  std::size_t count = 0;
  std::size_t state = 0;  // the state of the sheets at the bottom
  for (const SheetOfPiece& sheet : layout_.sheets()) {
    const double z = sheet.sheet.height() + sheet.sheet.away_at(x, y);
    const bool is_below = z <= -hz();
    if (is_below == sheet.sheet.rises()) state |= std::size_t{1} << sheet.surface;
    if (is_below || z >= hz()) continue;
    std::size_t at = count++;
    for (; at > 0 && places[at - 1].z > z; --at) places[at] = places[at - 1];
    places[at] = {z, &sheet};
  }
  places[count] = {hz(), nullptr};
  // The value between two places. A surface without effect may pass anywhere, so any sign will do for it.
  const auto value_at = [&](double z) {
    std::size_t all = state;
    for (std::size_t i = 0; i < layout_.forms().count; ++i) {
      if (layout_.is_sheet(i) || (wall != nullptr && wall->wall == i)) continue;
      if (layout_.form_at(i, x, y, z) > 0) all |= std::size_t{1} << i;
    }
    const TruthTable& table = layout_.forms().table;
    if (wall == nullptr) return table.at(all) ? 1 : 0;
    return table.at(all) != table.at(all | std::size_t{1} << *wall->wall) ? 1 : 0;
  };
  Column column;
  column.at_bottom = value_at(0.5 * (places[0].z - hz()));
  int below = column.at_bottom;
  for (std::size_t k = 0; k < count; ++k) {
    state ^= std::size_t{1} << places[k].sheet->surface;
    const int above = value_at(0.5 * (places[k].z + places[k + 1].z));
    if (above != below) column.ends[column.count++] = {places[k].sheet, above - below};
    below = above;
  }
  column.at_top = below;
  return column;
}

/// Returns false if no ellipse is suitable.
bool SheetEstimator::add_strip(YRange range, const Side& left, const Side& right, const Column& column) {
  if (column.count == 0 && column.at_top == 0) return true;
  if (!add_rule_errors(range, left, right, column)) return false;
  const double half_height = 0.5 * (range.high - range.low);
  for (std::size_t j = 0; j < Gauss::points; ++j) {
    const double y = range.low + half_height * (1 + Gauss::node[j]);
    const double from = left.at(y);
    const double half_width = 0.5 * (right.at(y) - from);
    for (std::size_t i = 0; i < Gauss::points; ++i)
      add_column(from + half_width * (1 + Gauss::node[i]), y,
                 Gauss::weight[i] * Gauss::weight[j] * half_height * half_width, column);
  }
  return true;
}

void SheetEstimator::add_column(double x, double y, double w, const Column& column) {
  double line = (column.at_top + column.at_bottom) * hz();  // the integrals of 1, z and z²
  double line_z = (column.at_top - column.at_bottom) * hz() * hz() / 2;
  double line_zz = line * hz() * hz() / 3;
  for (const auto& [end, step] : column.sheets()) {
    const double away = end->sheet.away_at(x, y);
    const double z = end->sheet.height() + away;
    estimate_.area += w * end->sheet.area_factor(x, y, away);
    line -= step * z;
    line_z -= step * z * z / 2;
    line_zz -= step * z * z * z / 3;
  }
  sums_ += w * Moments{line,
                       {x * line, y * line, line_z},
                       {x * x * line, y * y * line, line_zz, x * y * line, x * line_z, y * line_z}};
}

/// Bounds the error of the rule over a strip. The error of the integral of z² is at most that of z times the greatest
/// |z|, and so on. `reach_` and `z_reach_` are the greatest |x|, |y|, |z| for which that is valid.
bool SheetEstimator::add_rule_errors(YRange range, const Side& left, const Side& right, const Column& column) {
  const bool is_rectangle = left.curve == nullptr && right.curve == nullptr;
  const double half_height = 0.5 * (range.high - range.low);
  double least = HUGE_VAL;
  double area_error = 0;
  Polydisc disc;
  double z_reach = 0;
  for (const double rho : Gauss::ellipses) {
    const double stretch = Gauss::reach(rho);
    Polydisc r{0, 0.5 * std::fabs(range.low + range.high) + half_height * stretch};
    const std::optional<double> left_away = left.away(r.y);
    const std::optional<double> right_away = right.away(r.y);
    if (!left_away || !right_away) continue;
    const double half_width = 0.5 * (std::fabs(right.middle() - left.middle()) + *left_away + *right_away);
    r.x = 0.5 * (std::fabs(right.middle() + left.middle()) + *left_away + *right_away) + stretch * half_width;
    // Over a rectangle, terms that do not depend on x and y are integrated exactly.
    double height = is_rectangle ? 0 : (column.at_top + column.at_bottom) * hz();
    double area_factor = 0;
    double z = hz();
    bool is_analytic = true;
    for (const auto& [end, step] : column.sheets()) {
      const Sheet::Bounds bounds = end->sheet.bounds(r);
      const auto gradient = bounds.is_analytic() ? end->sheet.analytic_gradient(r, bounds.away) : std::nullopt;
      is_analytic = is_analytic && gradient;
      if (!is_analytic) break;
      height += bounds.away + (is_rectangle ? 0 : std::fabs(end->sheet.height()));
      area_factor += *gradient / std::sqrt(bounds.discriminant);
      z = std::fmax(z, std::fabs(end->sheet.height()) + bounds.away);
    }
    if (!is_analytic) continue;
    const double rule = 4 * Gauss::error(rho) * half_height * half_width;
    if (!(rule * height < least)) continue;
    least = rule * height;
    area_error = rule * area_factor;
    disc = r;
    z_reach = z;
  }
  if (!std::isfinite(least)) return false;
  reach_ = {std::fmax(reach_.x, disc.x), std::fmax(reach_.y, disc.y)};
  z_reach_ = std::fmax(z_reach_, z_reach);
  estimate_.volume_error += least;
  estimate_.area_error += area_error;
  return true;
}

/// Adds the faces of an upright surface along a curve, where the column says that the value changes.
bool SheetEstimator::add_wall(YRange range, const Curve& curve, const Column& column) {
  if (column.count == 0 && column.at_top == 0) return true;
  const double half_height = 0.5 * (range.high - range.low);
  double least = HUGE_VAL;
  for (const double rho : Gauss::ellipses) {
    const double y = 0.5 * std::fabs(range.low + range.high) + half_height * Gauss::reach(rho);
    const Sheet::Bounds along = curve.x.bounds({y, 0});
    if (!along.is_analytic()) continue;
    const auto gradient = curve.x.analytic_gradient({y, 0}, along.away);
    if (!gradient) continue;
    double height = (column.at_top + column.at_bottom) * hz();
    bool is_analytic = true;
    for (const auto& [end, step] : column.sheets()) {
      const Sheet::Bounds bounds = end->sheet.bounds({std::fabs(curve.x.height()) + along.away, y});
      is_analytic = is_analytic && bounds.is_analytic();
      height += std::fabs(end->sheet.height()) + bounds.away;
    }
    if (!is_analytic) continue;
    // This is half the range's length times the error in one direction.
    least = std::fmin(least, half_height * Gauss::error(rho) * height * *gradient / std::sqrt(along.discriminant));
  }
  if (!std::isfinite(least)) return false;
  estimate_.area_error += least;
  for (std::size_t j = 0; j < Gauss::points; ++j) {
    const double y = range.low + half_height * (1 + Gauss::node[j]);
    const double away = curve.x.away_at(y, 0);
    const double x = curve.x.height() + away;
    double line = (column.at_top + column.at_bottom) * hz();
    for (const auto& [end, step] : column.sheets()) line -= step * (end->sheet.height() + end->sheet.away_at(x, y));
    estimate_.area += Gauss::weight[j] * half_height * line * curve.x.area_factor(y, 0, away);
  }
  return true;
}

/// Adds the errors of the forms, which move and turn sheets and curves, and the rounding of sums.
void SheetEstimator::add_slacks() {
  const double projection = 4 * hx() * hy();
  const double least_side = std::fmin(hx(), std::fmin(hy(), hz()));
  // The slope of a polynomial of second degree is at most 4 / h times its greatest value (Markov).
  const double markov = 4 * std::sqrt(3.0) / least_side;
  double steepest = 0;  // the ratios of area to projected area, summed over the sheets
  double lifted = 0;    // the displacement of the sheets
  for (const auto& [surface, sheet, least_slope] : layout_.sheets()) {
    const double displaced = sheet.slack() / least_slope;
    const double steep = sheet.greatest_gradient({hx(), hy()}, std::fabs(sheet.height()) + hz()) / least_slope;
    const double turned_by = 2 * steep * (markov + sheet.greatest_bend() / least_slope);
    steepest += steep;
    lifted += displaced;
    estimate_.volume_error += projection * (2 * displaced + rounding * z_reach_);
    estimate_.area_error += projection * (rounding * steep + turned_by * displaced);
  }
  for (const Curve& curve : layout_.curves()) {
    const double displaced = curve.form.slack / curve.least_slope + rounding * hx();
    const double steep = curve.x.greatest_gradient({hy(), 0}, std::fabs(curve.x.height()) + hx()) / curve.least_slope;
    const double turned_by = 2 * steep * (markov + curve.x.greatest_bend() / curve.least_slope);
    estimate_.volume_error += 8 * hy() * hz() * displaced;
    estimate_.area_error += 4 * hy() * displaced * steepest;
    if (curve.wall)
      estimate_.area_error += 4 * hy() * (hz() * (rounding * steep + turned_by * displaced) + steep * lifted);
  }
}

Estimate SheetEstimator::finished() const {
  const auto [x, y, up] = layout_.axes();
  const std::array<std::size_t, 3> axis{x, y, up};
  const Vector middle = layout_.forms().middle;
  Moments about_middle;
  about_middle.volume = sums_.volume;
  for (std::size_t i = 0; i < 3; ++i) about_middle.first[axis[i]] = sums_.first[i];
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [i, j] = Moments::pair[k];
    about_middle.second[Moments::of_axes(axis[i], axis[j])] = sums_.second[k];
  }
  Estimate e = estimate_;
  e.moments = moved(about_middle, middle);
  e.reach[x] = std::fabs(middle[x]) + reach_.x;
  e.reach[y] = std::fabs(middle[y]) + reach_.y;
  e.reach[up] = std::fabs(middle[up]) + z_reach_;
  return e;
}

}  // namespace

std::optional<Estimate> sheet_estimate(const PieceForms& forms) {
  // The axis along which the surfaces are most nearly level comes first.
  std::array<double, 3> level{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  for (std::size_t i = 0; i < forms.count; ++i) {
    const Vector g = forms.f[i].gradient;
    const double size = std::sqrt(dot(g, g));
    for (std::size_t axis = 0; axis < 3; ++axis)
      level[axis] = std::fmin(level[axis], std::fabs(g[axis]) / (size > 0 ? size : 1));
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return level[a] > level[b]; });
  std::optional<Estimate> best;
  for (const std::size_t up : order) {
    for (const bool swaps : {false, true}) {
      const std::size_t a = (up + 1) % 3;
      const std::size_t b = (up + 2) % 3;
      ColumnLayout layout(forms, swaps ? Sheet::Axes{b, a, up} : Sheet::Axes{a, b, up});
      if (!layout.find()) continue;
      const std::optional<Estimate> e = SheetEstimator(layout)();
      if (e && (!best || e->volume_error < best->volume_error)) best = e;
      if (best && best->volume_error < 0x1p-30 * forms.volume()) return best;
    }
  }
  return best;
}

}  // namespace csgcast::detail
