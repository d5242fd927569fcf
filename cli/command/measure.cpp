// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "cli/command/commands.h"
#include "cli/input/distinct_files.h"
#include "cli/input/options.h"
#include "cli/input/scene_input.h"
#include "cli/output/format.h"
#include "cli/output/json.h"
#include "cli/output/labelled_row.h"
#include "cli/output/opening_text.h"
#include "cli/output/output.h"
#include "cli/output/printable.h"
#include "cli/output/stopwatch.h"
#include "cli/output/usage.h"
#include "csg/base/number_text.h"
#include "measure/measure.h"
#include "raycast/packets/threads.h"

namespace csgcast::cli {
namespace {

struct MeasureCommand {
  SceneOptions scene;
  std::string relative_error = "1e-4";
  std::string area_error = "1e-3";
  Format format = Format::table;
  std::string output;
};

/// Of areas: they may be left open.
double parse_area_error(const std::string& text) {
  if (text == "inf") return HUGE_VAL;
  const double share = parse_numbers("--area-error", text, 1)[0];
  if (!(share > 0 && share < 1))
    throw UsageError(fmt::format("--area-error {} is neither between 0 and 1 nor inf", text));
  return share;
}

constexpr std::array<const char*, 6> inertia_names{"xx", "yy", "zz", "xy", "xz", "yz"};

double parse_share(const std::string& option, const std::string& text) {
  const double share = parse_numbers(option, text, 1)[0];
  if (!(share > 0 && share < 1)) throw UsageError(fmt::format("{} {} is not between 0 and 1", option, text));
  return share;
}

/// A number with as many digits as it is certain of, and one more.
std::string certain_digits(double value, double error) {
  if (std::isinf(error)) return "unknown";
  if (!std::isfinite(value) || !(error > 0)) return number(value);
  if (std::fabs(value) <= error) return "0";
  const int digits = static_cast<int>(std::ceil(std::log10(std::fmax(std::fabs(value) / error, 1)))) + 1;
  const std::string text = fmt::format("{:.{}g}", value, std::min(digits, 17));
  return text == "-0" ? "0" : text;
}

std::string with_error(double value, double error) {
  if (error == 0) return number(value);
  return fmt::format("{} ± {:.2g}", certain_digits(value, error), error);
}

std::string with_error(Measured m) { return with_error(m.value, m.error); }

template <class Triple>
std::string coordinates(const Triple& t, double error) {
  return fmt::format("{}, {}, {}", certain_digits(t.x, error), certain_digits(t.y, error), certain_digits(t.z, error));
}

/// The moments about the centroid, each with its axis and what that may be turned by.
void append_principal(std::string& out, const Measures& m) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = m.principal_angles[i];
    append_row(
        out, i == 0 ? "principal" : "",
        fmt::format("{} about {}", with_error(m.principal_moments[i], m.principal_error),
                    std::isinf(angle) ? std::string("an undetermined axis")
                                      : fmt::format("{}  ± {:.2g} radians",
                                                    coordinates(m.principal_axes[i], std::fmax(angle, 1e-16)), angle)));
  }
}

void append_measures(std::string& out, const Scene& scene, const Measures& m) {
  if (!m.is_bounded)
    return append_row(out, "volume", fmt::format("none: the solid {}; measured are parts", opening_text(scene)));
  append_row(out, "volume", with_error(m.volume));
  append_row(out, "area", with_error(m.area));
  append_row(out, "mass", with_error(m.mass));
  if (m.mass.value > 0) {
    append_row(out, "centroid",
               fmt::format("{}  ± {:.2g} each", coordinates(m.centroid, m.centroid_error), m.centroid_error));
    std::string inertia;
    for (std::size_t i = 0; i < inertia_names.size(); ++i)
      inertia += fmt::format("{} {}  ", inertia_names[i], certain_digits(m.inertia[i], m.inertia_error));
    append_row(out, "inertia", fmt::format("{}± {:.2g} each", inertia, m.inertia_error));
    append_principal(out, m);
  }
  append_row(out, "bounds",
             m.bounds.is_null() ? "empty"
                                : fmt::format("{}  to  {}  ± {:.2g}", coordinates(m.bounds.lower, m.bounds_error),
                                              coordinates(m.bounds.upper, m.bounds_error), m.bounds_error));
  append_row(out, "cells", fmt::format("{}", m.pieces));
  if (!m.is_as_asked)
    append_row(out, "errors", "greater than asked for: more cells would not help, or would be too many");
}

std::string as_text(const Scene& scene, const SceneMeasures& measures) {
  std::string out;
  append_measures(out, scene, measures.whole);
  for (std::size_t i = 0; i < measures.parts.size(); ++i) {
    const PartName& part = scene.parts()[i].name;
    out += fmt::format("\npart {}, density {}\n", printable(part.name), number(part.density));
    append_measures(out, scene, measures.parts[i]);
  }
  return out;
}

void json_measures(Json& json, const Measures& m) {
  json.member("unbounded", !m.is_bounded);
  json.member("volume", m.volume.value).member("volume_error", m.volume.error);
  json.member("area", m.area.value).member("area_error", m.area.error);
  json.member("mass", m.mass.value).member("mass_error", m.mass.error);
  json.member("centroid", m.centroid).member("centroid_error", m.centroid_error);
  json.key("inertia").begin_object(Json::Layout::compact);
  for (std::size_t i = 0; i < inertia_names.size(); ++i) json.member(inertia_names[i], m.inertia[i]);
  json.end_object().member("inertia_error", m.inertia_error);
  json.key("principal").begin_array();
  for (std::size_t i = 0; i < 3; ++i) {
    json.begin_object(Json::Layout::compact).member("moment", m.principal_moments[i]);
    json.key("axis");
    std::isinf(m.principal_angles[i]) ? json.null() : json.value(m.principal_axes[i]);
    json.member("axis_error", m.principal_angles[i]).end_object();
  }
  json.end_array().member("principal_error", m.principal_error);
  json.key("bounds").begin_object(Json::Layout::compact).member("empty", m.bounds.is_null());
  json.member("lower", m.bounds.lower).member("upper", m.bounds.upper).end_object();
  json.member("bounds_error", m.bounds_error).member("cells", std::uint64_t(m.pieces));
  json.member("as_asked", m.is_as_asked);
}

std::string as_json(const Scene& scene, const SceneMeasures& measures, double seconds) {
  std::string out;
  Json json(out);
  json.begin_object();
  json_measures(json, measures.whole);
  json.member("seconds", seconds).key("parts").begin_array();
  for (std::size_t i = 0; i < measures.parts.size(); ++i) {
    const PartName& part = scene.parts()[i].name;
    json.begin_object().member("name", part.name).member("density", part.density);
    json_measures(json, measures.parts[i]);
    json.end_object();
  }
  json.end_array().end_object();
  return out + '\n';
}

void run(const MeasureCommand& command) {
  MeasureOptions job;
  job.relative_error = parse_share("--relative-error", command.relative_error);
  job.relative_area_error = parse_area_error(command.area_error);
  check_distinct(std::array{NamedFile{"the scene", command.scene.path}}, std::array{NamedFile{"-o", command.output}});
  Output output(command.output);
  const SceneInput input = read_scene(command.scene);
  const Stopwatch watch;
  SceneMeasures measures;
  {
    ProgressBar bar("measuring", command.scene.progress());
    job.progress = bar.callback();
    measures = measure(input.scene, job);
  }
  if (command.format == Format::json) {
    output.write(as_json(input.scene, measures, watch.seconds()));
  } else {
    std::string text = as_text(input.scene, measures);
    if (input.description.faceted > 0) append_row(text, "facets", faceted_line(input.description.faceted));
    output.write(text);
  }
  output.commit();
}

}  // namespace

Command measure_command() {
  auto options = std::make_shared<MeasureCommand>();
  Command command{.name = "measure",
                  .summary = "Measure volume, area, mass, centroid, inertia and bounds, with error bounds"};
  command.add({.names = "--relative-error",
               .value = "E",
               .help = "The error of the volume that is asked for, divided by the volume",
               .preset = options->relative_error,
               .take = into(options->relative_error)});
  command.add({.names = "--area-error",
               .value = "E",
               .help = "The error of the area that is asked for, divided by the area; inf allows any",
               .preset = options->area_error,
               .take = into(options->area_error)});
  command.add(choice<Format>("--format", options->format, "The format of the output",
                             {{"table", Format::table}, {"json", Format::json}}));
  command.add(output_option(options->output));
  add_scene_options(command, options->scene);
  command.details =
      "The true value is within each printed error, rounding included. Mass, centroid and inertia are those of the "
      "parts with their densities, and of the rest with density 1. The inertia is about the centroid, along the axes "
      "of the scene; principal moments are along its own axes.";
  command.examples = {"csgcast measure part.csg",
                      "csgcast measure part.csg --relative-error 1e-8 --format json -o part.json"};
  command.run = [options] { on_threads(options->scene.threads, [&] { run(*options); }); };
  return command;
}

}  // namespace csgcast::cli
