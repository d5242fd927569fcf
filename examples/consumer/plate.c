/* SPDX-License-Identifier: MIT */
/* The same in C, from a scene text. */
#include <csgcast.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

int main(void) {
  const char* text = "part(\"plate\", 7.85) { difference() { cube([40, 20, 0.5]); translate([20, 10, -0.25]) { cylinder(1, r = 3); } } }";
  const double origins[] = {5, 5, 9, 20, 10, 9, 35, 5, 9};
  const double down[] = {0, 0, -1, 0, 0, -1, 0, 0.6, -0.8};
  csgcast_model* model;
  csgcast_intervals table;
  csgcast_measures measures;
  if (csgcast_read(text, strlen(text), "plate", &model) != CSGCAST_OK ||
      csgcast_cast(model, 3, origins, down, 0, INFINITY, NULL, &table) != CSGCAST_OK ||
      csgcast_measure(model, 1e-9, 1e-3, NULL, &measures) != CSGCAST_OK)
    return fprintf(stderr, "%s\n", csgcast_last_error()), 1;
  for (size_t ray = 0; ray < table.rays; ++ray) {
    double inside = 0;
    for (uint64_t i = table.offsets[ray]; i < table.offsets[ray + 1]; ++i) inside += table.t[2 * i + 1] - table.t[2 * i];
    printf("ray %zu: %g\n", ray, inside);
  }
  printf("mass %.5f, within %s\n", measures.mass, measures.mass_error < 1e-5 ? "1e-5" : "more");
  csgcast_free_intervals(&table);
  csgcast_free(model);
  return 0;
}
