// SPDX-License-Identifier: MIT
// Builds a solid in code and prints where a ray is inside it, and the leaf that each end belongs to.
#include <csg/solid/primitives.h>
#include <raycast/ray/caster.h>

#include <cstdio>

using namespace csgcast;

int main() {
  // A block with an upright bore, and a slot whose end lies exactly in the block's side.
  const Solid block = box({8, 4, 2});
  const Solid bore = transformed(cylinder(2, 1, 1), translation({3, 2, 0}));
  const Solid slot = transformed(box({2, 2, 2}), translation({6, 1, 0}));
  const Scene scene = compile(block - unite({bore, slot}));

  Caster caster(scene);  // one for each thread
  caster.begin(Ray({-1, 2, 1}, {1, 0, 0}));
  IntervalList list;
  caster.intervals(list);
  for (const Interval& interval : list) {
    const Attribution entry = caster.attribute({interval.entry, Passage::entry});
    const Attribution exit = caster.attribute({interval.exit, Passage::exit});
    std::printf("%g (%s) .. %g (%s)\n", interval.entry.t, word(scene.leaf(entry.leaf).kind), interval.exit.t,
                word(scene.leaf(exit.leaf).kind));
  }
}
