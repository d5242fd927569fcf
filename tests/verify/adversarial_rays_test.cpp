// SPDX-License-Identifier: MIT
#include "verify/adversarial_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/base/length.h"
#include "tests/support/catch.h"
#include "tests/verify/models.h"

using namespace csgcast;
using verify::AdversarialRays;

namespace {

std::size_t kind_called(std::string_view name) {
  const auto kinds = AdversarialRays::kinds();
  const auto found = std::find(kinds.begin(), kinds.end(), name);
  REQUIRE(found != kinds.end());
  return static_cast<std::size_t>(found - kinds.begin());
}

std::vector<Ray> rays_of(const Scene& scene, std::string_view kind, std::size_t count = 200) {
  AdversarialRays source(scene);
  verify::Random random(5);
  std::vector<Ray> rays;
  source.make(kind_called(kind), random, count, rays);
  return rays;
}

// Where the line meets all surfaces, exactly rounded, ascending, in units of length.
std::vector<double> places_on(const Scene& scene, const Ray& ray) {
  const Line line(ray, scene.frame());
  ExactCalls calls;
  std::vector<double> places;
  for (std::uint32_t i = 0; i < scene.surfaces().size(); ++i) {
    const Surface& surface = scene.surface(SurfaceId(i));
    const LineCrossings found = exact_predicates().crossings(line, SurfaceId(i), surface, calls);
    for (std::uint8_t root = 0; root < found.count; ++root) {
      const double t = exact_predicates().reported_t(line, {SurfaceId(i), &surface, &found, root}, calls);
      places.push_back(t * length(ray.direction()));
    }
  }
  std::sort(places.begin(), places.end());
  return places;
}

// The least length of line that holds `count` crossings.
double tightest(const std::vector<double>& places, std::size_t count) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + count <= places.size(); ++i) least = std::min(least, places[i + count - 1] - places[i]);
  return least;
}

template <class Holds>
std::size_t count_if(const std::vector<Ray>& rays, Holds holds) {
  return static_cast<std::size_t>(std::count_if(rays.begin(), rays.end(), holds));
}

double distance_from(Point p, const Ray& ray) { return length(cross(p - ray.origin(), normalised(ray.direction()))); }

// Of points within 4 of the origin, some operations each.
constexpr double few_ulps = 64 * 0x1p-52;

}  // namespace

TEST_CASE("rays through edges and vertices meet two or three surfaces at one place, up to rounding") {
  // All faces meet at right angles, so an ulp off the edge is a few ulps between the crossings, unless the ray lies
  // within a face: then it crosses one surface less.
  for (const Solid& solid : {transformed(box({1, 0.7, 0.4}), rotation(Vector{10, 20, 30})), cylinder(1, 0.6, 0.6)}) {
    const Scene scene = compile(solid);
    const std::vector<Ray> rays = rays_of(scene, "edges");
    REQUIRE(rays.size() == 200);
    CHECK(count_if(rays, [&](const Ray& ray) { return tightest(places_on(scene, ray), 2) <= few_ulps; }) > 80);
  }
  const Scene scene = compile(box({1, 0.7, 0.4}));
  const std::vector<Ray> rays = rays_of(scene, "vertices");
  REQUIRE(rays.size() == 200);
  CHECK(count_if(rays, [&](const Ray& ray) { return tightest(places_on(scene, ray), 3) <= few_ulps; }) > 60);
}

TEST_CASE("random rays do not meet edges") {
  const Scene scene = compile(box({1, 0.7, 0.4}));
  const std::vector<Ray> rays = rays_of(scene, "random");
  CHECK(count_if(rays, [&](const Ray& ray) { return tightest(places_on(scene, ray), 2) <= few_ulps; }) == 0);
}

TEST_CASE("rays in faces lie exactly in axis-parallel planes") {
  const Scene scene = compile(transformed(box({1, 0.7, 0.4}), translation({0.1, 0.2, 0.3})));
  const std::vector<Ray> rays = rays_of(scene, "in faces");
  REQUIRE(rays.size() == 200);
  // Of the six planes three are at doubles; the others are exact sums of two, such as 0.7 + 0.2.
  CHECK(count_if(rays, [&](const Ray& ray) {
          const double t = 1 / length(ray.direction());
          return std::any_of(scene.surfaces().begin(), scene.surfaces().end(), [&](const Surface& surface) {
            return sign_at(surface, ray.origin()) == 0 && sign_at(surface, ray.at(t)) == 0;
          });
        }) >= 80);
}

TEST_CASE("tangents pass a ball at its radius and at most 1e-6 of the scene's size beside it") {
  const Scene scene = compile(sphere(1));
  const std::vector<Ray> rays = rays_of(scene, "tangents");
  REQUIRE(rays.size() == 200);
  const auto off = [](const Ray& ray) { return std::fabs(distance_from({}, ray) - 1); };
  const double most = 1e-6 * std::ldexp(1.0, scene.frame().exponent) + few_ulps;
  CHECK(count_if(rays, [&](const Ray& ray) { return off(ray) < most; }) == 200);
  CHECK(count_if(rays, [&](const Ray& ray) { return off(ray) < 1e-12; }) > 60);
  CHECK(count_if(rays, [&](const Ray& ray) { return off(ray) > 1e-12; }) > 60);
}

TEST_CASE("generators lie in the cylinder, and there are none on a ball") {
  const Scene scene = compile(cylinder(1, 0.6, 0.6));
  const std::vector<Ray> rays = rays_of(scene, "generators");
  REQUIRE(rays.size() == 200);
  for (const Ray& ray : rays) {
    CHECK(ray.direction().x == 0);
    CHECK(ray.direction().y == 0);
    CHECK(std::fabs(std::hypot(ray.origin().x, ray.origin().y) - 0.6) <= few_ulps);
  }
  CHECK(rays_of(compile(sphere(1)), "generators").empty());
}

TEST_CASE("rays through apexes pass a cone's apex within rounding, many of them exactly") {
  const Point apex{0.25, 0, 1};
  const Scene scene = compile(transformed(cylinder(1, 0.6, 0), translation({0.25, 0, 0})));
  const std::vector<Ray> rays = rays_of(scene, "apexes and centers");
  REQUIRE(rays.size() == 200);
  CHECK(count_if(rays, [&](const Ray& ray) { return distance_from(apex, ray) <= few_ulps; }) == 200);
  CHECK(count_if(rays, [&](const Ray& ray) { return distance_from(apex, ray) == 0; }) > 50);
}

TEST_CASE("rays that start on surfaces start within a few ulps of one") {
  const Scene scene = compile(sphere(1));
  const std::vector<Ray> rays = rays_of(scene, "starting on surfaces");
  REQUIRE(rays.size() == 200);
  CHECK(count_if(rays, [&](const Ray& ray) { return std::fabs(length(ray.origin() - Point{}) - 1) <= 8 * 0x1p-52; }) ==
        200);
}

TEST_CASE("bisected rays are so near to an edge or silhouette that floating point cannot decide") {
  const Scene scene = test::example("angel");
  const std::vector<Ray> rays = rays_of(scene, "bisected");
  REQUIRE(rays.size() > 100);
  Caster caster(scene);
  IntervalList list;
  for (const Ray& ray : rays) {
    caster.begin(ray);
    caster.intervals(list, Span::line());
  }
  CHECK(caster.counts().rays_flagged > rays.size() * 8 / 10);
}

TEST_CASE("every kind of rays can be asked of every scene, and is the same again for the same seed") {
  for (const test::Model& model : test::hostile_models()) {
    INFO(model.name);
    const Scene scene = compile(model.solid);
    std::size_t total = 0;
    for (const std::string_view kind : AdversarialRays::kinds()) {
      const std::vector<Ray> rays = rays_of(scene, kind, 10);
      const std::vector<Ray> again = rays_of(scene, kind, 10);
      CHECK(rays.size() <= 10);
      CHECK(std::equal(rays.begin(), rays.end(), again.begin(), again.end(), [](const Ray& a, const Ray& b) {
        return a.origin() == b.origin() && a.direction() == b.direction();
      }));
      total += rays.size();
    }
    CHECK(total >= 20);
  }
}
