// SPDX-License-Identifier: MIT
#include "csg/text/statement/detail/statements.h"

#include "csg/text/statement/detail/look_statements.h"
#include "csg/text/statement/detail/operator_statements.h"
#include "csg/text/statement/detail/scene_statements.h"
#include "csg/text/statement/detail/solid_statements.h"
#include "csg/text/statement/detail/transform_statements.h"

namespace csgcast::text {
namespace {

/// With `$fn`, `$fa` and `$fs`: OpenSCAD lets all solids and operators have them, also where they mean nothing.
Parameters with_specials(std::vector<std::string_view> positional, std::vector<std::string_view> named = {}) {
  named.insert(named.end(), SpecialVariables::names.begin(), SpecialVariables::names.end());
  return {std::move(positional), std::move(named)};
}

void add_solids(std::vector<Statement>& table) {
  const auto add = [&](std::string_view name, Parameters parameters, Solid (*make)(const Call&)) {
    table.push_back({name, std::move(parameters), SolidStatement{make}, true});
  };
  add("cube", with_specials({"size", "center"}), make_cube);
  add("sphere", with_specials({"r"}, {"d"}), make_sphere);
  add("cylinder", with_specials({"h", "r1", "r2", "center"}, {"r", "d", "d1", "d2"}), make_cylinder);
  add("ellipsoid", with_specials({"r"}), make_ellipsoid);
  add("paraboloid", with_specials({"h", "r"}), make_paraboloid);
  add("hyperboloid", with_specials({"h", "r", "waist"}), make_hyperboloid);
  add("quadric", with_specials({"A", "b", "c"}), make_quadric);
  add("halfspace", with_specials({"n", "d"}), make_halfspace);
  add("convex", with_specials({}, {"points", "planes", "error"}), make_convex);
  add("polyhedron", with_specials({"points", "faces", "convexity"}, {"triangles"}), make_polyhedron);
}

void add_operators(std::vector<Statement>& table) {
  using enum OperatorStatement::Parts;
  const auto add = [&](std::string_view name, std::vector<std::string_view> positional, Combine (*make)(const Call&),
                       OperatorStatement::Parts parts = allowed) {
    table.push_back({name, with_specials(std::move(positional)), OperatorStatement{make, parts}});
  };
  add("union", {}, make_union);
  add("group", {}, make_union);
  add("render", {"convexity"}, make_render);
  add("difference", {}, make_difference, forbidden);
  add("intersection", {}, make_intersection, forbidden);
  add("complement", {}, make_complement, forbidden);
  add("part", {"name", "density"}, make_part, forbidden);
  add("color", {"c", "alpha"}, make_color);
  add("material",
      {"color", "ambient", "diffuse", "specular", "shininess", "reflection", "transmission", "ior", "emission",
       "absorption"},
      make_material);
}

void add_transforms(std::vector<Statement>& table) {
  const auto add = [&](std::string_view name, std::vector<std::string_view> positional, Combine (*make)(const Call&),
                       std::vector<std::string_view> named = {}) {
    table.push_back({name, with_specials(std::move(positional), std::move(named)), OperatorStatement{make}, true});
  };
  add("multmatrix", {"m"}, make_multmatrix, {"error"});
  add("translate", {"v"}, make_translate);
  add("rotate", {"a", "v"}, make_rotate);
  add("scale", {"v"}, make_scale);
  add("mirror", {"v"}, make_mirror);
}

void add_scene(std::vector<Statement>& table) {
  using enum SceneStatement::Count;
  const auto add = [&](std::string_view name, std::vector<std::string_view> positional,
                       void (*apply)(const Call&, SceneDescription&), SceneStatement::Count count) {
    table.push_back({name, {std::move(positional), {}}, SceneStatement{apply, count}});
  };
  add("camera", {"eye", "look_at", "up", "fov", "height"}, apply_camera, once);
  add("light", {"position", "direction", "color", "intensity", "falloff"}, apply_light, many);
  add("background", {"color", "image"}, apply_background, once);
  add("settings", {"max_depth", "min_contribution", "digits"}, apply_settings, once);
}

void add_unsupported(std::vector<Statement>& table) {
  for (const std::string_view name :
       {"hull", "minkowski", "linear_extrude", "rotate_extrude", "text", "square", "circle", "polygon", "import",
        "surface", "projection", "offset", "resize", "roof", "fill"}) {
    table.push_back({name, {}, UnsupportedStatement{}});
  }
}

const std::vector<Statement>& table() {
  static const std::vector<Statement> statements = [] {
    std::vector<Statement> result;
    add_solids(result);
    add_operators(result);
    add_transforms(result);
    add_scene(result);
    add_unsupported(result);
    return result;
  }();
  return statements;
}

}  // namespace

const Statement* find_statement(std::string_view name) {
  for (const Statement& statement : table()) {
    if (statement.name == name) return &statement;
  }
  return nullptr;
}

std::span<const std::string_view> statement_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> result;
    for (const Statement& statement : table()) {
      if (!std::holds_alternative<UnsupportedStatement>(statement.meaning)) result.push_back(statement.name);
    }
    return result;
  }();
  return names;
}

}  // namespace csgcast::text
