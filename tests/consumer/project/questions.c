/* SPDX-License-Identifier: MIT */
/* Every kind of question, in C99. Prints what went wrong, and ends with 1 then. */
#include <csgcast.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int wrong;

static void check(int holds, const char* what) {
  if (holds) return;
  fprintf(stderr, "wrong: %s (%s)\n", what, csgcast_last_error());
  wrong = 1;
}
#define CHECK(holds) check(holds, #holds)

static void ask_for_sections(const csgcast_model* model) {
  const double plane[4] = {0, 0, 1, 1};
  csgcast_section section;
  csgcast_polylines lines;
  const char* text = NULL;
  CHECK(csgcast_cut(model, plane, NULL, NULL, &section) == CSGCAST_OK);
  CHECK(section.loops == 2 && section.offsets[2] >= 6 && section.arcs[0].surface != CSGCAST_NONE);
  CHECK(fabs(section.area - 3.2146018366025517) <= section.area_error + 1e-14);
  CHECK(csgcast_section_svg(&section, 0, &text) == CSGCAST_OK && strstr(text, "<svg") != NULL);
  CHECK(csgcast_section_json(&section, &text) == CSGCAST_OK && strstr(text, "\"loops\"") != NULL);
  CHECK(csgcast_section_polylines(&section, 1e-3, &lines) == CSGCAST_OK && lines.loops == 2);
  CHECK(csgcast_write_section(model, &section, "section.svg", 100) == CSGCAST_OK);
  csgcast_free_section(&section);
}

static void ask_for_pictures(const csgcast_model* model) {
  csgcast_camera camera = {{0, -9, 6}, {1, 1, 1}, {0, 0, 1}, 30, 0};
  csgcast_render_options options = CSGCAST_RENDER_OPTIONS;
  const size_t count = 20 * 10;
  float* depths = malloc(count * sizeof(float));
  options.width = 20;
  options.height = 10;
  options.mode = CSGCAST_DEPTH;
  options.camera = &camera;
  CHECK(csgcast_channels(options.mode) == 1);
  CHECK(csgcast_render(model, &options, NULL, depths, count) == CSGCAST_OK);
  CHECK(isinf(depths[0]) && depths[5 * 20 + 10] > 8 && depths[5 * 20 + 10] < 12);
  free(depths);
  CHECK(csgcast_render_file(model, &options, NULL, "picture.png") == CSGCAST_OK);
}

int main(void) {
  const char* text =
      "part(\"a\") { difference() { cube(2); translate([1, 1, 0]) { cylinder(9, r = 0.5, $fn = 50); } } }";
  const csgcast_options options = CSGCAST_OPTIONS;
  csgcast_model* model = NULL;
  csgcast_counts counts;
  csgcast_thin_place thin;
  csgcast_report report;
  double lower[3], upper[3];
  if (csgcast_read_with(text, strlen(text), "text", &options, &model) != CSGCAST_OK)
    return fprintf(stderr, "%s\n", csgcast_last_error()), 1;
  CHECK(csgcast_use_threads(2) == CSGCAST_OK);
  CHECK(csgcast_count(model, &counts) == CSGCAST_OK && counts.leaves == 2 && counts.parts == 1);
  CHECK(csgcast_bounds(model, lower, upper) == CSGCAST_OK && lower[0] <= 0 && upper[2] >= 2);
  CHECK(strcmp(csgcast_leaf_name(model, 0), "cube at text:1:28") == 0);
  CHECK(csgcast_thinnest(model, 50, NULL, &thin) == CSGCAST_OK && thin.is_found && thin.thickness < 0.6);
  CHECK(csgcast_check(model, NULL, &report) == CSGCAST_OK && report.overlap_count == 0 && !report.is_empty);
  csgcast_free_report(&report);
  ask_for_sections(model);
  ask_for_pictures(model);
  csgcast_free(model);
  return wrong;
}
