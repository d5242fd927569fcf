// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "tests/oracle/quadrics/form.h"

namespace csgcast::oracle::quadrics {

/// A root of a polynomial of degree one or two with rational coefficients, as CGAL's Root_of_2: an exact number.
class Root {
 public:
  explicit Root(const Rational& number);

  /// The roots at which the polynomial changes its sign, ascending: none, one or two. A double root is none.
  static std::vector<Root> sign_changes(const LinePolynomial& polynomial);

  /// The sign of a - b.
  friend int compare(const Root& a, const Root& b);
  friend int compare(const Root& a, const Rational& b);
  /// The nearest double, either of two as near; infinite beyond the doubles.
  double nearest() const;

 private:
  struct Number;
  explicit Root(Number number);
  std::shared_ptr<const Number> number_;
};

/// Whether t is the double nearest to a root, ties to even.
bool is_nearest(double t, const Root& root);

}  // namespace csgcast::oracle::quadrics
