// SPDX-License-Identifier: MIT
#include "tests/oracle/quadrics/root.h"

#include <CGAL/Root_of_traits.h>

#include <cmath>
#include <limits>
#include <utility>

#include "tests/oracle/nearest.h"

namespace csgcast::oracle::quadrics {

using RootOf2 = CGAL::Root_of_traits<Rational>::Root_of_2;

struct Root::Number {
  RootOf2 value;
};

Root::Root(Number number) : number_(std::make_shared<const Number>(std::move(number))) {}

Root::Root(const Rational& number) : Root(Number{RootOf2(number)}) {}

std::vector<Root> Root::sign_changes(const LinePolynomial& polynomial) {
  const auto& [a, b, c] = polynomial;
  if (sign_of(a) == 0) {
    if (sign_of(b) == 0) return {};
    return {Root(Rational(-c / b))};
  }
  // -b/2a - √r and -b/2a + √r
  const Rational middle = -b / (2 * a);
  const Rational radicand = middle * middle - c / a;
  if (sign_of(radicand) <= 0) return {};
  std::vector<Root> roots;
  for (const int sign : {-1, 1}) {
    roots.push_back(Root(Number{CGAL::make_root_of_2(middle, Rational(sign), radicand)}));
  }
  return roots;
}

int compare(const Root& a, const Root& b) { return static_cast<int>(a.number_->value.compare(b.number_->value)); }

int compare(const Root& a, const Rational& b) { return static_cast<int>(a.number_->value.compare(b)); }

// From an estimate that does not cancel, step by step: where the sum of a and b √r does, it is (a² - b² r) / (a - b
// √r).
double Root::nearest() const {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const RootOf2& value = number_->value;
  double t = CGAL::to_double(value.a0());
  if (value.is_extended()) {
    const Rational square = value.a1() * value.a1() * value.root();
    const double root = sign_of(value.a1()) * std::sqrt(CGAL::to_double(square));
    const bool cancels = t * root < 0;
    t = cancels ? CGAL::to_double(Rational(value.a0() * value.a0() - square)) / (t - root) : t + root;
  }
  while (std::isfinite(t) && compare(*this, halfway_to_next(t, inf)) > 0) t = std::nextafter(t, inf);
  while (std::isfinite(t) && compare(*this, halfway_to_next(t, -inf)) < 0) t = std::nextafter(t, -inf);
  return t;
}

bool is_nearest(double t, const Root& root) {
  return oracle::is_nearest(t, [&root](const Rational& number) { return compare(root, number); });
}

}  // namespace csgcast::oracle::quadrics
