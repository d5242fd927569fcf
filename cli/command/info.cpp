// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

#include "cli/command/commands.h"
#include "cli/input/distinct_files.h"
#include "cli/input/scene_input.h"
#include "cli/output/camera_text.h"
#include "cli/output/format.h"
#include "cli/output/json.h"
#include "cli/output/labelled_row.h"
#include "cli/output/output.h"
#include "cli/output/printable.h"
#include "cli/output/quadric_json.h"
#include "cli/output/scene_summary.h"
#include "cli/output/weld_lines.h"
#include "csg/base/number_text.h"
#include "raycast/packets/threads.h"

namespace csgcast::cli {
namespace {

struct InfoOptions {
  SceneOptions scene;
  Format format = Format::table;
  std::string output;
};

/// All that the two formats tell.
struct Info {
  const FileName& file;
  const StatementSummary& statements;
  const SceneInput& input;
  SurfaceSummary surfaces = summarise_surfaces(input.scene);
  LeafSummary leaves = summarise_leaves(input.scene);
};

std::string components(const Rgb& c) { return coordinates(Vector{c.r, c.g, c.b}); }

void json_tally(Json& json, const char* name, const Tally& tally) {
  json.key(name).begin_object(Json::Layout::compact);
  for (const auto& [word, count] : tally) json.member(word, count);
  json.end_object();
}

std::string bounds_line(const Box& bounds) {
  if (bounds.is_null()) return "empty";
  const std::string text = fmt::format("{}  to  {}", coordinates(bounds.lower), coordinates(bounds.upper));
  return bounds.is_finite() ? fmt::format("{}  (size {})", text, coordinates(bounds.size())) : text + "  (unbounded)";
}

std::string camera_line(const std::optional<CameraDescription>& camera) {
  return camera ? camera_text(*camera) : "none (a default one frames the solid)";
}

std::string light_line(const LightDescription& light) {
  std::string text = light.position ? "at " + coordinates(*light.position) : "";
  if (light.direction) text += "along " + coordinates(*light.direction);
  text += fmt::format("  color {}  intensity {}", components(light.color), number(light.intensity));
  return light.falloff ? fmt::format("{}  falloff {}", text, number(*light.falloff)) : text;
}

std::string background_line(const SceneDescription& description) {
  if (description.background_image) return "image " + printable(description.background_image->path);
  return description.background ? components(*description.background) : "default";
}

std::string as_text(const Info& info) {
  const Scene& scene = info.input.scene;
  const SceneDescription& description = info.input.description;
  std::string out;
  append_row(out, "file", printable(info.file.string()));
  append_row(out, "statements", fmt::format("{}: {}", info.statements.total, list(info.statements.by_name)));
  for (const auto& [name, lines] : info.statements.unsupported) {
    const std::uint64_t count = info.statements.unsupported_by_name.at(name);
    append_row(out, "left out",
               fmt::format("{} {}, not supported yet: line{} {}{}", name, count, count == 1 ? "" : "s",
                           fmt::join(lines, ", "), lines.size() < count ? ", .." : ""));
  }
  if (info.input.description.faceted > 0) append_row(out, "facets", faceted_line(info.input.description.faceted));
  append_row(out, "depth", fmt::format("{}", info.statements.depth));
  append_row(out, "leaves", fmt::format("{}: {}", scene.leaves().size(), list(info.leaves.by_kind)));
  append_row(out, "surfaces",
             fmt::format("{}: planes {}, quadrics {}{}; shared by several leaves {}", scene.surfaces().size(),
                         info.surfaces.planes, info.surfaces.quadrics,
                         info.surfaces.others > 0 ? fmt::format(", others {}", info.surfaces.others) : "",
                         info.surfaces.shared));
  if (info.surfaces.quadrics > 0) append_row(out, "quadrics", list(info.surfaces.quadrics_by_kind));
  append_welding(out, scene.weld_report());
  append_row(out, "tree", fmt::format("{} nodes after simplification, leaves included", scene.nodes().size()));
  append_row(out, "parts", fmt::format("{}", scene.parts().size()));
  for (std::size_t i = 0; i < scene.parts().size(); ++i) {
    const Part& part = scene.parts()[i];
    append_row(out, "",
               fmt::format("{} at {}:{}  density {}  leaves {}", printable(part.name.name), part.place.line,
                           part.place.column, number(part.name.density), info.leaves.by_part[i]));
  }
  append_row(out, "regions", fmt::format("{} (runs of one part and look)", scene.regions().size()));
  append_row(out, "looks",
             fmt::format("{}{}", scene.looks().size(), scene.transmits() ? ", some let light through" : ""));
  append_row(out, "bounds", bounds_line(scene.bounds()));
  append_row(out, "camera", camera_line(description.camera));
  append_row(out, "lights",
             description.lights.empty() ? "none (a default one is beside the camera)"
                                        : fmt::format("{}", description.lights.size()));
  for (const LightDescription& light : description.lights) append_row(out, "", light_line(light));
  append_row(out, "background", background_line(description));
  append_row(out, "settings",
             fmt::format("max_depth {}, min_contribution {}", description.settings.max_depth,
                         number(description.settings.min_contribution)));
  if (description.digits.are_few())
    append_row(out, "digits",
               fmt::format("{}: a number that uses all of them is known to half a unit of its last",
                           description.digits.count()));
  append_row(out, "warnings", fmt::format("{}", description.warnings.size()));
  append_row(out, "seconds",
             fmt::format("read {:.3f}, compile {:.3f}", info.input.read_seconds, info.input.compile_seconds));
  return out;
}

void json_parts(Json& json, const Info& info) {
  const auto parts = info.input.scene.parts();
  json.key("parts").begin_array();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    json.begin_object(Json::Layout::compact).member("name", parts[i].name.name);
    json.member("density", parts[i].name.density);
    json.member("place", fmt::format("{}:{}", parts[i].place.line, parts[i].place.column));
    json.member("leaves", info.leaves.by_part[i]).end_object();
  }
  json.end_array();
}

/// Sides at infinity are null.
void json_bounds(Json& json, const Box& bounds) {
  json.key("bounds").begin_object(Json::Layout::compact).member("empty", bounds.is_null());
  json.member("unbounded", !bounds.is_null() && !bounds.is_finite());
  json.member("lower", bounds.lower).member("upper", bounds.upper).end_object();
}

void json_camera(Json& json, const std::optional<CameraDescription>& camera) {
  json.key("camera");
  if (!camera) {
    json.null();
    return;
  }
  json.begin_object(Json::Layout::compact).member("eye", camera->eye).member("look_at", camera->look_at);
  json.member("up", camera->up);
  camera->height ? json.member("height", *camera->height) : json.member("fov", camera->fov);
  json.end_object();
}

void json_lights(Json& json, const std::vector<LightDescription>& lights) {
  json.key("lights").begin_array();
  for (const LightDescription& light : lights) {
    json.begin_object(Json::Layout::compact);
    if (light.position) json.member("position", *light.position);
    if (light.direction) json.member("direction", *light.direction);
    json.member("color", light.color).member("intensity", light.intensity);
    if (light.falloff) json.member("falloff", *light.falloff);
    json.end_object();
  }
  json.end_array();
}

void json_environment(Json& json, const SceneDescription& description) {
  json_camera(json, description.camera);
  json_lights(json, description.lights);
  json.key("background");
  description.background ? json.value(*description.background) : json.null();
  if (description.background_image) json.member("background_image", description.background_image->path);
  json.key("settings").begin_object(Json::Layout::compact);
  json.member("max_depth", std::uint64_t(description.settings.max_depth));
  json.member("min_contribution", description.settings.min_contribution);
  json.member("digits", std::uint64_t(description.digits.count())).end_object();
  json.key("warnings").begin_array();
  for (const Warning& warning : description.warnings) json.value(to_string(warning));
  json.end_array();
}

std::string as_json(const Info& info) {
  const Scene& scene = info.input.scene;
  std::string out;
  Json json(out);
  json.begin_object().member("file", info.file.string());
  json.member("statements", info.statements.total).member("depth", info.statements.depth);
  json_tally(json, "statements_by_name", info.statements.by_name);
  json.key("unsupported").begin_array();
  for (const auto& [name, lines] : info.statements.unsupported) {
    json.begin_object(Json::Layout::compact).member("name", name);
    json.member("count", info.statements.unsupported_by_name.at(name)).key("lines").begin_array();
    for (const int line : lines) json.value(std::uint64_t(line));
    json.end_array().end_object();
  }
  json.end_array().member("faceted", info.input.description.faceted);
  json.member("leaves", std::uint64_t(scene.leaves().size()));
  json_tally(json, "leaves_by_kind", info.leaves.by_kind);
  json.key("surfaces").begin_object(Json::Layout::compact).member("planes", info.surfaces.planes);
  json.member("quadrics", info.surfaces.quadrics);
  if (info.surfaces.others > 0) json.member("others", info.surfaces.others);
  json.member("shared", info.surfaces.shared).end_object();
  json_tally(json, "quadrics_by_kind", info.surfaces.quadrics_by_kind);
  json_quadrics(json, scene);
  json_welding(json, scene.weld_report());
  json.member("nodes", std::uint64_t(scene.nodes().size()));
  json_parts(json, info);
  json.member("regions", std::uint64_t(scene.regions().size()));
  json.member("looks", std::uint64_t(scene.looks().size())).member("transmits", scene.transmits());
  json_bounds(json, scene.bounds());
  json_environment(json, info.input.description);
  json.key("seconds").begin_object(Json::Layout::compact).member("read", info.input.read_seconds);
  json.member("compile", info.input.compile_seconds).end_object().end_object();
  return out + '\n';
}

void run(const InfoOptions& options) {
  check_distinct(std::array{NamedFile{"the scene", options.scene.path}}, std::array{NamedFile{"-o", options.output}});
  Output output(options.output);
  SceneOptions scene_options = options.scene;
  scene_options.welding.lists_near_misses = scene_options.welding.mode != Welding::Mode::off;
  scene_options.skips_unsupported = true;  // they are listed
  DocumentInput document = read_document(scene_options);
  const FileName file = document.document.file;
  const StatementSummary statements = summarise_statements(document.document);
  const SceneInput input = compile_document(std::move(document), scene_options);
  const Info info{file, statements, input};
  output.write(options.format == Format::json ? as_json(info) : as_text(info));
  output.commit();
}

}  // namespace

Command info_command() {
  auto options = std::make_shared<InfoOptions>();
  Command command{.name = "info", .summary = "Tell what a scene holds"};
  command.add(choice<Format>("--format", options->format, "The format of the output",
                             {{"table", Format::table}, {"json", Format::json}}));
  command.add(output_option(options->output));
  add_scene_options(command, options->scene);
  command.examples = {"csgcast info part.csg", "csgcast info part.csg --format json"};
  command.run = [options] { on_threads(options->scene.threads, [&] { run(*options); }); };
  return command;
}

}  // namespace csgcast::cli
