# SPDX-License-Identifier: MIT
"""A plate with a bore: how thick it is along three rays, and how much it weighs."""
import csgcast
import numpy as np

bore = csgcast.cylinder(h=1, r=3).translate([20, 10, -0.25])
model = (csgcast.box([40, 20, 0.5]) - bore).part("plate", density=7.85).compile()

origins = [[5, 5, 9], [20, 10, 9], [35, 5, 9]]
down = [[0, 0, -1], [0, 0, -1], [0, 0.6, -0.8]]
table = model.intervals(origins, down)
lengths = table.t[:, 1] - table.t[:, 0]
ray_of = np.repeat(np.arange(len(table)), np.diff(table.offsets).astype(int))
inside = np.bincount(ray_of, weights=lengths, minlength=len(table))
for ray, length in enumerate(inside):
    print(f"ray {ray}: {length:g}")

measures = model.measure(relative_error=1e-9)
print(f"mass {measures.mass:.5f}, within {'1e-5' if measures.mass_error < 1e-5 else 'more'}")
