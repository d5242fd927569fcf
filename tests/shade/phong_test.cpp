// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "csg/base/length.h"
#include "shade/light/phong.h"
#include "tests/shade/pictures.h"

using namespace csgcast;
using namespace csgcast::test;

namespace {

const Vector up{0, 0, 1};

Material glossy() {
  Material m = matte();
  m.color = {0.5, 0.25, 1};
  m.diffuse = 0.6;
  m.specular = 0.3;
  m.shininess = 20;
  return m;
}

Illumination from_direction(Vector to_light) { return {normalised(to_light), to_light, false, {1, 1, 1}}; }

}  // namespace

TEST_CASE("light from head-on, seen from head-on, shows all of diffuse and specular") {
  require_close(phong(glossy(), up, up, from_direction(up)), {0.3 + 0.3, 0.15 + 0.3, 0.6 + 0.3});
}

TEST_CASE("diffuse light goes with the cosine and does not depend on the viewer") {
  Material m = glossy();
  m.specular = 0;
  for (const Vector viewer : {up, Vector{1, 0, 0}, Vector{0.6, 0, 0.8}}) {
    require_close(phong(m, up, viewer, from_direction({std::sqrt(3.0), 0, 1})), {0.15, 0.075, 0.3});
  }
}

TEST_CASE("the highlight is brightest in the mirror direction and falls off with its angle") {
  Material m = glossy();
  m.diffuse = 0;
  const Illumination light = from_direction({1, 0, 1});
  require_close(phong(m, up, normalised(Vector{-1, 0, 1}), light), {0.3, 0.3, 0.3});
  require_close(phong(m, up, up, light), 0.3 * std::pow(std::sqrt(0.5), 20) * Rgb{1, 1, 1});
  require_close(phong(m, up, normalised(Vector{1, 0, 0.5}), light), {});
}

TEST_CASE("light that grazes or comes from behind adds nothing") {
  require_close(phong(glossy(), up, up, from_direction({1, 0, 0})), {}, 0);
  require_close(phong(glossy(), up, up, from_direction({1, 0, -1e-9})), {}, 0);
  require_close(phong(glossy(), up, Vector{-1, 0, 0}, from_direction({1, 0, -1e-9})), {}, 0);
}

TEST_CASE("a light falls off with the inverse square only where it asks for that") {
  LightDescription light = point_light({0, 0, 6});
  light.intensity = 2;
  light.color = {1, 0.5, 0};
  require_close(illuminate(light, {0, 0, 0})->light, {2, 1, 0}, 0);
  light.falloff = 3;
  require_close(illuminate(light, {0, 0, 0})->light, {0.5, 0.25, 0});
  require_close(illuminate(light, {0, 0, 3})->light, {2, 1, 0});
}

TEST_CASE("a light at the very place it shines on has no direction") {
  REQUIRE_FALSE(illuminate(point_light({1, 2, 3}), {1, 2, 3}));
  REQUIRE_FALSE(illuminate(sun({0, 0, 0}), {1, 2, 3}));
}

TEST_CASE("Snell's law: known angles, and total internal reflection beyond the critical one") {
  const double in = std::numbers::pi / 6;  // sin = 1/2
  const Vector incoming{std::sin(in), 0, -std::cos(in)};
  const Vector denser = *refracted(incoming, up, 1 / 1.5);
  REQUIRE(denser.x == Approx(0.5 / 1.5).epsilon(1e-14));
  REQUIRE(length(denser) == Approx(1).epsilon(1e-15));
  const Vector thinner = *refracted(incoming, up, 1.5);
  REQUIRE(thinner.x == Approx(0.75).epsilon(1e-14));
  const double critical = std::asin(1 / 1.5);
  const auto at_angle = [](double a) { return Vector{std::sin(a), 0, -std::cos(a)}; };
  REQUIRE(refracted(at_angle(critical - 1e-9), up, 1.5).has_value());
  REQUIRE_FALSE(refracted(at_angle(critical + 1e-9), up, 1.5).has_value());
}

TEST_CASE("between equal media a ray goes straight on, to the last bit") {
  const Vector incoming = normalised(Vector{0.3, -0.7, -0.1});
  REQUIRE(*refracted(incoming, up, 1) == incoming);
}

TEST_CASE("a medium takes light exponentially, and a clear one none at any length") {
  require_close(transmittance({1, 0.5, 0}, 2), {std::exp(-2), std::exp(-1), 1});
  require_close(transmittance({1, 0, 0}, std::numeric_limits<double>::infinity()), {0, 1, 1}, 0);
}

TEST_CASE("sRGB encoding and decoding are inverse for all 8-bit values") {
  for (int i = 0; i < 256; ++i) {
    const double encoded = i / 255.0;
    REQUIRE(std::fabs(srgb_from_linear(linear_from_srgb(encoded)) - encoded) <
            1e-7);  // the standard's two pieces meet to within 3e-8
  }
  REQUIRE(srgb_from_linear(1) == Approx(1).epsilon(1e-15));
  REQUIRE(srgb_from_linear(0) == 0);
}
