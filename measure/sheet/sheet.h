// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "measure/sheet/piece_forms.h"

namespace csgcast::detail {

/// Upper bounds on |x| and |y| for complex numbers.
struct Polydisc {
  double x = 0;
  double y = 0;
};

/// A surface as its height z over x and y: c + b z + a z² = 0, relative to its place at x = y = 0. c is of second
/// degree and b of first degree in x and y. The place is about the middle of a box in which df/dz has one sign.
class Sheet {
 public:
  /// The axes of the box that are x, y and z.
  struct Axes {
    std::size_t x = 0, y = 1, up = 2;
  };
  Sheet(const LocalForm& form, Axes axes);

  /// False if the sheet has no place at x = y = 0.
  bool exists() const { return exists_; }
  double height() const { return height_; }  ///< at x = y = 0
  bool rises() const { return b_ > 0; }      ///< true if f is positive above

  /// Bounds on the parts of the equation for complex x and y.
  struct Bounds {
    double b = 0;             ///< the least Re(sign(b) b)
    double discriminant = 0;  ///< the least Re(b² - 4 a c)
    double away = 0;          ///< the greatest |z - height|, if z is analytic
    bool is_analytic() const { return b > 0 && discriminant > 0; }
    /// True if the rounding of the discriminant matters little for its root.
    bool is_sound() const { return is_analytic() && discriminant > 0x1p-10 * b * b; }
  };
  Bounds bounds(Polydisc r) const;
  /// Upper bound on |grad f|, for z up to `away` from the height.
  double greatest_gradient(Polydisc r, double away) const;
  /// The same, if the square of grad f does not vanish there, so that its root is analytic. Otherwise nothing.
  std::optional<double> analytic_gradient(Polydisc r, double away) const;

  /// Computes z - height.
  double away_at(double x, double y) const;
  /// The ratio of area to projected area.
  double area_factor(double x, double y, double away) const;

  double slack() const { return slack_; }  ///< error bound of the form
  /// More than twice the change of the gradient per unit of length.
  double greatest_bend() const;

 private:
  struct Gradient {
    double here = 0;  // the value at x = y = 0
    double off = 0;   // bound on the difference from it
  };
  Gradient gradient(Polydisc r, double away) const;

  double a_ = 0, b_ = 0, c_ = 0;  // the values at x = y = 0
  double fx_ = 0, fy_ = 0;
  double xx_ = 0, yy_ = 0, xy_ = 0, xz_ = 0, yz_ = 0;
  double height_ = 0;
  double slack_ = 0;
  bool exists_ = false;
};

}  // namespace csgcast::detail
