// SPDX-License-Identifier: MIT
#include "tests/oracle/quadrics/root.h"

#include <CGAL/Root_of_traits.h>

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

double Root::approximate() const { return CGAL::to_double(number_->value); }

bool is_nearest(double t, const Root& root) {
  return oracle::is_nearest(t, [&root](const Rational& number) { return compare(root, number); });
}

}  // namespace csgcast::oracle::quadrics
