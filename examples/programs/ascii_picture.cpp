// SPDX-License-Identifier: MIT
// First hits over a grid of parallel rays, as a picture of letters: the lighter, the more a face turns to the upper
// left.
#include <csg/solid/primitives.h>
#include <raycast/ray/caster.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "csg/base/length.h"

using namespace csgcast;

namespace {

Solid drilled_ball() {
  const Solid drill = cylinder(4, 0.55, 0.55, Centering::centered);
  const Solid body = sphere(1.3) & box({2, 2, 2}, Centering::centered);
  return body - unite({drill, transformed(drill, rotation({90, 0, 0})), transformed(drill, rotation({0, 90, 0}))});
}

char letter(Normal n) {
  const std::string ramp = "@%#*+=-:.";
  const double light = dot(n, normalised(Vector{-0.5, -0.6, 0.7}));
  return ramp[static_cast<std::size_t>(std::clamp(light, 0.0, 0.99) * static_cast<double>(ramp.size()))];
}

}  // namespace

int main() {
  const Transform turn = rotation({0, 0, 30});
  const Scene scene = compile(transformed(transformed(drilled_ball(), turn), rotation({35, 0, 0})));
  Caster caster(scene);
  for (int row = 0; row < 24; ++row) {
    std::string line;
    for (int column = 0; column < 56; ++column) {
      caster.begin(Ray({(column - 27.5) / 18.0, -5, (11.5 - row) / 8.5}, {0, 1, 0}));
      const auto hit = caster.first_hit();
      line += hit ? letter(caster.attribute(*hit).normal) : ' ';
    }
    std::puts(line.substr(0, line.find_last_not_of(' ') + 1).c_str());
  }
}
