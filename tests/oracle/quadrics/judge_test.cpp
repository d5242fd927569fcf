// SPDX-License-Identifier: MIT
// The quadric oracle under test: known answers, and what it must notice.
#include <cmath>
#include <limits>

#include "csg/solid/primitives.h"
#include "tests/oracle/quadrics/judge.h"
#include "tests/support/catch.h"

namespace csgcast::oracle::quadrics {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

// A product's answer on one ray beside the definition's.
struct Case {
  Case(const Solid& solid, const Ray& ray) : subject(solid), expected(answer_on_line(subject, ray).list) {
    Caster caster(subject.scene());
    caster.begin(ray);
    found = found_list(caster, Span::line());
  }
  std::string verdict() const { return difference(subject, found, expected); }

  Subject subject;
  DefinedList expected;
  FoundList found;
};

// Two cubes that share a face, and a ball that is cut out of both.
Case drilled_pair() {
  const Solid pair = box({1, 1, 1}) + transformed(box({1, 1, 1}), translation({1, 0, 0}));
  const Solid ball = transformed(sphere(0.3), translation({1, 0.5, 0.5}));
  return Case(pair - ball, Ray({-1, 0.4, 0.45}, {1, 0.01, 0}));
}

TEST_CASE("the roots of t² - 2 lie between the doubles beside √2") {
  const auto roots = Root::sign_changes({Rational(1), Rational(0), Rational(-2)});
  REQUIRE(roots.size() == 2);
  CHECK(compare(roots[0], roots[1]) < 0);
  CHECK(is_nearest(std::sqrt(2.0), roots[1]));
  CHECK_FALSE(is_nearest(std::nextafter(std::sqrt(2.0), 2), roots[1]));
  CHECK_FALSE(is_nearest(std::nextafter(std::sqrt(2.0), 1), roots[1]));
  CHECK(is_nearest(-std::sqrt(2.0), roots[0]));
  CHECK(roots[0].nearest() == -std::sqrt(2.0));
}

TEST_CASE("a small root beside a large one is found to the last bit") {
  // t² - 2^60 t + 1: 2^-60 and a little more
  const auto roots = Root::sign_changes({Rational(1), Rational(-0x1p60), Rational(1)});
  CHECK(roots[0].nearest() == 0x1p-60);
  CHECK(compare(roots[0], Rational(0x1p-60)) > 0);
  CHECK(roots[1].nearest() == 0x1p60);
}

TEST_CASE("roots of different polynomials that are one number compare equal") {
  // (t - 3)(t + 1), 2 t - 6, and t² - 9
  const auto a = Root::sign_changes({Rational(1), Rational(-2), Rational(-3)});
  const auto b = Root::sign_changes({Rational(0), Rational(2), Rational(-6)});
  const auto c = Root::sign_changes({Rational(1), Rational(0), Rational(-9)});
  CHECK(compare(a[1], b[0]) == 0);
  CHECK(compare(b[0], a[1]) == 0);
  CHECK(compare(a[1], c[1]) == 0);
  CHECK(compare(a[0], c[0]) > 0);
  // 1 + √2 as a root of t² - 2t - 1 and of 3t² - 6t - 3, and a rational beside it
  const auto d = Root::sign_changes({Rational(1), Rational(-2), Rational(-1)});
  const auto e = Root::sign_changes({Rational(-3), Rational(6), Rational(3)});
  CHECK(compare(d[1], e[1]) == 0);
  CHECK(compare(d[0], e[0]) == 0);
  CHECK(compare(d[1], Rational(std::nextafter(1 + std::sqrt(2.0), 0))) > 0);
}

TEST_CASE("a double root and a polynomial without roots have no sign change") {
  CHECK(Root::sign_changes({Rational(1), Rational(-2), Rational(1)}).empty());
  CHECK(Root::sign_changes({Rational(1), Rational(0), Rational(1)}).empty());
  CHECK(Root::sign_changes({Rational(0), Rational(0), Rational(1)}).empty());
  CHECK(Root::sign_changes({Rational(0), Rational(0), Rational(0)}).empty());
}

TEST_CASE("the definition sees a moved ball where it is, and not from a tangent") {
  const Subject subject(transformed(transformed(sphere(1), scaling({2, 2, 2})), translation({5, 0, 0})));
  const DefinedList through = answer_on_line(subject, Ray({0, 0, 0}, {1, 0, 0})).list;
  REQUIRE(through.size() == 1);
  CHECK(compare(*through[0].entry.t, Rational(3)) == 0);
  CHECK(compare(*through[0].exit.t, Rational(7)) == 0);
  CHECK(answer_on_line(subject, Ray({0, 2, 0}, {1, 0, 0})).list.empty());
  CHECK(answer_on_line(subject, Ray({0, std::nextafter(2, 0), 0}, {1, 0, 0})).list.size() == 1);
  CHECK(answer_at_point(subject, {3, 0, 0}).location == Location::boundary);
  CHECK(answer_at_point(subject, {std::nextafter(3, 4), 0, 0}).location == Location::inside);
  CHECK(answer_at_point(subject, {std::nextafter(3, 2), 0, 0}).location == Location::outside);
}

TEST_CASE("the oracle notices a wrong surface") {
  Case sample = drilled_pair();
  REQUIRE(sample.found.size() == 2);
  CHECK(sample.verdict().empty());
  sample.found[0].entry.crossing.surface = sample.found[1].exit.crossing.surface;
  CHECK(sample.verdict() == "entry of interval 0: surface");
}

TEST_CASE("the oracle notices a wrong leaf") {
  Case sample = drilled_pair();
  sample.found[1].entry.attribution->leaf = sample.found[0].entry.attribution->leaf;
  CHECK(sample.verdict() == "entry of interval 1: leaf");
}

TEST_CASE("the oracle notices the wrong side of a surface") {
  Case sample = drilled_pair();
  Sense& front = sample.found[0].exit.attribution->front;
  front = opposite(front);
  CHECK(sample.verdict() == "exit of interval 0: side of the surface");
}

TEST_CASE("the oracle notices a t that is one ulp off, either way") {
  for (const double direction : {-inf, inf}) {
    Case sample = drilled_pair();
    double& t = sample.found[0].exit.crossing.t;
    t = std::nextafter(t, direction);
    CHECK(sample.verdict() == "exit of interval 0: t is not the nearest double");
  }
}

TEST_CASE("the oracle notices a missing sliver of 1e-17") {
  const Solid plate = transformed(box({2, 2, 1e-17}), translation({-1, -1, 0}));
  Case sample(plate + transformed(sphere(1), translation({0, 0, 3})), Ray({0.25, 0.125, -1}, {0, 0, 1}));
  CHECK(sample.verdict().empty());
  REQUIRE(sample.found.size() == 2);
  CHECK(sample.found[0].entry.crossing.t == sample.found[0].exit.crossing.t);
  sample.found.erase(sample.found.begin());
  CHECK(sample.verdict() == "1 intervals, not 2");
}

TEST_CASE("the oracle notices a sliver of 1e-17 that is not there") {
  // The same plate less a larger one.
  const Solid plate = transformed(box({2, 2, 1e-17}), translation({-1, -1, 0}));
  const Ray ray({0.25, 0.125, -1}, {0, 0, 1});
  Case sample(transformed(box({3, 3, 3}, Centering::centered), translation({0, 0, 5})), ray);
  CHECK(sample.verdict().empty());
  sample.found.insert(sample.found.begin(), Case(plate, ray).found.front());
  CHECK(sample.verdict() == "2 intervals, not 1");
}

TEST_CASE("the oracle notices a radius, a transform and a half-space that are an ulp off or turned round") {
  const double next = std::nextafter(1, 2);
  const Solid ball = sphere(1);
  const Transform moved = translation({1, 2, 3});
  const Transform moved_otherwise = translation({1, 2, std::nextafter(3, 4)});
  CHECK(Subject(transformed(ball, moved)).complaint().empty());
  CHECK_FALSE(Subject(ball, sphere(next)).complaint().empty());
  CHECK_FALSE(Subject(transformed(ball, moved), transformed(ball, moved_otherwise)).complaint().empty());
  CHECK_FALSE(Subject(halfspace({1, 0, 0}, 1), halfspace({-1, 0, 0}, -1)).complaint().empty());
  CHECK_FALSE(Subject(ball + box({1, 1, 1}), box({1, 1, 1}) + ball).complaint().empty());
}

TEST_CASE("the oracle notices the wrong operation on curved solids") {
  const Solid ball = sphere(1);
  const Solid rod = cylinder(4, 0.5, 0.5, Centering::centered);
  const Ray ray({-2, 0.25, 0.125}, {1, 0, 0});
  for (const Solid& compiled : {ball + rod, ball & rod, rod - ball}) {
    const Subject subject(ball - rod, compiled);
    CHECK(subject.complaint().empty() == (compiled.kind() != Solid::Kind::subtract));
    Caster caster(subject.scene());
    caster.begin(ray);
    CHECK_FALSE(difference(subject, found_list(caster, Span::line()), answer_on_line(subject, ray).list).empty());
  }
}

TEST_CASE("the oracle notices a reversed list that is no mirror image") {
  Case forward = drilled_pair();
  const Ray ray({-1, 0.4, 0.45}, {1, 0.01, 0});
  Caster caster(forward.subject.scene());
  caster.begin(Ray(ray.origin(), -ray.direction()));
  FoundList backward = found_list(caster, Span::line());
  CHECK(difference_of_mirrored(forward.found, backward).empty());
  backward[0].entry.crossing.t = std::nextafter(backward[0].entry.crossing.t, 0);
  CHECK_FALSE(difference_of_mirrored(forward.found, backward).empty());
}

}  // namespace
}  // namespace csgcast::oracle::quadrics
