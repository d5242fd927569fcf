// SPDX-License-Identifier: MIT
#include "measure/sheet/sheet.h"

#include <cmath>

namespace csgcast::detail {

Sheet::Sheet(const LocalForm& form, Axes axes) : slack_(form.slack) {
  const auto [x, y, up] = axes;
  a_ = bend_along(form, up, up);
  xx_ = bend_along(form, x, x);
  yy_ = bend_along(form, y, y);
  xy_ = bend_along(form, x, y);
  xz_ = bend_along(form, x, up);
  yz_ = bend_along(form, y, up);
  const double slope = form.gradient[up];
  const double discriminant = slope * slope - 4 * a_ * form.value;
  exists_ = slope != 0 && discriminant > 0;
  if (!exists_) return;
  // This is the root at which the slope has the same sign as in the middle.
  height_ = -2 * form.value / (slope + std::copysign(std::sqrt(discriminant), slope));
  b_ = slope + 2 * a_ * height_;
  c_ = form.value + (slope + a_ * height_) * height_;
  fx_ = form.gradient[x] + xz_ * height_;
  fy_ = form.gradient[y] + yz_ * height_;
  exists_ = b_ != 0;
}

Sheet::Bounds Sheet::bounds(Polydisc r) const {
  const double off_b = std::fabs(xz_) * r.x + std::fabs(yz_) * r.y;
  const double c = std::fabs(c_) + std::fabs(fx_) * r.x + std::fabs(fy_) * r.y + std::fabs(xx_) * r.x * r.x +
                   std::fabs(yy_) * r.y * r.y + std::fabs(xy_) * r.x * r.y;
  const double b = std::fabs(b_);
  Bounds result;
  result.b = b - off_b;
  result.discriminant = b * b - 2 * b * off_b - off_b * off_b - 4 * std::fabs(a_) * c;
  if (result.is_analytic()) result.away = 2 * c / (result.b + std::sqrt(result.discriminant));
  return result;
}

Sheet::Gradient Sheet::gradient(Polydisc r, double away) const {
  const double off_x = 2 * std::fabs(xx_) * r.x + std::fabs(xy_) * r.y + std::fabs(xz_) * away;
  const double off_y = 2 * std::fabs(yy_) * r.y + std::fabs(xy_) * r.x + std::fabs(yz_) * away;
  const double off_z = 2 * std::fabs(a_) * away + std::fabs(xz_) * r.x + std::fabs(yz_) * r.y;
  return {std::sqrt(fx_ * fx_ + fy_ * fy_ + b_ * b_), std::sqrt(off_x * off_x + off_y * off_y + off_z * off_z)};
}

double Sheet::greatest_gradient(Polydisc r, double away) const {
  const auto [here, off] = gradient(r, away);
  return here + off;
}

std::optional<double> Sheet::analytic_gradient(Polydisc r, double away) const {
  const auto [here, off] = gradient(r, away);
  if (!(here * here - 2 * here * off - off * off > 0)) return std::nullopt;
  return here + off;
}

double Sheet::away_at(double x, double y) const {
  const double b = b_ + xz_ * x + yz_ * y;
  const double c = c_ + (fx_ + xx_ * x + xy_ * y) * x + (fy_ + yy_ * y) * y;
  const double root = std::sqrt(std::fmax(0, b * b - 4 * a_ * c));
  return -2 * c / (b + std::copysign(root, b_));
}

double Sheet::area_factor(double x, double y, double away) const {
  const double gx = fx_ + 2 * xx_ * x + xy_ * y + xz_ * away;
  const double gy = fy_ + 2 * yy_ * y + xy_ * x + yz_ * away;
  const double gz = b_ + 2 * a_ * away + xz_ * x + yz_ * y;
  return std::sqrt(gx * gx + gy * gy + gz * gz) / std::fabs(gz);
}

double Sheet::greatest_bend() const {
  return 4 * (std::fabs(a_) + std::fabs(xx_) + std::fabs(yy_) + std::fabs(xy_) + std::fabs(xz_) + std::fabs(yz_));
}

}  // namespace csgcast::detail
