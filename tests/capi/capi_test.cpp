// SPDX-License-Identifier: MIT
#include "capi/csgcast.h"

#include <cmath>
#include <cstring>
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
  REQUIRE(csgcast_cast(owner.model, 2, origins.data(), directions.data(), 0, HUGE_VAL, &table) == CSGCAST_OK);
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
  REQUIRE(csgcast_locate(owner.model, 3, points.data(), where.data()) == CSGCAST_OK);
  CHECK(where == std::vector<int8_t>{1, 0, -1});

  csgcast_measures measures;
  REQUIRE(csgcast_measure(owner.model, 1e-7, 1e-3, &measures) == CSGCAST_OK);
  CHECK(measures.is_bounded == 1);
  CHECK(measures.is_as_asked == 1);
  const double volume = 1 + 4.0 / 3 * M_PI;
  CHECK(std::fabs(measures.volume - volume) <= measures.volume_error + 1e-14);
  CHECK(measures.lower[1] == Approx(-1).margin(1e-8));
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
  CHECK(csgcast_cast(owner.model, 1, zero, zero, 0, HUGE_VAL, &table) == CSGCAST_BAD_INPUT);
  CHECK(last_error_has("ray 0"));
  CHECK(table.memory == nullptr);
  CHECK(csgcast_cast(owner.model, 1, nullptr, zero, 0, HUGE_VAL, &table) == CSGCAST_BAD_INPUT);
  CHECK(csgcast_cast(nullptr, 0, nullptr, nullptr, 0, HUGE_VAL, &table) == CSGCAST_BAD_INPUT);
  CHECK(csgcast_cast(owner.model, 0, nullptr, nullptr, 0, HUGE_VAL, &table) == CSGCAST_OK);
  CHECK(table.count == 0);
  csgcast_free_intervals(&table);
  csgcast_measures measures;
  CHECK(csgcast_measure(owner.model, -1, 1, &measures) == CSGCAST_BAD_INPUT);
  CHECK(csgcast_locate(owner.model, 1, nullptr, nullptr) == CSGCAST_BAD_INPUT);
  CHECK(std::string(csgcast_version()).size() >= 5);
}
