// SPDX-License-Identifier: MIT
#include "csg/exact/composition.h"

#include <cmath>

#include "csg/exact/affine.h"
#include "csg/solid/primitives.h"
#include "tests/support/catch.h"
#include "tests/support/random_solid.h"

using namespace csgcast;

namespace {

Transform random_transform(test::RandomSolids& random) {
  Transform t;
  for (std::size_t row = 0; row < 3; ++row) {
    const Point p = random.point(3);
    for (std::size_t column = 0; column < 3; ++column) t.entry[4 * row + column] = p[column];
    t.entry[4 * row + 3] = 1e3 * random.point(1).x;
  }
  return t;
}

}  // namespace

TEST_CASE("a product of transforms is the exact one, each entry rounded once, the right factor first") {
  test::RandomSolids random(5);
  for (int i = 0; i < 200; ++i) {
    const Transform outer = random_transform(random), inner = random_transform(random);
    const ExactAffine exact = ExactAffine(outer) * ExactAffine(inner);
    const Transform product = outer * inner;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column)
        CHECK(product(row, column) == exact.linear(row, column).nearest());
      CHECK(product(row, 3) == exact.offset(row).nearest());
    }
  }
  const Transform turn = rotation(Vector{0, 0, 90}), move = translation({1, 2, 3});
  CHECK((turn * move).entry == std::array<double, 12>{0, -1, 0, -2, 1, 0, 0, 1, 0, 0, 1, 3});
  CHECK((move * turn).entry == std::array<double, 12>{0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 1, 3});
  CHECK((Transform{} * turn) == turn);
  CHECK((turn * Transform{}) == turn);
  // 0.1 + 0.2, exactly, and rounded once.
  CHECK((translation({0.1, 0, 0}) * translation({0.2, 0, 0}))(0, 3) == 0.1 + 0.2);
  CHECK(std::isinf((scaling({1e300, 1, 1}) * scaling({1e300, 1, 1}))(0, 0)));
}

TEST_CASE("the error of a product's linear part covers what its factors may be off") {
  const double degrees = 1;
  Transform turned;
  for (int i = 0; i < 90; ++i) turned = rotation(degrees, {0, 0, 1}) * turned;
  const Transform exact = rotation(90, {0, 0, 1});
  CHECK(turned.linear_error > 0);
  double most = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column)
      most = std::fmax(most, std::fabs(turned(row, column) - exact(row, column)));
  }
  CHECK(most > 0);
  CHECK(most <= turned.linear_error + 0x1p-53);
  CHECK(turned.linear_error < 1e-12);
}

TEST_CASE("a transform of a transform is composed exactly, where a product is rounded") {
  const Transform third = scaling({1.0 / 3, 1, 1}), thrice = scaling({3, 1, 1});
  CHECK((third * thrice)(0, 0) == 1);
  const Solid nested = transformed(transformed(box({1, 1, 1}, Centering::corner), thrice), third);
  CHECK(nested.kind() == Solid::Kind::transform);
  CHECK(nested.children()[0].kind() == Solid::Kind::transform);
  CHECK((ExactAffine(third) * ExactAffine(thrice)).linear(0, 0).nearest() == 1);
  CHECK_FALSE((ExactAffine(third) * ExactAffine(thrice)).linear(0, 0) == Dyadic(1.0));
}
