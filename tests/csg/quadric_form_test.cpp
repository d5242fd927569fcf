// SPDX-License-Identifier: MIT
#include "csg/exact/quadric_form.h"

#include "csg/solid/leaf_shape.h"
#include "tests/csg/membership.h"
#include "tests/support/catch.h"

using namespace csgcast;
using csgcast::testing::Random;

namespace {

QuadricForm random_form(Random& random, bool plane) {
  QuadricForm f;
  for (std::size_t i = plane ? QuadricForm::x : QuadricForm::xx; i < QuadricForm::term_count; ++i)
    f.coefficient[i] = random.number();
  return f;
}

QuadricForm scaled(QuadricForm f, double factor) {
  for (Dyadic& c : f.coefficient) c *= factor;
  return f;
}

// A point whose image under the map is exact in doubles.
Point small_point(Random& random) {
  const auto coordinate = [&] { return static_cast<double>(random.below(64)) / 8 - 4; };
  return {coordinate(), coordinate(), coordinate()};
}

Transform small_transform(Random& random) {
  for (;;) {
    Transform t;
    for (double& e : t.entry) e = static_cast<double>(random.below(32)) / 4 - 4;
    if (!ExactAffine(t).is_singular()) return t;
  }
}

Point image_of(const Point& p, const ExactAffine& m) {
  const ExactPoint q = m({p.x, p.y, p.z});
  return {q[0].nearest(), q[1].nearest(), q[2].nearest()};
}

}  // namespace

TEST_CASE("a form is evaluated term by term") {
  QuadricForm f;
  for (std::size_t i = 0; i < QuadricForm::term_count; ++i)
    f.coefficient[i] = Dyadic(1.0).scaled(static_cast<std::int64_t>(4 * i));
  // x² + 2^4 y² + 2^8 z² + 2^12 xy + 2^16 xz + 2^20 yz + 2^24 x + 2^28 y + 2^32 z + 2^36 at (1, 2, 3)
  const double expected =
      1 + 0x1p4 * 4 + 0x1p8 * 9 + 0x1p12 * 2 + 0x1p16 * 3 + 0x1p20 * 6 + 0x1p24 + 0x1p28 * 2 + 0x1p32 * 3 + 0x1p36;
  CHECK(f.at({1, 2, 3}) == Dyadic(expected));
  CHECK((-f).at({1, 2, 3}) == Dyadic(-expected));
}

TEST_CASE("planes, quadrics and constants are told apart") {
  QuadricForm f;
  CHECK(f.is_constant());
  f.coefficient[QuadricForm::one] = 3.0;
  CHECK(f.is_constant());
  CHECK_FALSE(f.is_plane());
  f.coefficient[QuadricForm::y] = -1.0;
  CHECK(f.is_plane());
  f.coefficient[QuadricForm::yz] = 1e-300;
  CHECK_FALSE(f.is_plane());
  CHECK_FALSE(f.is_constant());
}

TEST_CASE("a moved form has the sign of the original at the moved point, on it and off it, mirrored or not") {
  Random random(1);
  int mirrored = 0, on_surface = 0;
  for (int i = 0; i < 3000; ++i) {
    const Transform t = small_transform(random);
    const ExactAffine m(t);
    mirrored += m.determinant().sign() < 0;
    QuadricForm f = random_form(random, i % 2 == 0);
    const Point p = small_point(random);
    if (i % 3 == 0) f.coefficient[QuadricForm::one] -= f.at(p);  // through p
    on_surface += f.at(p).is_zero();
    CHECK(FormMover(m).moved(f).at(image_of(p, m)).sign() == f.at(p).sign());
  }
  CHECK(mirrored > 100);
  CHECK(on_surface > 100);
}

TEST_CASE("moving twice is moving by the product, up to a positive factor") {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const ExactAffine first(random.transform()), second(random.transform());
    const QuadricForm f = random_form(random, i % 2 == 0);
    const CanonicalForm in_steps = canonical(FormMover(second).moved(FormMover(first).moved(f)));
    const CanonicalForm at_once = canonical(FormMover(second * first).moved(f));
    CHECK(in_steps.form == at_once.form);
    CHECK(in_steps.flipped == at_once.flipped);
  }
}

TEST_CASE("proportional forms have one canonical form, and the sign of the factor is kept aside") {
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const QuadricForm f = random_form(random, i % 2 == 0);
    const CanonicalForm c = canonical(f);
    for (const double factor : {3.0, 0.1, 1e-200, -1.0, -7e5}) {
      const CanonicalForm other = canonical(scaled(f, factor));
      CHECK(other.form == c.form);
      CHECK((other.flipped == c.flipped) == (factor > 0));
    }
    CHECK(canonical(c.form).form == c.form);
    CHECK_FALSE(canonical(c.form).flipped);
    QuadricForm nearby = f;
    nearby.coefficient[QuadricForm::z] += Dyadic(5e-324);
    CHECK_FALSE(canonical(nearby).form == c.form);
  }
}

TEST_CASE("a canonical form has coprime integers and a positive leading coefficient") {
  const QuadricForm f = QuadricForm::plane(-0.75, 1.5, {}, 3.0);
  const CanonicalForm c = canonical(f);
  CHECK(c.flipped);
  CHECK(c.form == QuadricForm::plane(1.0, -2.0, {}, -4.0));
}

TEST_CASE("a negative leading coefficient flips the form, however many bits it has") {
  const Dyadic odd = Dyadic(0x1.fffffffffffffp0);
  Dyadic leading(-3.0);
  for (int i = 0; i < 6; ++i, leading *= odd) {
    const CanonicalForm c = canonical(QuadricForm::plane(leading, odd, {}, 1.0));
    CHECK(c.flipped);
    CHECK(c.form.coefficient[QuadricForm::x].sign() == 1);
    CHECK(c.form == canonical(QuadricForm::plane(-leading, -odd, {}, -1.0)).form);
  }
}

TEST_CASE("scaling a cube by two gives the surfaces of a cube of twice the size") {
  const FormMover mover(ExactAffine(scaling({2, 2, 2})));
  const Solid small = box({1, 1, 1}), large = box({2, 2, 2});
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(canonical(mover.moved(small.shape().forms[i])).form == canonical(large.shape().forms[i]).form);
  }
}
