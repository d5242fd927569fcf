// SPDX-License-Identifier: MIT
#include "measure/sheet/estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "csg/base/truth_table.h"

namespace csgcast::detail {
namespace {

// The rounding of a tetrahedron's volume, in units of the product of the box's half sides, and of a triangle's area, in
// units of the square of the longest half side (docs/measuring.md).
constexpr double rounding = 0x1p-46;

double longest_side(Vector half) { return std::fmax(half.x, std::fmax(half.y, half.z)); }

std::size_t longest_axis(Vector half) { return half.x >= half.y && half.x >= half.z ? 0 : half.y >= half.z ? 1 : 2; }

double surface_of(Vector half) { return 8 * (half.x * half.y + half.y * half.z + half.z * half.x); }

Vector greatest_coordinates(const PieceForms& forms) {
  Vector reach;
  for (std::size_t axis = 0; axis < 3; ++axis) reach[axis] = std::fabs(forms.middle[axis]) + forms.half[axis];
  return reach;
}

// Upper bound on the share of a box, or of its projection along an axis, in which a linear form is within `off` of 0.
double share_near(Vector gradient, Vector half, double off) {
  double most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) most = std::fmax(most, std::fabs(gradient[axis]) * half[axis]);
  return off < most ? off / most : 1;
}

// Upper bound on the area of all surfaces in the box. A plane meets a line once, a quadric twice. Source: Cauchy and
// Crofton.
double greatest_area(const PieceForms& forms) {
  double surfaces = 0;
  for (std::size_t i = 0; i < forms.count; ++i) surfaces += forms.is_plane[i] ? 0.5 : 1;
  return surfaces * surface_of(forms.half);
}

// Only that the solid's part is between nothing and everything is known.
Estimate unknown(const PieceForms& forms, double most_area) {
  Estimate e;
  e.moments = moved(0.5 * box_moments(forms.half), forms.middle);
  e.volume_error = 0.5 * forms.volume();
  e.area = e.area_error = 0.5 * most_area;
  e.reach = greatest_coordinates(forms);
  return e;
}

// The axis along which a cut straightens the surfaces most.
std::size_t bending_axis(const PieceForms& forms) {
  Vector bends;
  for (std::size_t i = 0; i < forms.count; ++i) {
    const LocalForm& f = forms.f[i];
    double slope = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      slope = std::fmax(slope, std::fabs(f.gradient[axis]) * forms.half[axis]);
    const Range bend = forms.bend_of(f);
    const double share = 1 / (slope + bend.half() + f.slack);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t j = 0; j < 3; ++j)
        bends[axis] += share * std::fabs(bend_along(f, axis, j)) * forms.half[axis] * forms.half[j];
    }
  }
  // If they bend alike, the longest side is cut, but never along an axis on which nothing changes.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bends[axis] += 1e-3 * forms.half[axis] / longest_side(forms.half);
    bool changes = false;
    for (std::size_t i = 0; i < forms.count; ++i) {
      changes = changes || forms.f[i].gradient[axis] != 0;
      for (std::size_t j = 0; j < 3; ++j) changes = changes || bend_along(forms.f[i], axis, j) != 0;
    }
    if (!changes) bends[axis] = -1;
  }
  return longest_axis(bends);
}

}  // namespace

Estimate estimate(const Space& space, const Piece& piece) {
  const PieceForms forms(space, piece);
  if (piece.is_constant()) {
    Estimate e;
    if (piece.value()) e.moments = moved(box_moments(forms.half), forms.middle);
    return e;
  }
  Estimate result;
  if (piece.is_crowded() || !forms.are_known) {
    // This bound, too, is by Cauchy and Crofton.
    std::uint64_t crossings = piece.crowd_crossings;
    if (!piece.is_crowded()) {
      for (std::size_t i = 0; i < piece.count; ++i) crossings += space.most_crossings(piece.surfaces[i]);
    }
    result = unknown(forms, surface_of(forms.half) * (0.5 * static_cast<double>(crossings)));
    result.split = longest_axis(forms.half);
    return result;
  }
  const bool all_planes = std::all_of(forms.is_plane.begin(), forms.is_plane.begin() + static_cast<long>(forms.count),
                                      [](bool is) { return is; });
  std::optional<Estimate> sheets;
  if (!all_planes) sheets = sheet_estimate(forms);
  result = sheets ? *sheets : linear_estimate(forms);
  const double most_area = greatest_area(forms);
  if (!(result.area_error < 0.5 * most_area)) result.area = result.area_error = 0.5 * most_area;
  result.split = bending_axis(forms);
  return result;
}

namespace {

/// Bounds the area of one surface's faces in a piece whose surfaces are replaced by planes.
class FaceArea {
 public:
  FaceArea(const PieceForms& forms, std::span<const LinearForm> planes, std::span<const double> off)
      : forms_(forms), planes_(planes), off_(off) {}

  /// `area` is the area of the plane's faces. Returns the true area, and a bound on its error.
  std::pair<double, double> operator()(std::size_t i, double area) const {
    const Vector g = planes_[i].gradient;
    const Vector h = forms_.half;
    std::size_t axis = 0;
    for (std::size_t a = 1; a < 3; ++a) {
      if (std::fabs(g[a]) > std::fabs(g[axis])) axis = a;
    }
    const double most = surface_of(h) * (forms_.is_plane[i] ? 0.5 : 1);
    const Range slope = forms_.slope_of(forms_.f[i], axis);
    if (!(slope.low > 0 || slope.high < 0)) return {0.5 * most, 0.5 * most};
    const double least_slope = std::fmin(std::fabs(slope.low), std::fabs(slope.high));
    const double most_slope = std::fmax(std::fabs(slope.low), std::fabs(slope.high));
    double low = 1, high = 1, here = 1;  // the squares of the ratio of area to projected area
    for (std::size_t a = 0; a < 3; ++a) {
      if (a == axis) continue;
      const Range other = forms_.slope_of(forms_.f[i], a);
      const double least = other.low > 0 ? other.low : other.high < 0 ? -other.high : 0;
      const double greatest = std::fmax(std::fabs(other.low), std::fabs(other.high));
      low += square(least / most_slope);
      high += square(greatest / least_slope);
      here += square(g[a] / g[axis]);
    }
    const double factor = std::sqrt(here);
    const double projection = 4 * h[(axis + 1) % 3] * h[(axis + 2) % 3];
    const double displaced = projection * strips(i, axis, off_[i] / least_slope);
    const double projected = std::fmin(area / factor, projection);
    const double change = std::fmax(std::sqrt(high) - factor, factor - std::sqrt(low));
    const double error = std::sqrt(high) * displaced + projected * change;
    if (error > most) return {0.5 * most, 0.5 * most};
    return {area, error};
  }

 private:
  static double square(double x) { return x * x; }

  /// The share of the projection in which it is open whether the sheet is there and is a face. `away` bounds the
  /// sheet's distance from its plane along the axis.
  double strips(std::size_t i, std::size_t axis, double away) const {
    const Vector g = planes_[i].gradient;
    const Vector h = forms_.half;
    double share = 0;
    const auto add = [&](LinearForm on_plane, double off) {
      on_plane.gradient[axis] = 0;
      double reach = 0;
      for (std::size_t a = 0; a < 3; ++a) reach += std::fabs(on_plane.gradient[a]) * h[a];
      if (std::fabs(on_plane.value) <= reach + off) share += share_near(on_plane.gradient, h, off);
    };
    // This is the plane's height above the middle: -(value + the rest of the gradient) / g.
    const LinearForm height{-planes_[i].value / g[axis], (-1 / g[axis]) * g};
    add({height.value - h[axis], height.gradient}, away);
    add({height.value + h[axis], height.gradient}, away);
    for (std::size_t j = 0; j < forms_.count; ++j) {
      if (j == i) continue;
      const double slope = planes_[j].gradient[axis];
      add({planes_[j].value + slope * height.value, planes_[j].gradient + slope * height.gradient},
          off_[j] + std::fabs(slope) * away);
    }
    return std::fmin(share, 1);
  }

  const PieceForms& forms_;
  std::span<const LinearForm> planes_;
  std::span<const double> off_;
};

}  // namespace

Estimate linear_estimate(const PieceForms& forms) {
  std::array<LinearForm, Piece::most_surfaces> planes{};
  std::array<double, Piece::most_surfaces> off{};  // the distance of the forms from the planes
  double share = 0;
  for (std::size_t i = 0; i < forms.count; ++i) {
    const LocalForm& f = forms.f[i];
    const Range bend = forms.bend_of(f);
    planes[i] = {f.value + bend.middle(), f.gradient};
    off[i] = bend.half() + f.slack;
    share += share_near(f.gradient, forms.half, off[i]);
  }
  if (share >= 1) return unknown(forms, greatest_area(forms));
  const std::span<const LinearForm> all(planes.data(), forms.count);
  const LinearCut cut = cut_linearly(all, forms.table, forms.half);
  Estimate e;
  e.moments = moved(cut.moments, forms.middle);
  e.volume_error = (share + rounding * static_cast<double>(1 + cut.tetrahedra)) * forms.volume();
  e.reach = greatest_coordinates(forms);
  const FaceArea face_area(forms, all, std::span(off.data(), forms.count));
  for (std::size_t i = 0; i < forms.count; ++i) {
    const auto [area, error] = face_area(i, cut.areas[i]);
    e.area += area;
    e.area_error += error;
  }
  const double longest = longest_side(forms.half);
  e.area_error += rounding * static_cast<double>(1 + cut.triangles) * longest * longest;
  return e;
}

}  // namespace csgcast::detail
