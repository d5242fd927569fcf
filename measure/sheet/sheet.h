// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "measure/sheet/piece_forms.h"

namespace csgcast::detail {

/// |x| and |y|, of complex numbers, at most.
struct Polydisc {
  double x = 0;
  double y = 0;
};

/// A surface as its height z over x and y: c + b z + a z² = 0, about the place that it has at x = y = 0, c being of
/// second and b of first degree in x and y. About the middle of a box in which df/dz has one sign.
class Sheet {
 public:
  /// Which of the box's axes are x, y and z.
  struct Axes {
    std::size_t x = 0, y = 1, up = 2;
  };
  Sheet(const LocalForm& form, Axes axes);

  /// False if it has no place at x = y = 0.
  bool exists() const { return exists_; }
  double height() const { return height_; }  ///< at x = y = 0
  bool rises() const { return b_ > 0; }      ///< f is positive above

  /// What the parts of the equation come to for complex x and y.
  struct Bounds {
    double b = 0;             ///< the least Re(sign(b) b)
    double discriminant = 0;  ///< the least Re(b² - 4 a c)
    double away = 0;          ///< the greatest |z - height|, if it is analytic
    bool is_analytic() const { return b > 0 && discriminant > 0; }
    /// Whether rounding of the discriminant does not matter much for its root.
    bool is_sound() const { return is_analytic() && discriminant > 0x1p-10 * b * b; }
  };
  Bounds bounds(Polydisc r) const;
  /// |grad f| for z up to `away` from the height: at most.
  double greatest_gradient(Polydisc r, double away) const;
  /// The same if the square of grad f does not vanish there, so that its root is analytic; else nothing.
  std::optional<double> analytic_gradient(Polydisc r, double away) const;

  /// z - height.
  double away_at(double x, double y) const;
  /// Area by its projection.
  double area_factor(double x, double y, double away) const;

  double slack() const { return slack_; }  ///< what the form may be off
  /// More than twice what the gradient changes by, per unit of length.
  double greatest_bend() const;

 private:
  struct Gradient {
    double here = 0;  // at x = y = 0
    double off = 0;   // what it may differ by
  };
  Gradient gradient(Polydisc r, double away) const;

  double a_ = 0, b_ = 0, c_ = 0;  // at x = y = 0
  double fx_ = 0, fy_ = 0;
  double xx_ = 0, yy_ = 0, xy_ = 0, xz_ = 0, yz_ = 0;
  double height_ = 0;
  double slack_ = 0;
  bool exists_ = false;
};

}  // namespace csgcast::detail
