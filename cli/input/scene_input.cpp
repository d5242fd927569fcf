// SPDX-License-Identifier: MIT
#include "cli/input/scene_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/input/huge_pages.h"
#include "cli/input/options.h"
#include "cli/output/labelled_row.h"
#include "cli/output/printable.h"
#include "cli/output/stopwatch.h"
#include "cli/output/usage.h"
#include "cli/output/weld_lines.h"
#include "csg/solid/parts.h"
#include "csg/text/syntax/reader.h"

namespace csgcast::cli {
namespace {

constexpr int most_threads = 1024;

Welding parse_welding(const std::string& text) {
  const double relative = parse_numbers("--weld", text, 1).front();
  if (relative == 0) return {};
  if (!(relative > 0 && relative <= Welding::greatest_tolerance)) {
    throw UsageError(
        fmt::format("--weld {}: a tolerance is a share of the size of the scene, above 0 and at most "
                    "{}, or 0 to weld nothing",
                    text, Welding::greatest_tolerance));
  }
  return Welding::by_hand(relative);
}

/// The parts asked for alone. Throws Error naming the parts that there are if one is not among them.
Solid selected(Solid solid, const SceneOptions& options, const FileName& file) {
  if (options.parts.empty()) return solid;
  const std::vector<std::string> known = part_names(solid);
  if (const std::string* name = unknown_part(known, options.parts)) {
    constexpr std::size_t most_listed = 20;
    std::string list;
    for (std::size_t i = 0; i < std::min(known.size(), most_listed); ++i) {
      list += (i > 0 ? ", " : "") + printable(known[i]);
    }
    if (known.size() > most_listed) list += fmt::format(" and {} more", known.size() - most_listed);
    throw Error(ErrorCode::usage, {file, 0, 0}, fmt::format("no part is named '{}'", printable(*name)),
                "--part takes the name of a part(\"name\") statement",
                known.empty() ? "name one, or leave --part out" : "the parts are " + list);
  }
  return only_parts(solid, options.parts);
}

// Near misses are looked for where that costs little beside reading the scene.
Welding with_near_misses(Welding welding, const Solid& solid) {
  constexpr std::uint64_t most_leaves = 20'000;
  if (welding.mode != Welding::Mode::off && solid.leaf_count() <= most_leaves) welding.lists_near_misses = true;
  return welding;
}

// A file, or who knows what, of which a scene of thousands of solids may come.
bool may_be_large(const std::string& path) {
  constexpr std::uintmax_t small = 1 << 17;
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(path, none);
  return none || size > small;
}

}  // namespace

void add_scene_options(Command& command, SceneOptions& options) {
  using text::Facets;
  command.operands.push_back(
      {.name = "SCENE", .help = "The scene text (.csg); - is standard input", .take = into(options.path)});
  command.add(choice<Facets>("--facets", options.facets,
                             "Which round solids become polyhedra: those with $fn <= 16, all, none",
                             {{"auto", Facets::automatic}, {"always", Facets::always}, {"never", Facets::never}}));
  command.add({.names = "--weld",
               .value = "RELATIVE",
               .help = "Join faces that are at most this share of the scene's size apart; 0 joins none (default: those "
                       "that only the rounding of numbers keeps apart, and that their few digits do)",
               .take = [&options](const std::string& text) { options.welding = parse_welding(text); }});
  command.add({.names = "--skip-unsupported",
               .value = {},
               .help = "Leave out statements of OpenSCAD that are not supported yet, each with a warning",
               .take = into(options.skips_unsupported)});
  command.add({.names = "--part",
               .value = "NAME",
               .help = "Only the part of this name, as if the scene held nothing else; repeatable",
               .take = into(options.parts),
               .is_repeatable = true});
  command.add({.names = "--threads",
               .value = "N",
               .help = "The number of threads (default: one a core)",
               .take = [&options](const std::string& text) {
                 options.threads = parse_count("--threads", text, 1, most_threads);
               }});
  command.add(
      {.names = "-q,--quiet", .value = {}, .help = "No progress bar and no warnings", .take = into(options.quiet)});
}

std::string faceted_line(std::uint64_t count) {
  return fmt::format("{} {}, as $fn says (--facets never keeps them round)", counted(count, "round solid"),
                     count == 1 ? "is a polyhedron" : "are polyhedra");
}

DocumentInput read_document(const SceneOptions& options) {
  const Stopwatch watch;
  if (may_be_large(options.path)) use_huge_pages();
  DocumentInput input{text::read_file(options.path)};
  input.read_seconds = watch.seconds();
  return input;
}

SceneInput compile_document(DocumentInput input, const SceneOptions& options) {
  const Stopwatch build_watch;
  SceneInput result;
  const FileName file = input.document.file;
  result.description = text::build(std::move(input.document), {options.facets, options.skips_unsupported});
  result.description.solid = selected(std::move(result.description.solid), options, file);
  result.read_seconds = input.read_seconds + build_watch.seconds();
  if (!options.quiet) {
    for (const Warning& warning : result.description.warnings) fmt::print(stderr, "{}\n", to_string(warning));
  }
  const bool tells_near_misses = !options.welding.lists_near_misses;  // else the command itself does
  const Stopwatch compile_watch;
  const Welding welding = with_near_misses(options.welding, result.description.solid);
  result.scene = compile(std::exchange(result.description.solid, {}), welding);
  result.compile_seconds = compile_watch.seconds();
  const auto warn = [&](std::string text) {
    Warning warning;
    warning.place.file = file;
    warning.text = std::move(text);
    result.description.warnings.push_back(warning);
    if (!options.quiet) fmt::print(stderr, "{}\n", to_string(warning));
  };
  const WeldReport& report = result.scene.weld_report();
  const bool moved = report.widest > 0x1p-40 * report.size;  // by more than rounding
  if (moved && options.welding.mode == Welding::Mode::derived && result.description.digits.are_few())
    warn(joined_line(report, result.description.digits));
  if (report.near_miss_count > 0 && tells_near_misses) warn(near_misses_line(report));
  if (report.incomplete)
    warn("welding was cut short (very many surfaces nearly coincide); some that rounding keeps apart are still two");
  if (result.scene.bounds().is_null()) warn("the scene is empty (no solid is left in it); rays meet nothing");
  return result;
}

SceneInput read_scene(const SceneOptions& options) { return compile_document(read_document(options), options); }

}  // namespace csgcast::cli
