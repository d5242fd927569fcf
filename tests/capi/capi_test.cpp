// SPDX-License-Identifier: MIT
#include "bindings/c/csgcast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "tests/support/catch.h"

namespace {

struct ModelOwner {
  csgcast_model* model = nullptr;
  explicit ModelOwner(const std::string& text) {
    REQUIRE(csgcast_read(text.data(), text.size(), "text", &model) == CSGCAST_OK);
  }
  ~ModelOwner() { csgcast_free(model); }
};

bool last_error_has(const char* part) { return std::strstr(csgcast_last_error(), part) != nullptr; }

}  // namespace

TEST_CASE("C: intervals, points and measures of a text") {
  const ModelOwner owner("part(\"left\") { cube(1); }\ntranslate([2, 0, 0]) { sphere(1, $fn = 50); }");
  const std::vector<double> origins{-5, 0.5, 0.5, 0, 0, 9};
  const std::vector<double> directions{1, 0, 0, 0, 1, 0};
  csgcast_intervals table;
  REQUIRE(csgcast_cast(owner.model, 2, origins.data(), directions.data(), 0, HUGE_VAL, nullptr, &table) == CSGCAST_OK);
  CHECK(std::string(csgcast_last_error()).empty());
  REQUIRE(table.rays == 2);
  REQUIRE(table.count == 2);
  CHECK(table.offsets[1] == 2);
  CHECK(table.offsets[2] == 2);
  CHECK(table.t[0] == 5);
  CHECK(table.t[1] == 6);
  CHECK(table.parts[0] == 0);
  CHECK(table.parts[2] == CSGCAST_NONE);
  CHECK(table.normals[0] == -1);
  csgcast_free_intervals(&table);
  CHECK(table.memory == nullptr);
  csgcast_free_intervals(&table);
  csgcast_free_intervals(nullptr);

  const std::vector<double> points{0.5, 0.5, 0.5, 0, 0.5, 0.5, 9, 9, 9};
  std::vector<int8_t> where(3);
  REQUIRE(csgcast_locate(owner.model, 3, points.data(), nullptr, where.data()) == CSGCAST_OK);
  CHECK(where == std::vector<int8_t>{1, 0, -1});

  csgcast_measures measures;
  REQUIRE(csgcast_measure(owner.model, 1e-7, 1e-3, nullptr, &measures) == CSGCAST_OK);
  CHECK(measures.is_bounded == 1);
  CHECK(measures.is_as_asked == 1);
  const double volume = 1 + 4.0 / 3 * M_PI;
  CHECK(std::fabs(measures.volume - volume) <= measures.volume_error + 1e-14);
  CHECK(measures.lower[1] == Approx(-1).margin(1e-8));
  CHECK(measures.principal_error > 0);
  CHECK(measures.principal_error < 1e-4 * measures.principal_moments[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    // J v = l v, with J as the struct tells it.
    const double* v = measures.principal_axes + 3 * i;
    const double* j = measures.inertia;
    const double product = j[0] * v[0] + j[3] * v[1] + j[4] * v[2];
    CHECK(product == Approx(measures.principal_moments[i] * v[0]).margin(1e-12));
    CHECK(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] == Approx(1));
    CHECK(measures.principal_angles[i] > 0);
  }
}

TEST_CASE("C: first hits, any hits, parts, and measures of parts") {
  const ModelOwner owner(
      "part(\"left\", density = 2) { cube(1); }\npart(\"right\") { translate([2, 0, 0]) { cube([1, 1, 2]); } }");
  REQUIRE(csgcast_part_count(owner.model) == 2);
  CHECK(csgcast_part_count(nullptr) == 0);
  CHECK(std::string(csgcast_part_name(owner.model, 1)) == "right");
  CHECK(csgcast_part_density(owner.model, 0) == 2);
  CHECK(csgcast_part_name(owner.model, 2) == nullptr);
  CHECK(std::isnan(csgcast_part_density(owner.model, 2)));

  const std::vector<double> origins{-5, 0.5, 0.5, 0.5, 0.5, 0.5, 0, 0, 9};
  const std::vector<double> directions{1, 0, 0, 2, 0, 0, 0, 1, 0};
  double t[3];
  uint32_t surfaces[3];
  uint8_t is_entry[3];
  REQUIRE(csgcast_first_hits(owner.model, 3, origins.data(), directions.data(), 0, HUGE_VAL, nullptr, t, surfaces,
                             is_entry) == CSGCAST_OK);
  CHECK(t[0] == 5);
  CHECK(t[1] == 0.25);
  CHECK(std::isinf(t[2]));
  CHECK(surfaces[0] != CSGCAST_NONE);
  CHECK(surfaces[2] == CSGCAST_NONE);
  CHECK(is_entry[0] == 1);
  CHECK(is_entry[1] == 0);
  REQUIRE(csgcast_first_hits(owner.model, 3, origins.data(), directions.data(), 5.5, HUGE_VAL, nullptr, t, nullptr,
                             nullptr) == CSGCAST_OK);
  CHECK(t[0] == 6);
  uint8_t is_hit[3];
  REQUIRE(csgcast_any_hits(owner.model, 3, origins.data(), directions.data(), 0, 5, nullptr, is_hit) == CSGCAST_OK);
  CHECK(is_hit[0] == 0);
  CHECK(is_hit[1] == 1);
  CHECK(is_hit[2] == 0);
  CHECK(csgcast_any_hits(owner.model, 1, origins.data(), directions.data(), 0, 5, nullptr, nullptr) ==
        CSGCAST_BAD_INPUT);
  CHECK(csgcast_first_hits(owner.model, 1, nullptr, nullptr, 0, 5, nullptr, t, nullptr, nullptr) == CSGCAST_BAD_INPUT);

  csgcast_measures measures[3];
  REQUIRE(csgcast_measure_parts(owner.model, 1e-6, 1e-3, nullptr, measures) == CSGCAST_OK);
  CHECK(std::fabs(measures[0].mass - 4) <= measures[0].mass_error);
  CHECK(std::fabs(measures[1].mass - 2) <= measures[1].mass_error);
  CHECK(std::fabs(measures[2].volume - 2) <= measures[2].volume_error);
}

TEST_CASE("C: facets, welding and parts are chosen on loading") {
  const std::string text = "part(\"a\") { sphere(1, $fn = 100); }\npart(\"b\") { cube(1); }\nhalfspace([0, 0, 1], -5);";
  const char* const names[] = {"a"};
  const auto volume_with = [&](const csgcast_options& options) {
    csgcast_model* model = nullptr;
    REQUIRE(csgcast_read_with(text.data(), text.size(), "text", &options, &model) == CSGCAST_OK);
    csgcast_measures measures;
    CHECK(csgcast_part_count(model) == 1);
    REQUIRE(csgcast_measure(model, 1e-4, 1e-2, nullptr, &measures) == CSGCAST_OK);
    csgcast_free(model);
    return measures.volume;
  };
  const double round = volume_with({sizeof(csgcast_options), CSGCAST_FACETS_AUTO, -1, names, 1, 0});
  CHECK(round == Approx(4.0 / 3 * M_PI).epsilon(2e-4));
  CHECK(volume_with({sizeof(csgcast_options), CSGCAST_FACETS_NEVER, 0, names, 1, 0}) == Approx(round).epsilon(2e-4));
  CHECK(volume_with({sizeof(csgcast_options), CSGCAST_FACETS_ALWAYS, 1e-9, names, 1, 0}) < 0.999 * round);

  csgcast_model* model = nullptr;
  const char* const nobody[] = {"nobody"};
  csgcast_options wrong_part = CSGCAST_OPTIONS, wrong_weld = CSGCAST_OPTIONS, wrong_size = CSGCAST_OPTIONS;
  wrong_part.parts = nobody;
  wrong_part.part_count = 1;
  wrong_weld.weld = 3;
  wrong_size.size = 0;
  CHECK(csgcast_read_with(text.data(), text.size(), "text", &wrong_part, &model) == CSGCAST_BAD_INPUT);
  CHECK(last_error_has("no part is named 'nobody'"));
  CHECK(csgcast_read_with(text.data(), text.size(), "text", &wrong_weld, &model) == CSGCAST_BAD_INPUT);
  CHECK(csgcast_read_with(text.data(), text.size(), "text", &wrong_size, &model) == CSGCAST_BAD_INPUT);
  CHECK(last_error_has("size of the options"));
  REQUIRE(csgcast_read_with(text.data(), text.size(), "text", nullptr, &model) == CSGCAST_OK);
  CHECK(csgcast_part_count(model) == 2);
  csgcast_free(model);
  csgcast_options skipping = CSGCAST_OPTIONS;
  skipping.skip_unsupported = 1;
  const std::string hull = "hull() { cube(1); } cube(2);";
  CHECK(csgcast_read_with(hull.data(), hull.size(), "text", nullptr, &model) == CSGCAST_BAD_INPUT);
  REQUIRE(csgcast_read_with(hull.data(), hull.size(), "text", &skipping, &model) == CSGCAST_OK);
  csgcast_free(model);
  CHECK(csgcast_load_with("/nowhere", &wrong_weld, &model) == CSGCAST_BAD_INPUT);
  CHECK(model == nullptr);
}

namespace {

/// What a monitor is told, and when it cancels.
struct Told {
  std::vector<double> shares;
  double last_error = 0;
  std::size_t most = 1000;  // at this call it cancels

  csgcast_monitor monitor() { return {progress, this}; }
  static int progress(const csgcast_progress* now, void* data) {
    auto& told = *static_cast<Told*>(data);
    told.shares.push_back(now->share);
    told.last_error = now->relative_error;
    return told.shares.size() < told.most ? 1 : 0;
  }
};

}  // namespace

TEST_CASE("C: every function that takes a monitor tells it how far it is, and is cancelled by it") {
  const ModelOwner owner("part(\"left\") { cube(1); }\ntranslate([2, 0, 0]) { sphere(1, $fn = 50); }");
  constexpr std::size_t count = 20000;
  const std::vector<double> origins(3 * count, 0.25), directions(3 * count, 1);
  std::vector<double> t(count);
  std::vector<uint8_t> is_hit(count);
  std::vector<int8_t> where(count);
  csgcast_measures measures[2];
  using Monitor = const csgcast_monitor*;
  const csgcast_model* model = owner.model;
  const double *o = origins.data(), *d = directions.data();
  const std::vector<std::pair<std::string, std::function<csgcast_status(Monitor)>>> calls{
      {"cast",
       [&](Monitor monitor) {
         csgcast_intervals table;
         const csgcast_status status = csgcast_cast(model, count, o, d, 0, HUGE_VAL, monitor, &table);
         CHECK((table.memory != nullptr) == (status == CSGCAST_OK));
         csgcast_free_intervals(&table);
         return status;
       }},
      {"first_hits",
       [&](Monitor monitor) {
         return csgcast_first_hits(model, count, o, d, 0, HUGE_VAL, monitor, t.data(), nullptr, nullptr);
       }},
      {"any_hits",
       [&](Monitor monitor) { return csgcast_any_hits(model, count, o, d, 0, HUGE_VAL, monitor, is_hit.data()); }},
      {"locate", [&](Monitor monitor) { return csgcast_locate(model, count, o, monitor, where.data()); }},
      {"measure", [&](Monitor monitor) { return csgcast_measure(model, 1e-6, 1e-3, monitor, measures); }},
      {"measure_parts", [&](Monitor monitor) { return csgcast_measure_parts(model, 1e-6, 1e-3, monitor, measures); }},
      {"cut",
       [&](Monitor monitor) {
         const double plane[] = {0, 0.1, 1, 0.2};
         csgcast_section section;
         const csgcast_status status = csgcast_cut(model, plane, nullptr, monitor, &section);
         CHECK((section.memory != nullptr) == (status == CSGCAST_OK));
         csgcast_free_section(&section);
         return status;
       }},
      {"thinnest",
       [&](Monitor monitor) {
         csgcast_thin_place place;
         return csgcast_thinnest(model, 30, monitor, &place);
       }},
      {"check",
       [&](Monitor monitor) {
         csgcast_report report;
         const csgcast_status status = csgcast_check(model, monitor, &report);
         CHECK((report.memory != nullptr) == (status == CSGCAST_OK));
         csgcast_free_report(&report);
         return status;
       }},
      {"render",
       [&](Monitor monitor) {
         csgcast_render_options options = CSGCAST_RENDER_OPTIONS;
         options.width = 100;
         options.height = 80;
         std::vector<float> values(100 * 80 * 3);
         return csgcast_render(model, &options, monitor, values.data(), values.size());
       }},
  };
  for (const auto& [name, call] : calls) {
    INFO(name);
    Told all;
    const csgcast_monitor listens = all.monitor();
    REQUIRE(call(&listens) == CSGCAST_OK);
    REQUIRE(all.shares.size() >= 2);
    CHECK(std::is_sorted(all.shares.begin(), all.shares.end()));
    CHECK(all.shares.front() >= 0);
    CHECK(all.shares.back() == 1);
    Told some;
    some.most = 2;
    const csgcast_monitor cancels = some.monitor();
    CHECK(call(&cancels) == CSGCAST_CANCELLED);
    CHECK(some.shares.size() == 2);
    CHECK(std::isnan(some.last_error) == (name.find("measure") == std::string::npos));
    CHECK_FALSE(std::string(csgcast_last_error()).empty());
    const csgcast_monitor silent{};
    CHECK(call(&silent) == CSGCAST_OK);
    CHECK(call(nullptr) == CSGCAST_OK);
  }
}

TEST_CASE("C: what is wrong is said, and nothing else happens") {
  csgcast_model* model = reinterpret_cast<csgcast_model*>(1);
  CHECK(csgcast_load("/nowhere/at/all.csg", &model) == CSGCAST_BAD_INPUT);
  CHECK(model == nullptr);
  CHECK(last_error_has("/nowhere/at/all.csg"));
  CHECK(csgcast_read("teapot();", 9, "kitchen", &model) == CSGCAST_BAD_INPUT);
  CHECK(last_error_has("kitchen:1:1: error: "));
  CHECK(csgcast_read(nullptr, 0, "a", &model) == CSGCAST_BAD_INPUT);
  CHECK(csgcast_load(nullptr, &model) == CSGCAST_BAD_INPUT);
  csgcast_free(nullptr);

  const ModelOwner owner("cube(1);");
  const double zero[] = {0, 0, 0};
  csgcast_intervals table;
  CHECK(csgcast_cast(owner.model, 1, zero, zero, 0, HUGE_VAL, nullptr, &table) == CSGCAST_BAD_INPUT);
  CHECK(last_error_has("ray 0"));
  CHECK(table.memory == nullptr);
  CHECK(csgcast_cast(owner.model, 1, nullptr, zero, 0, HUGE_VAL, nullptr, &table) == CSGCAST_BAD_INPUT);
  CHECK(csgcast_cast(nullptr, 0, nullptr, nullptr, 0, HUGE_VAL, nullptr, &table) == CSGCAST_BAD_INPUT);
  CHECK(csgcast_cast(owner.model, 0, nullptr, nullptr, 0, HUGE_VAL, nullptr, &table) == CSGCAST_OK);
  CHECK(table.count == 0);
  csgcast_free_intervals(&table);
  csgcast_measures measures;
  CHECK(csgcast_measure(owner.model, -1, 1, nullptr, &measures) == CSGCAST_BAD_INPUT);
  CHECK(csgcast_locate(owner.model, 1, nullptr, nullptr, nullptr) == CSGCAST_BAD_INPUT);
  CHECK(std::string(csgcast_version()).size() >= 5);
}

TEST_CASE("C: names of leaves, counts and bounds") {
  const ModelOwner owner("cube(2);\ntranslate([9, 0, 0]) { sphere(1, $fn = 50); }");
  csgcast_counts counts;
  REQUIRE(csgcast_count(owner.model, &counts) == CSGCAST_OK);
  CHECK(counts.leaves == 2);
  CHECK(counts.surfaces == 7);
  CHECK(counts.parts == 0);
  CHECK(counts.cells > 0);
  CHECK(counts.bytes > 0);
  double lower[3], upper[3];
  REQUIRE(csgcast_bounds(owner.model, lower, upper) == CSGCAST_OK);
  CHECK(lower[1] == Approx(-1));
  CHECK(upper[0] == Approx(10));
  CHECK(std::string(csgcast_leaf_name(owner.model, 0)) == "cube at text:1:1");
  CHECK(std::string(csgcast_leaf_name(owner.model, 1)) == "sphere at text:2:24");
  CHECK(csgcast_leaf_name(owner.model, 2) == nullptr);
  CHECK(csgcast_leaf_name(nullptr, 0) == nullptr);
  CHECK(csgcast_count(nullptr, &counts) == CSGCAST_BAD_INPUT);
  CHECK(csgcast_bounds(owner.model, nullptr, upper) == CSGCAST_BAD_INPUT);
}

TEST_CASE("C: a section has arcs, drawings, polylines and files") {
  const ModelOwner owner("difference() { cube(2); translate([1, 1, 0]) { cylinder(9, r = 0.5, $fn = 50); } }");
  const double plane[] = {0, 0, 1, 1};
  csgcast_section section;
  REQUIRE(csgcast_cut(owner.model, plane, nullptr, nullptr, &section) == CSGCAST_OK);
  CHECK(section.is_bounded == 1);
  CHECK(section.is_closed == 1);
  CHECK(std::fabs(section.area - (4 - M_PI / 4)) <= section.area_error + 1e-14);
  CHECK(std::fabs(section.perimeter - (8 + M_PI)) <= section.perimeter_error + 1e-13);
  REQUIRE(section.loops == 2);
  CHECK(section.offsets[0] == 0);
  CHECK(section.origin[2] == 1);
  CHECK(section.u_axis[0] == 1);
  CHECK(section.v_axis[1] == 1);
  const std::size_t arcs = section.offsets[2];
  CHECK(arcs >= 6);
  CHECK(std::count_if(section.arcs, section.arcs + arcs, [](const csgcast_arc& arc) { return arc.conic[0] == 0; }) ==
        4);
  for (std::size_t i = 0; i < arcs; ++i) {
    const csgcast_arc& arc = section.arcs[i];
    CHECK(arc.surface != CSGCAST_NONE);
    for (const double* p : {arc.from, arc.middle, arc.to}) {
      const double* k = arc.conic;
      CHECK(std::fabs(k[0] * p[0] * p[0] + k[1] * p[0] * p[1] + k[2] * p[1] * p[1] + k[3] * p[0] + k[4] * p[1] + k[5]) <
            1e-9);
    }
  }
  const char* text = nullptr;
  REQUIRE(csgcast_section_svg(&section, 0, &text) == CSGCAST_OK);
  CHECK(std::strstr(text, "<path") != nullptr);
  REQUIRE(csgcast_section_json(&section, &text) == CSGCAST_OK);
  CHECK(std::strstr(text, "\"unbounded\": false") != nullptr);

  csgcast_polylines lines;
  REQUIRE(csgcast_section_polylines(&section, 1e-4, &lines) == CSGCAST_OK);
  REQUIRE(lines.loops == 2);
  std::size_t corners = 0;
  for (std::size_t loop = 0; loop < 2; ++loop) {
    const std::size_t first = lines.offsets[loop], last = lines.offsets[loop + 1] - 1;
    CHECK(lines.points[2 * first] == lines.points[2 * last]);
    if (last - first == 4) ++corners;
    for (std::size_t i = first; last - first != 4 && i <= last; ++i)
      CHECK(std::hypot(lines.points[2 * i] - 1, lines.points[2 * i + 1] - 1) == Approx(0.5));
  }
  CHECK(corners == 1);
  CHECK(csgcast_section_polylines(&section, 0, &lines) == CSGCAST_BAD_INPUT);

  const std::string path = (std::filesystem::temp_directory_path() / "csgcast_capi_section.svg").string();
  REQUIRE(csgcast_write_section(owner.model, &section, path.c_str(), 64) == CSGCAST_OK);
  CHECK(std::filesystem::file_size(path) > 100);
  std::filesystem::remove(path);
  CHECK(csgcast_write_section(owner.model, &section, "a.dxf", 64) == CSGCAST_BAD_INPUT);
  csgcast_free_section(&section);
  CHECK(section.memory == nullptr);
  csgcast_free_section(&section);
  csgcast_free_section(nullptr);
  CHECK(csgcast_section_json(&section, &text) == CSGCAST_BAD_INPUT);

  csgcast_section_options options = CSGCAST_SECTION_OPTIONS;
  options.relative_error = 1e-2;
  REQUIRE(csgcast_cut(owner.model, plane, &options, nullptr, &section) == CSGCAST_OK);
  csgcast_free_section(&section);
  const double nowhere[] = {0, 0, 0, 1};
  CHECK(csgcast_cut(owner.model, nowhere, nullptr, nullptr, &section) == CSGCAST_BAD_INPUT);
  CHECK(section.memory == nullptr);
}

TEST_CASE("C: the thinnest wall, and what may be wrong with a solid") {
  const ModelOwner owner(
      "part(\"a\") { cube(1); }\npart(\"b\") { translate([0.5, 0, 0]) { cube(1); } }\npart(\"c\") { intersection() { "
      "cube(1); translate([5, 0, 0]) { cube(1); } } }\ntranslate([0.2, 0.2, 0.2]) { cube(0.1); }\n");
  csgcast_thin_place place;
  REQUIRE(csgcast_thinnest(owner.model, 20, nullptr, &place) == CSGCAST_OK);
  CHECK(place.is_found == 1);
  CHECK(place.thickness == 1);
  CHECK(std::fabs(place.normal[0]) + std::fabs(place.normal[1]) + std::fabs(place.normal[2]) == 1);
  CHECK(place.leaf != CSGCAST_NONE);
  CHECK(csgcast_thinnest(owner.model, 0, nullptr, &place) == CSGCAST_BAD_INPUT);
  const ModelOwner unbounded("halfspace([0, 0, 1], 0);");
  REQUIRE(csgcast_thinnest(unbounded.model, 20, nullptr, &place) == CSGCAST_OK);
  CHECK(place.is_found == 0);
  CHECK(place.leaf == CSGCAST_NONE);

  csgcast_report report;
  REQUIRE(csgcast_check(owner.model, nullptr, &report) == CSGCAST_OK);
  REQUIRE(report.overlap_count == 1);
  CHECK(report.overlaps[0].first == 0);
  CHECK(report.overlaps[0].second == 1);
  CHECK(std::fabs(report.overlaps[0].volume - 0.5) <= report.overlaps[0].volume_error + 1e-15);
  CHECK(report.overlaps[0].place[0] >= 0.5);
  REQUIRE(report.empty_count == 1);
  CHECK(report.empty_parts[0] == 2);
  REQUIRE(report.redundancy_count >= 1);
  CHECK(std::any_of(report.redundancies, report.redundancies + report.redundancy_count,
                    [](const csgcast_redundancy& r) { return std::string(r.name) == "cube at text:4:30"; }));
  CHECK(std::strlen(report.redundancies[0].why) > 5);
  CHECK(report.redundancies[0].first_leaf < report.redundancies[0].leaf_end);
  CHECK(report.is_empty == 0);
  CHECK(report.unbounded_count == 0);
  csgcast_free_report(&report);
  CHECK(report.memory == nullptr);
  csgcast_free_report(&report);
  csgcast_free_report(nullptr);
  REQUIRE(csgcast_check(unbounded.model, nullptr, &report) == CSGCAST_OK);
  CHECK(report.is_unbounded == 1);
  csgcast_free_report(&report);
}

namespace {

std::vector<float> picture(const csgcast_model* model, const csgcast_render_options& options) {
  std::vector<float> values(static_cast<std::size_t>(options.width) * options.height * csgcast_channels(options.mode));
  REQUIRE(csgcast_render(model, &options, nullptr, values.data(), values.size()) == CSGCAST_OK);
  return values;
}

}  // namespace

TEST_CASE("C: pictures in memory and as files, under the scene's view or another") {
  const std::string scene = "part(\"a\") { sphere(1, $fn = 50); }";
  const std::string light = "light(direction = [0, 1, -1], color = [1, 0.5, 0], intensity = 2);\n";
  const std::string camera = "camera(eye = [0, -9, 3], look_at = [0, 0, 0], fov = 20);\n";
  const ModelOwner plain(scene), lit(light + camera + "background(color = [0.5, 0, 0.25]);\n" + scene);
  csgcast_render_options options = CSGCAST_RENDER_OPTIONS;
  options.width = 40;
  options.height = 30;
  CHECK(picture(plain.model, options) != picture(lit.model, options));
  const std::vector<float> want = picture(lit.model, options);
  CHECK(want.size() == 40 * 30 * 3);
  CHECK(want[0] == 0.5F);

  const csgcast_camera seen{{0, -9, 3}, {0, 0, 0}, {0, 0, 1}, 20, 0};
  const csgcast_light lights[] = {{1, {0, 1, -1}, {1, 0.5, 0}, 2, 0}};
  const double background[] = {0.5, 0, 0.25};
  csgcast_render_options changed = options;
  changed.camera = &seen;
  changed.lights = lights;
  changed.light_count = 1;
  changed.background = background;
  CHECK(picture(plain.model, changed) == want);
  changed.light_count = 0;
  CHECK(picture(plain.model, changed) != want);

  csgcast_render_options adaptive = options;
  adaptive.samples = 9;
  const std::vector<float> regular = picture(lit.model, adaptive);
  adaptive.is_adaptive = 1;
  CHECK(picture(lit.model, adaptive) != regular);
  csgcast_render_options depth = options;
  depth.mode = CSGCAST_DEPTH;
  CHECK(picture(lit.model, depth).size() == 40 * 30);
  CHECK(std::isinf(picture(lit.model, depth)[0]));
  CHECK(csgcast_channels(CSGCAST_NORMAL) == 3);
  CHECK(csgcast_channels(static_cast<csgcast_mode>(6)) == 0);

  // An older program's options end earlier; a newer one's are refused if this version does not know them.
  csgcast_render_options older = changed;
  older.size = offsetof(csgcast_render_options, lights);
  older.lights = reinterpret_cast<const csgcast_light*>(1);  // not looked at
  CHECK_FALSE(picture(plain.model, older).empty());
  struct Newer {
    csgcast_render_options known = CSGCAST_RENDER_OPTIONS;
    double unknown = 0;
  } newer;
  newer.known.size = sizeof(Newer);
  newer.known.width = newer.known.height = 8;
  CHECK(picture(plain.model, newer.known).size() == 8 * 8 * 3);
  newer.unknown = 1;
  std::vector<float> room(8 * 8 * 3);
  CHECK(csgcast_render(plain.model, &newer.known, nullptr, room.data(), room.size()) == CSGCAST_BAD_INPUT);
  CHECK(last_error_has("does not know"));

  CHECK(csgcast_render(plain.model, nullptr, nullptr, room.data(), room.size()) == CSGCAST_BAD_INPUT);
  CHECK(last_error_has("room for"));
  options.mode = static_cast<csgcast_mode>(9);
  CHECK(csgcast_render(plain.model, &options, nullptr, room.data(), 0) == CSGCAST_BAD_INPUT);
  options.mode = CSGCAST_SHADED;
  const std::string path = (std::filesystem::temp_directory_path() / "csgcast_capi_picture.png").string();
  REQUIRE(csgcast_render_file(plain.model, &options, nullptr, path.c_str()) == CSGCAST_OK);
  std::string start(4, '\0');
  std::ifstream(path, std::ios::binary).read(start.data(), 4);
  CHECK(start == "\x89PNG");
  std::filesystem::remove(path);
  CHECK(csgcast_render_file(plain.model, &options, nullptr, "a.stl") == CSGCAST_BAD_INPUT);
}

TEST_CASE("C: a thread says on how many its calls work, and gets the same") {
  const ModelOwner owner("difference() { cube(2); sphere(1, $fn = 50); }");
  csgcast_render_options options = CSGCAST_RENDER_OPTIONS;
  options.width = 90;
  options.height = 70;
  const std::vector<float> want = picture(owner.model, options);
  for (const int threads : {1, 3}) {
    REQUIRE(csgcast_use_threads(threads) == CSGCAST_OK);
    CHECK(picture(owner.model, options) == want);
  }
  CHECK(csgcast_use_threads(-1) == CSGCAST_BAD_INPUT);
  CHECK(csgcast_use_threads(0) == CSGCAST_OK);
}

TEST_CASE("C: the thickness where rays enter") {
  const ModelOwner owner("cube([2, 3, 4]);");
  const double origins[6] = {-1, 1, 1, 9, 9, 9};
  const double directions[6] = {1, 0, 0, 1, 0, 0};
  double result[2] = {-1, -1};
  REQUIRE(csgcast_thickness(owner.model, 2, origins, directions, nullptr, result) == CSGCAST_OK);
  CHECK(result[0] == 2);
  CHECK(result[1] == 0);
  CHECK(csgcast_thickness(nullptr, 2, origins, directions, nullptr, result) == CSGCAST_BAD_INPUT);
}
