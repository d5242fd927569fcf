// SPDX-License-Identifier: MIT
#include "measure/sheet/column_layout.h"

#include <algorithm>
#include <cmath>

#include "csg/base/truth_table.h"

namespace csgcast::detail {
namespace {

// g less the multiple of f that makes the rest most nearly constant, with lengths in units of a box's half sides. Where
// f is 0, the result is g.
LocalForm less_multiple(const LocalForm& f, const LocalForm& g, double s) {
  LocalForm rest;
  rest.value = g.value - s * f.value;
  rest.gradient = g.gradient - s * f.gradient;
  for (std::size_t k = 0; k < 6; ++k) rest.bend[k] = g.bend[k] - s * f.bend[k];
  // The differences round by less than the reserve of the slacks, which are 2^-46 of all terms.
  rest.slack = g.slack + std::fabs(s) * f.slack;
  return rest;
}

// Adds the roots of c + b t + a t² in (-reach, reach).
void add_roots(double a, double b, double c, double reach, std::vector<double>& roots) {
  const auto add = [&](double t) {
    if (std::fabs(t) < reach) roots.push_back(t);
  };
  const double d = b * b - 4 * a * c;
  // If a curve touches, or just misses, it may really touch. So there is an end as well.
  if (a != 0 && std::fabs(d) <= 0x1p-40 * (b * b + 4 * std::fabs(a * c))) add(-0.5 * b / a);
  if (!(d >= 0)) return;
  const double q = -0.5 * (b + std::copysign(std::sqrt(d), b));
  if (q == 0) return;
  add(c / q);
  if (a != 0) add(q / a);
}

}  // namespace

bool ColumnLayout::find() { return find_surfaces() && find_crossings(); }

bool ColumnLayout::find_surfaces() {
  for (std::size_t i = 0; i < forms_.count; ++i) {
    const LocalForm& form = forms_.f[i];
    // This is the part that does not depend on z.
    LocalForm flat = at_height(form, 0);
    const LocalForm rest = less_multiple(flat, form, 1);
    const Range bend = forms_.bend_of(rest);
    const double change = std::fabs(rest.gradient[axes_.up]) * hz() + std::fmax(bend.high, -bend.low);
    const Range slope = forms_.slope_of(form, axes_.up);
    if (change <= form.slack) {
      flat.slack += change;
      kind_[i] = Kind::upright;
      if (!add_curve(flat, i)) return false;
    } else if (has_no_effect(i)) {
      kind_[i] = Kind::without_effect;
    } else if (slope.low > 0 || slope.high < 0) {
      kind_[i] = Kind::sheet;
      sheets_.push_back({i, Sheet(form, axes_), std::fmin(std::fabs(slope.low), std::fabs(slope.high))});
      if (!sheets_.back().sheet.exists()) return false;
    } else {
      return false;
    }
  }
  return true;
}

// Finds where sheets leave the box or cross each other.
bool ColumnLayout::find_crossings() {
  for (std::size_t k = 0; k < sheets_.size(); ++k) {
    const LocalForm& f = forms_.f[sheets_[k].surface];
    if (!add_curve(at_height(f, hz()), {}) || !add_curve(at_height(f, -hz()), {})) return false;
    for (std::size_t l = k + 1; l < sheets_.size(); ++l) {
      const LocalForm& g = forms_.f[sheets_[l].surface];
      if (side_along(f, g) != 0 || side_along(g, f) != 0) continue;
      const std::optional<LocalForm> form = crossing(f, g);
      if (!form || !add_curve(*form, {})) return false;
    }
  }
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    for (std::size_t l = k + 1; l < curves_.size(); ++l) {
      if (side_along(curves_[k].form, curves_[l].form) == 0 && side_along(curves_[l].form, curves_[k].form) == 0)
        return false;
    }
  }
  return true;
}

/// Returns false if the form may be 0 in the rectangle, but not along a single curve x(y).
bool ColumnLayout::add_curve(const LocalForm& form, std::optional<std::size_t> wall) {
  if (side_of_box(form) != 0) return true;
  const Range slope = forms_.slope_of(form, axes_.x);
  if (!(slope.low > 0 || slope.high < 0)) return false;
  const Curve curve{form, wall, Sheet(form, {axes_.y, axes_.up, axes_.x}),
                    std::fmin(std::fabs(slope.low), std::fabs(slope.high))};
  if (!curve.x.exists() || !curve.x.bounds({hy(), 0}).is_sound()) return false;
  curves_.push_back(curve);
  return true;
}

/// True if the value is the same on both sides of surface i everywhere.
bool ColumnLayout::has_no_effect(std::size_t i) const {
  TruthTable table = forms_.table;
  for (std::size_t j = 0; j < forms_.count; ++j) {
    if (j == i || !table.depends_on(j)) continue;
    const int side = side_along(forms_.f[i], forms_.f[j]);
    if (side != 0) table = table.with(j, side > 0);
  }
  return !table.depends_on(i);
}

/// The sign of a form in the whole box; 0 if it is open.
int ColumnLayout::side_of_box(const LocalForm& form) const {
  const Range bend = forms_.bend_of(form);
  double reach = form.slack;
  for (std::size_t axis = 0; axis < 3; ++axis) reach += std::fabs(form.gradient[axis]) * forms_.half[axis];
  if (form.value + bend.low - reach > 0) return 1;
  if (form.value + bend.high + reach < 0) return -1;
  return 0;
}

/// The sign of g wherever f is 0 in the box; 0 if it is open.
int ColumnLayout::side_along(const LocalForm& f, const LocalForm& g) const {
  double product = 0;
  double squares = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double h = forms_.half[axis];
    product += f.gradient[axis] * h * g.gradient[axis] * h;
    squares += f.gradient[axis] * h * f.gradient[axis] * h;
  }
  return side_of_box(less_multiple(f, g, squares > 0 ? product / squares : 0));
}

/// The form at one height. It no longer depends on z.
LocalForm ColumnLayout::at_height(const LocalForm& form, double z) const {
  LocalForm flat = form;
  const std::size_t up = axes_.up;
  flat.value += (form.gradient[up] + bend_along(form, up, up) * z) * z;
  flat.gradient[up] = 0;
  flat.bend[Moments::of_axes(up, up)] = 0;
  for (const std::size_t axis : {axes_.x, axes_.y}) {
    flat.gradient[axis] += bend_along(form, axis, up) * z;
    flat.bend[Moments::of_axes(axis, up)] = 0;
  }
  return flat;
}

/// The curve above which two sheets cross, if it is a conic. It is one if one of them is a plane, or if the two have
/// the same terms of second degree up to a factor: then they meet in a plane.
std::optional<LocalForm> ColumnLayout::crossing(const LocalForm& f, const LocalForm& g) const {
  const auto is_flat = [&](const LocalForm& form) {
    const Range bend = forms_.bend_of(form);
    return bend.high - bend.low <= form.slack;
  };
  if (is_flat(g)) return on_plane(f, g);
  if (is_flat(f)) return on_plane(g, f);
  std::size_t greatest = 0;
  for (std::size_t k = 1; k < 6; ++k) {
    if (std::fabs(f.bend[k]) > std::fabs(f.bend[greatest])) greatest = k;
  }
  const LocalForm radical = less_multiple(f, g, g.bend[greatest] / f.bend[greatest]);
  if (!is_flat(radical)) return std::nullopt;
  const Range slope = forms_.slope_of(radical, axes_.up);
  if (slope.low > 0 || slope.high < 0) return on_plane(f, radical);
  return std::nullopt;
}

/// A form on a plane that is not upright: z = p + q x + r y is substituted.
LocalForm ColumnLayout::on_plane(const LocalForm& form, const LocalForm& plane) const {
  const auto [x, y, up] = axes_;
  const double n = plane.gradient[up];
  const double p = -plane.value / n;
  const double q = -plane.gradient[x] / n;
  const double r = -plane.gradient[y] / n;
  const double a = bend_along(form, up, up);
  const double xz = bend_along(form, x, up);
  const double yz = bend_along(form, y, up);
  LocalForm flat = at_height(form, p);
  const double slope = form.gradient[up] + 2 * a * p;
  flat.gradient[x] += slope * q;
  flat.gradient[y] += slope * r;
  flat.bend[Moments::of_axes(x, x)] += (a * q + xz) * q;
  flat.bend[Moments::of_axes(y, y)] += (a * r + yz) * r;
  flat.bend[Moments::of_axes(x, y)] += 2 * a * q * r + xz * r + yz * q;
  // The plane may be off by its slack and its bend, which moves z. In addition, the sums round.
  const Range bend = forms_.bend_of(plane);
  const double reach = std::fabs(p) + std::fabs(q) * hx() + std::fabs(r) * hy();
  const double steep =
      std::fabs(form.gradient[up]) + 2 * std::fabs(a) * reach + std::fabs(xz) * hx() + std::fabs(yz) * hy();
  flat.slack += steep * (plane.slack + bend.high - bend.low) / std::fabs(n) + 0x1p-49 * steep * reach;
  return flat;
}

std::vector<YRange> ColumnLayout::ranges() const {
  std::vector<double> ends{-hy(), hy()};
  for (const Curve& curve : curves_) {
    const double a = bend_along(curve.form, axes_.y, axes_.y);
    for (const double side : {-hx(), hx()}) {
      const double b = curve.form.gradient[axes_.y] + bend_along(curve.form, axes_.x, axes_.y) * side;
      const double c =
          curve.form.value + (curve.form.gradient[axes_.x] + bend_along(curve.form, axes_.x, axes_.x) * side) * side;
      add_roots(a, b, c, hy(), ends);
    }
  }
  std::sort(ends.begin(), ends.end());
  std::vector<YRange> ranges;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (ends[i] > ends[i - 1]) ranges.push_back({ends[i - 1], ends[i]});
  }
  return ranges;
}

double ColumnLayout::form_at(std::size_t surface, double x, double y, double z) const {
  Vector d;
  d[axes_.x] = x;
  d[axes_.y] = y;
  d[axes_.up] = z;
  return value_at(forms_.f[surface], d);
}

}  // namespace csgcast::detail
