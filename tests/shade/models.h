// SPDX-License-Identifier: MIT
#pragma once

#include "csg/base/length.h"
#include "tests/shade/pictures.h"

namespace csgcast::test {

/// The classical one: box and ball less a cylinder along each axis.
inline Solid angel() {
  const Solid bore = at(cylinder(4, 0.6, 0.6), {0, 0, -2});
  return subtract({intersect({box({2, 2, 2}, Centering::centered), sphere(1.35)}), bore,
                   transformed(bore, rotation(Vector{90, 0, 0})), transformed(bore, rotation(Vector{0, 90, 0}))});
}

/// Bricks that touch, less slots that end flush with their faces: nothing but coincident faces.
inline Solid flush(int n) {
  std::vector<Solid> bricks;
  std::vector<Solid> cut;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) bricks.push_back(at(box({1, 1, 1}), {1.0 * i, 1.0 * j, 0}));
    cut.push_back(at(box({0.5, 1.0 * n, 0.5}), {i + 0.25, 0, 0.5}));
  }
  cut.insert(cut.begin(), unite(std::move(bricks)));
  return subtract(std::move(cut));
}

/// A mirror ball and a glass ball on a floor.
inline Solid still_life() {
  Material shiny = matte();
  shiny.ambient = 0.1;
  shiny.color = {0.8, 0.6, 0.3};
  shiny.diffuse = 0.7;
  shiny.reflection = 0.3;
  Material glass = clear_glass(1.5, {0.2, 0.05, 0.1});
  glass.specular = 0.5;
  glass.reflection = 0.1;
  glass.transmission = 0.9;
  return painted(block({-4, -4, -1.5}, {4, 4, -1}), matte()) + painted(at(sphere(1), {-1.1, 0, 0}), shiny) +
         painted(at(sphere(1), {1.1, -0.5, 0}), glass) + painted(at(angel(), {0.3, 3, 0.2}), shiny);
}

/// A view from above the front right, in the light of one lamp.
inline View standard_view(Point look_at = {0, 0, 0}, double distance = 7.4) {
  View view;
  view.camera.look_at = look_at;
  view.camera.eye = look_at + distance * normalised(Vector{4, -5, 3.5});
  view.lights = {point_light(look_at + Vector{6, -4, 9})};
  view.background = {0.2, 0.3, 0.4};
  return view;
}

inline RenderOptions picture(int width, int height, Mode mode = Mode::shaded) {
  RenderOptions options;
  options.width = width;
  options.height = height;
  options.mode = mode;
  return options;
}

}  // namespace csgcast::test
