// SPDX-License-Identifier: MIT
#include <array>
#include <limits>
#include <optional>

#include "cli/command/commands.h"
#include "cli/input/distinct_files.h"
#include "cli/input/options.h"
#include "cli/input/scene_input.h"
#include "cli/output/format.h"
#include "cli/output/json.h"
#include "cli/output/output.h"
#include "cli/output/printable.h"
#include "cli/output/table.h"
#include "csg/base/number_text.h"
#include "raycast/packets/threads.h"
#include "verify/verification.h"

namespace csgcast::cli {
namespace {

using verify::Tally;
using verify::VerificationReport;

constexpr int most_rays = 1'000'000'000;

struct VerifyOptions {
  SceneOptions scene;
  std::string rays;
  std::string seed = "1";
  Format format = Format::table;
  std::string output;
};

bool is_plain(const std::string& word) {
  return !word.empty() && word.find_first_not_of(
                              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                              "._/-+=:,@%") == std::string::npos;
}

/// A word as a shell takes it.
std::string shell_word(const std::string& word) {
  if (is_plain(word)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + '\'';
}

/// The command that shows what a mismatch is about.
std::string command_for(const verify::Mismatch& mismatch, const SceneOptions& scene) {
  std::string text = "csgcast intervals " + shell_word(scene.path);
  if (scene.facets == text::Facets::always) text += " --facets always";
  if (scene.facets == text::Facets::never) text += " --facets never";
  if (scene.welding.mode == Welding::Mode::off) text += " --weld 0";
  if (scene.welding.mode == Welding::Mode::by_hand) text += " --weld " + number(scene.welding.tolerance);
  return text + ' ' + verify::interval_options(mismatch);
}

void add_row(Table& table, std::string_view kind, std::string_view engine, const Tally& tally) {
  table.add({std::string(kind), std::string(engine), fmt::format("{}", tally.rays), fmt::format("{}", tally.intervals),
             fmt::format("{}", tally.flagged), fmt::format("{}", tally.exact_decisions),
             fmt::format("{}", tally.wrong)});
}

std::string as_table(const VerificationReport& report, const SceneOptions& scene) {
  using enum Table::Align;
  Table table(
      {{"kind of rays", left}, {"engine", left}, {"rays"}, {"intervals"}, {"flagged"}, {"exact decisions"}, {"wrong"}});
  for (const verify::KindReport& kind : report.kinds) {
    for (std::size_t e = 0; e < report.engines.size(); ++e)
      add_row(table, kind.kind, report.engines[e], kind.tallies[e]);
  }
  const std::vector<Tally> totals = report.totals();
  for (std::size_t e = 0; e < report.engines.size(); ++e) add_row(table, "all", report.engines[e], totals[e]);
  std::string out;
  table.append_to(out, "");
  for (const auto& [kind, mismatch] : report.mismatches) {
    out += fmt::format("\n{}, {}, {}: {}\n  {}\n", kind, mismatch.engine, verify::name(mismatch.question),
                       mismatch.difference, printable(command_for(mismatch, scene)));
  }
  return out;
}

void json_tally(Json& json, const Tally& tally) {
  json.member("rays", tally.rays).member("intervals", tally.intervals).member("flagged", tally.flagged);
  json.member("exact_decisions", tally.exact_decisions).member("wrong", tally.wrong);
}

std::string as_json(const VerificationReport& report, std::uint64_t seed, const SceneOptions& scene) {
  std::string out;
  Json json(out);
  json.begin_object().member("seed", seed).key("kinds").begin_array();
  for (const verify::KindReport& kind : report.kinds) {
    for (std::size_t e = 0; e < report.engines.size(); ++e) {
      json.begin_object(Json::Layout::compact).member("kind", kind.kind).member("engine", report.engines[e]);
      json_tally(json, kind.tallies[e]);
      json.end_object();
    }
  }
  json.end_array().key("totals").begin_array();
  const std::vector<Tally> totals = report.totals();
  for (std::size_t e = 0; e < report.engines.size(); ++e) {
    json.begin_object(Json::Layout::compact).member("engine", report.engines[e]);
    json_tally(json, totals[e]);
    json.end_object();
  }
  json.end_array().key("mismatches").begin_array();
  for (const auto& [kind, mismatch] : report.mismatches) {
    json.begin_object(Json::Layout::compact).member("kind", kind).member("engine", mismatch.engine);
    json.member("question", verify::name(mismatch.question)).member("difference", mismatch.difference);
    json.member("origin", mismatch.ray.origin()).member("direction", mismatch.ray.direction());
    json.member("command", command_for(mismatch, scene)).end_object();
  }
  json.end_array().end_object();
  return out + '\n';
}

void run(const VerifyOptions& options) {
  verify::VerificationOptions job;
  job.seed = static_cast<std::uint64_t>(parse_count("--seed", options.seed, 0, std::numeric_limits<int>::max()));
  std::optional<std::uint64_t> rays;
  if (!options.rays.empty()) rays = static_cast<std::uint64_t>(parse_count("--rays", options.rays, 1, most_rays));
  check_distinct(std::array{NamedFile{"the scene", options.scene.path}}, std::array{NamedFile{"-o", options.output}});
  Output output(options.output);
  const SceneInput input = read_scene(options.scene);
  job.rays = rays ? *rays : verify::moderate_ray_count(input.scene);
  VerificationReport report;
  {
    ProgressBar bar("verifying", options.scene.progress());
    job.progress = bar.callback();
    report = verify::verify_scene(input.scene, job);
  }
  output.write(options.format == Format::json ? as_json(report, job.seed, options.scene)
                                              : as_table(report, options.scene));
  output.commit();
  std::uint64_t wrong = 0;
  for (const Tally& tally : report.totals()) wrong += tally.wrong;
  if (wrong > 0) {
    throw MachineError(
        fmt::format("csgcast: error: {} answers are not those of exact arithmetic (an engine is wrong); "
                    "please report the commands above with the scene",
                    wrong));
  }
}

}  // namespace

Command verify_command() {
  auto options = std::make_shared<VerifyOptions>();
  Command command{.name = "verify", .summary = "Compare the answers with exact arithmetic on this scene"};
  command.add({.names = "--rays",
               .value = "N",
               .help = "The number of random rays, and of adversarial rays (default 10000, fewer where rays are slow)",
               .take = into(options->rays)});
  command.add({.names = "--seed",
               .value = "S",
               .help = "Which rays: the same seed gives the same rays",
               .preset = options->seed,
               .take = into(options->seed)});
  command.add(choice<Format>("--format", options->format, "The format of the output",
                             {{"table", Format::table}, {"json", Format::json}}));
  command.add(output_option(options->output));
  add_scene_options(command, options->scene);
  command.details =
      "Every engine is asked for the intervals on the ray, on the whole line and on the reversed line, for the first "
      "hit and for any hit. Surfaces and t must be those of exact arithmetic, bit by bit. A ray is flagged if plain "
      "double left a decision open. The exit code is 1 if an answer is wrong.";
  command.examples = {"csgcast verify part.csg",
                      "csgcast verify part.csg --rays 1000000 --seed 2 --format json -o report.json"};
  command.run = [options] { on_threads(options->scene.threads, [&] { run(*options); }); };
  return command;
}

}  // namespace csgcast::cli
