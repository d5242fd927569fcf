// SPDX-License-Identifier: MIT
#include "bindings/c/csgcast.h"

#include <algorithm>
#include <cmath>
#include <cstring>
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
    REQUIRE(csgcast_measure(model, 1e-6, 1e-2, nullptr, &measures) == CSGCAST_OK);
    csgcast_free(model);
    return measures.volume;
  };
  const double round = volume_with({CSGCAST_FACETS_AUTO, -1, names, 1});
  CHECK(round == Approx(4.0 / 3 * M_PI).epsilon(1e-5));
  CHECK(volume_with({CSGCAST_FACETS_NEVER, 0, names, 1}) == Approx(round).epsilon(1e-5));
  CHECK(volume_with({CSGCAST_FACETS_ALWAYS, 1e-9, names, 1}) < 0.9999 * round);

  csgcast_model* model = nullptr;
  const char* const nobody[] = {"nobody"};
  const csgcast_options wrong_part{CSGCAST_FACETS_AUTO, -1, nobody, 1}, wrong_weld{CSGCAST_FACETS_AUTO, 3, nullptr, 0};
  CHECK(csgcast_read_with(text.data(), text.size(), "text", &wrong_part, &model) == CSGCAST_BAD_INPUT);
  CHECK(last_error_has("no part is named 'nobody'"));
  CHECK(csgcast_read_with(text.data(), text.size(), "text", &wrong_weld, &model) == CSGCAST_BAD_INPUT);
  CHECK(csgcast_read_with(text.data(), text.size(), "text", nullptr, &model) == CSGCAST_BAD_INPUT);
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
