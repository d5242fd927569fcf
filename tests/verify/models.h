// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "csg/solid/primitives.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "raycast/scene/scene.h"

namespace csgcast::test {

/// One of the scenes in examples/.
inline Scene example(const std::string& name) {
  const text::Document document = text::read_file(CSGCAST_SOURCE_DIR "/examples/" + name + ".csg");
  return compile(text::build(document, {}).solid);
}

/// A bit of everything, of about this size.
inline Solid varied_solid(double size) {
  const Solid hole = transformed(cylinder(2 * size, 0.3 * size, 0), translation({0.1 * size, 0, -0.5 * size}));
  return (box({size, size, size}, Centering::centered) - sphere(0.6 * size)) + (hole & sphere(size));
}

struct Model {
  std::string name;
  Solid solid;
};

/// Scenes at the limits: nothing, everything, unbounded, tiny, huge, far away, thin, hollow.
inline std::vector<Model> hostile_models() {
  const Solid unbounded = quadric({1, 1, -1, 0, 0, 0}, {0.5, 0, 0}, 0.25);
  return {{"empty", {}},
          {"everything", Solid::everything()},
          {"a half-space far away", halfspace({1, 2, 3}, 1e9)},
          {"an unbounded quadric", unbounded},
          {"an unbounded quadric less another", unbounded - quadric({0, 0, 1, 0, 0, 0}, {1, 0, 0}, 0)},
          {"2^-390", varied_solid(0x1p-390)},
          {"2^390", varied_solid(0x1p390)},
          {"1e9", varied_solid(1e9)},
          {"at 1e12", transformed(varied_solid(1), translation({1e12, -2e12, 5e11}))},
          {"a plate", box({1, 1, 1e-13})},
          {"a shell", sphere(1) - sphere(1 - 1e-15)},
          {"a small part on a half-space",
           halfspace({0, 0, 1}, 0) + transformed(varied_solid(0.01), translation({300, 400, 0.005}))},
          {"nothing is left", sphere(1) - transformed(sphere(2), scaling({0.5, 0.5, 0.5}))}};
}

}  // namespace csgcast::test
