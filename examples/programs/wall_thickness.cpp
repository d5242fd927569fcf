// SPDX-License-Identifier: MIT
// The thinnest wall that rays across a pipe meet: a bore that is off the axis, drilled into a conical pipe.
#include <csg/solid/primitives.h>
#include <raycast/ray/caster.h>

#include <cstdio>
#include <limits>

using namespace csgcast;

int main() {
  const Solid pipe = cylinder(10, 3, 2);
  const Solid bore = transformed(cylinder(10, 1.5, 1.5), translation({0.25, 0, 0}));
  const Scene scene = compile(pipe - bore);
  Caster caster(scene);
  IntervalList walls;

  double thinnest = std::numeric_limits<double>::infinity();
  Point place;
  for (int step = 1; step < 10; ++step) {
    const Ray across({-5, 0, static_cast<double>(step)},
                     {1, 0, 0});  // t counts in millimetres, as the direction is unit
    caster.begin(across);
    caster.intervals(walls);
    std::printf("z = %d:", step);
    for (const Interval& wall : walls) {
      const double thickness = wall.exit.t - wall.entry.t;
      std::printf("  %.3f mm", thickness);
      if (thickness < thinnest) {
        thinnest = thickness;
        place = across.at(wall.entry.t);
      }
    }
    std::puts("");
  }
  std::printf("thinnest: %.3f mm at (%g, %g, %g)\n", thinnest, place.x, place.y, place.z);
}
