// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>

#include "csg/base/length.h"
#include "csg/solid/primitives.h"
#include "csg/solid/scene_description.h"
#include "csg/solid/solid.h"
#include "raycast/ray/caster.h"
#include "shade/trace/ray_tree.h"
#include "shade/trace/render.h"
#include "shade/trace/tracer.h"
#include "tests/support/at.h"
#include "tests/support/catch.h"

namespace csgcast::test {

/// Grey with nothing but diffuse light: what it shows is the cosine.
inline Material matte() {
  Material m;
  m.color = {1, 1, 1};
  m.ambient = 0;
  m.diffuse = 1;
  m.specular = 0;
  return m;
}

/// Lets everything through and shows nothing by itself.
inline Material clear_glass(double ior, Rgb absorption = {}) {
  Material m;
  m.ambient = m.diffuse = m.specular = 0;
  m.transmission = 1;
  m.ior = ior;
  m.absorption = absorption;
  return m;
}

inline Material mirror(double reflection) {
  Material m;
  m.ambient = m.diffuse = m.specular = 0;
  m.reflection = reflection;
  return m;
}

inline Solid painted(Solid solid, const Material& material) {
  return with_look(std::move(solid), LookStatement{material, std::nullopt});
}

/// A block with these corners.
inline Solid block(Point lower, Point upper) { return at(box(upper - lower), as_vector(lower)); }

inline LightDescription point_light(Point position) {
  LightDescription light;
  light.position = position;
  return light;
}

/// A light at infinity.
inline LightDescription sun(Vector direction) {
  LightDescription light;
  light.direction = direction;
  return light;
}

/// A solid, in the light of `lights` alone, before a background that is easily told: 1, 1/2, 1/4.
struct Stage {
  explicit Stage(const Solid& solid, std::vector<LightDescription> lights = {}) : scene(compile(solid)), caster(scene) {
    view.lights = std::move(lights);
    view.background = {1, 0.5, 0.25};
    view.camera.eye = {0, -10, 0};
  }

  Rgb trace(Point from, Vector direction, RayTree* tree = nullptr) {
    Tracer tracer(caster, view);
    const Rgb result = tracer.trace(Ray(from, normalised(direction)), tree);
    report = tracer.report();
    return result;
  }
  RayTree tree(Point from, Vector direction) {
    RayTree result;
    trace(from, direction, &result);
    return result;
  }

  Scene scene;
  Caster caster;
  View view;
  RenderReport report;  ///< of the last trace
};

inline void require_close(Rgb is, Rgb should_be, double margin = 1e-12) {
  CAPTURE(is.r, is.g, is.b, should_be.r, should_be.g, should_be.b);
  REQUIRE(std::fabs(is.r - should_be.r) <= margin);
  REQUIRE(std::fabs(is.g - should_be.g) <= margin);
  REQUIRE(std::fabs(is.b - should_be.b) <= margin);
}

}  // namespace csgcast::test
