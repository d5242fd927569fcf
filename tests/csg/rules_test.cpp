// SPDX-License-Identifier: MIT
#include "csg/solid/rules/rules.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "csg/base/error.h"
#include "csg/solid/primitives.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "tests/support/catch.h"

using namespace csgcast;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string problem_of(const std::string& text) {
  try {
    text::build(text::read(text, "a"));
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::bad_value);
    return error.what();
  }
  return "";
}

template <class Call>
std::string problem_of_call(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::bad_value);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("code refuses of a part what a scene text refuses, and both say the same") {
  const std::string empty_name = "'name' of 'part' must not be empty";
  const std::string negative = "'density' of 'part' must not be negative";
  CHECK(problem_of("part(\"\") { cube(1); }").find(empty_name) != std::string::npos);
  CHECK(problem_of("part(\"a\", -1) { cube(1); }").find(negative) != std::string::npos);
  CHECK(problem_of_call([] { named(sphere(1), {"", 1}); }).find(empty_name) != std::string::npos);
  CHECK(problem_of_call([] { named(sphere(1), {"a", -1}); }).find(negative) != std::string::npos);
  for (const double density : {infinite, -infinite, none})
    CHECK(problem_of_call([&] { named(sphere(1), {"a", density}); }).find("'density'") != std::string::npos);
  CHECK(named(sphere(1), {"a", 0}).part().density == 0);
}

TEST_CASE("code refuses of a look what a scene text refuses") {
  const auto problem_with = [](auto&& spoil) {
    Material material;
    spoil(material);
    return problem_of_call([&] { with_look(sphere(1), {material, {}}); });
  };
  CHECK(problem_with([](Material&) {}).empty());
  CHECK(problem_with([](Material& m) { m.ambient = -1; }).find("'ambient' of 'material' must not be negative") !=
        std::string::npos);
  CHECK_FALSE(problem_with([](Material& m) { m.diffuse = none; }).empty());
  CHECK_FALSE(problem_with([](Material& m) { m.specular = infinite; }).empty());
  CHECK_FALSE(problem_with([](Material& m) { m.shininess = -1; }).empty());
  CHECK_FALSE(problem_with([](Material& m) { m.reflection = 1.5; }).empty());
  CHECK_FALSE(problem_with([](Material& m) { m.transmission = none; }).empty());
  CHECK_FALSE(problem_with([](Material& m) { m.ior = 0; }).empty());
  CHECK_FALSE(problem_with([](Material& m) { m.color.g = -1; }).empty());
  CHECK_FALSE(problem_with([](Material& m) { m.emission.r = infinite; }).empty());
  CHECK_FALSE(problem_with([](Material& m) { m.absorption.b = none; }).empty());
  CHECK_FALSE(problem_of_call([] { with_look(sphere(1), {{}, Paint{{0, 0, 2}, 1}}); }).empty());
  CHECK_FALSE(problem_of_call([] { with_look(sphere(1), {{}, Paint{{0, 0, 1}, none}}); }).empty());
  CHECK(problem_of("material(ior = 0) { cube(1); }").find("'ior' of 'material' must be greater than 0") !=
        std::string::npos);
}

TEST_CASE("lights and settings have rules of their own") {
  LightDescription light;
  CHECK(broken_rule(light));
  light.position = Point{0, 0, 1};
  CHECK_FALSE(broken_rule(light));
  light.falloff = 0;
  CHECK(broken_rule(light));
  light.falloff = 2;
  CHECK_FALSE(broken_rule(light));
  light.direction = Vector{0, 0, 1};
  CHECK(broken_rule(light));
  light.position.reset();
  CHECK(std::string(broken_rule(light)->argument) == "falloff");
  light.falloff.reset();
  CHECK_FALSE(broken_rule(light));
  light.direction = Vector{0, none, 1};
  CHECK(broken_rule(light));
  CHECK_FALSE(broken_rule(RenderSettings{}));
  CHECK(broken_rule(RenderSettings{101, 0.5}));
  CHECK(broken_rule(RenderSettings{5, none}));
  CHECK(problem_of("settings(max_depth = 2.5);").find("be a whole number from 0 to 100") != std::string::npos);
  CHECK(problem_of("settings(max_depth = 1e9);").find("be a whole number from 0 to 100") != std::string::npos);
}
