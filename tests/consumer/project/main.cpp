// SPDX-License-Identifier: MIT
// A box with a hole, and one ray through it: intervals [1, 2] and [4, 5].
#include <csg/solid/primitives.h>
#include <raycast/ray/caster.h>

#include <cstdlib>
#include <iostream>

int main() {
  using namespace csgcast;
  const Solid block = box({4, 4, 4}, Centering::centered);
  const Solid hole = box({2, 2, 6}, Centering::centered);
  const Scene scene = compile(block - hole);
  Caster caster(scene);
  caster.begin(Ray({-3, 0, 0}, {1, 0, 0}));
  IntervalList list;
  caster.intervals(list);
  for (const Interval& interval : list) std::cout << interval.entry.t << ' ' << interval.exit.t << '\n';
  const bool right =
      list.size() == 2 && list[0].entry.t == 1 && list[0].exit.t == 2 && list[1].entry.t == 4 && list[1].exit.t == 5;
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
