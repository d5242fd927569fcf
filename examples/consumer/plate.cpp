// SPDX-License-Identifier: MIT
// A plate with a bore: how thick it is along three rays, and how much it weighs.
#include <csg/solid/primitives.h>
#include <model/model.h>

#include <cstdio>
#include <vector>

int main() {
  using namespace csgcast;
  const Solid bore = transformed(cylinder(1, 3, 3), translation({20, 10, -0.25}));
  const Model model(named(box({40, 20, 0.5}) - bore, {"plate", 7.85}));

  const std::vector<double> origins{5, 5, 9, 20, 10, 9, 35, 5, 9};
  const std::vector<double> down{0, 0, -1, 0, 0, -1, 0, 0.6, -0.8};
  const IntervalTable table = model.intervals({origins, down});
  for (std::size_t ray = 0; ray + 1 < table.offsets.size(); ++ray) {
    double inside = 0;
    for (std::size_t i = table.offsets[ray]; i < table.offsets[ray + 1]; ++i)
      inside += table.t[2 * i + 1] - table.t[2 * i];
    std::printf("ray %zu: %g\n", ray, inside);
  }
  const Measured mass = model.measure(MeasureOptions{1e-9}).whole.mass;
  std::printf("mass %.5f, within %s\n", mass.value, mass.error < 1e-5 ? "1e-5" : "more");
}
