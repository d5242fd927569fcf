// SPDX-License-Identifier: MIT
// Where points are: inside, outside or on the boundary, decided exactly, the neighbouring doubles of a face included.
#include <csg/solid/primitives.h>
#include <raycast/ray/caster.h>

#include <cmath>
#include <cstdio>

using namespace csgcast;

namespace {

const char* word(Location location) {
  switch (location) {
    case Location::inside:
      return "inside";
    case Location::outside:
      return "outside";
    case Location::boundary:
      break;
  }
  return "boundary";
}

}  // namespace

int main() {
  // A ball of radius 5 with a slot as wide as [-1, 1]; (3, 4, 0) and (3, 0, 4) lie on the ball exactly.
  const Solid slot = transformed(box({2, 20, 10}), translation({-1, -10, 0}));
  const Scene scene = compile(sphere(5) - slot);
  Caster caster(scene);
  const double above_one = std::nextafter(1.0, 2.0);
  for (const Point p : {Point{3, 4, 0}, Point{3, 0, 4}, Point{3, 0, std::nextafter(4.0, 5.0)}, Point{0, 0, 2},
                        Point{1, 0, 2}, Point{above_one, 0, 2}, Point{0, 0, 0}, Point{0, 0, -1}}) {
    std::printf("(%.17g, %.17g, %.17g): %s\n", p.x, p.y, p.z, word(caster.locate(p)));
  }
}
