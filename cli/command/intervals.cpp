// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <system_error>

#include "cli/command/commands.h"
#include "cli/input/distinct_files.h"
#include "cli/input/options.h"
#include "cli/input/rows_option.h"
#include "cli/output/format.h"
#include "cli/output/interval_report.h"
#include "cli/output/usage.h"
#include "csg/base/number_text.h"
#include "csg/base/precondition.h"
#include "raycast/cells/cells.h"
#include "raycast/packets/packet_caster.h"
#include "raycast/packets/threads.h"
#include "raycast/ray/caster.h"

namespace csgcast::cli {
namespace {

enum class By { scene, part };

struct IntervalsOptions {
  SceneOptions scene;
  RowsOption rays{"--ray", "--rays", {"ox", "oy", "oz", "dx", "dy", "dz"}, {}, {}};
  bool whole_line = false;
  std::string t_min;
  std::string t_max;
  By by = By::scene;
  Format format = Format::table;
  std::string output;

  Span span() const;
};

Span IntervalsOptions::span() const {
  if (whole_line) return Span::line();
  Span span;
  if (!t_min.empty()) span.from = parse_parameter("--tmin", t_min);
  if (!t_max.empty()) span.to = parse_parameter("--tmax", t_max);
  if (span.from >= span.to) {
    throw UsageError(fmt::format("no ray is left between t = {} and t = {}", span.from, span.to));
  }
  return span;
}

/// What one thread needs to answer rays.
class IntervalWorker {
 public:
  /// `cells`: of the whole solid, to answer by them; null: without. Precondition: they suit().
  IntervalWorker(const Scene& scene, const Cells* cells, const IntervalReport& report, const Rows& rows, Span span,
                 By by)
      : caster_(scene), report_(report), rows_(rows), span_(span), by_(by) {
    if (cells != nullptr) packets_.emplace(*cells, PacketCaster::Width::single);
    CSGCAST_PRECONDITION(cells == nullptr || (by == By::scene && (span.from == 0 || std::isinf(span.from))));
  }

  /// Whether cells can answer, and take less time to be made than they save.
  static bool suits(const Scene& scene, const RowsOption& rays, Span span, By by) {
    if (by != By::scene || !(span.from == 0 || std::isinf(span.from))) return false;
    std::error_code ignored;
    const auto bytes = std::filesystem::file_size(rays.file, ignored);
    constexpr std::size_t bytes_of_ray = 50;
    constexpr std::size_t rays_of_leaf = 4;  // that take as long without cells as making them, a leaf
    return !ignored && bytes / bytes_of_ray > rays_of_leaf * scene.leaves().size();
  }

  void operator()(const NumberRow& row, std::string& text) {
    const auto& v = row.values;
    if (v[3] == 0 && v[4] == 0 && v[5] == 0) {
      rows_.reject(row, 3, "the direction is zero", "it does not say where to look", "give any other direction");
    }
    if (!Ray::in_range({v[0], v[1], v[2]}, {v[3], v[4], v[5]})) {
      rows_.reject(row, 0, "the ray is out of range",
                   "coordinates up to 2^400 and directions from 2^-400 to 2^400 work", "choose another unit of length");
    }
    const Ray ray({v[0], v[1], v[2]}, {v[3], v[4], v[5]});
    answer_.intervals.clear();
    is_begun_ = false;
    const Scene& scene = caster_.scene();
    if (packets_) {
      add_by_cells(ray);
    } else {
      begin(ray);
      if (by_ == By::scene) add(scene.root(), std::nullopt);
      for (std::uint32_t i = 0; by_ == By::part && i < scene.parts().size(); ++i) add(scene.parts()[i].node, PartId(i));
    }
    if (report_.shows_overlaps()) {
      begin(ray);
      answer_.overlap_count = overlaps_.find(caster_, span_, IntervalReport::most_overlaps, answer_.overlaps);
    }
    report_.append(text, row.index, ray, answer_);
  }

 private:
  /// Turns the caster to the ray, unless that is done.
  void begin(const Ray& ray) {
    if (!is_begun_) caster_.begin(ray);
    is_begun_ = true;
  }

  /// The intervals of one node; `part` is whose they are if that is known.
  void add(NodeId node, std::optional<PartId> part) {
    caster_.intervals(node, list_, span_);
    for (const Interval& interval : list_) {
      FacedInterval faced{
          interval, face(node, interval.entry, Passage::entry), face(node, interval.exit, Passage::exit), {}};
      faced.part = part ? *part : part_of(faced);
      answer_.intervals.push_back(faced);
    }
  }

  /// Those of the whole solid.
  void add_by_cells(const Ray& ray) {
    packets_->intervals(std::span(&ray, 1), batch_, span_, Rounding::nearest, PacketCaster::Ends::faces);
    const auto face = [&](std::size_t end) {
      return batch_.faces[end].leaf.valid() ? std::optional(batch_.faces[end]) : std::nullopt;
    };
    for (std::size_t i = 0; i < batch_.intervals.size(); ++i) {
      FacedInterval faced{batch_.intervals[i], face(2 * i), face(2 * i + 1), {}};
      if (!faced.entry) begin(ray);
      faced.part = part_of(faced);
      answer_.intervals.push_back(faced);
    }
  }

  std::optional<EndFace> face(NodeId node, const Crossing& crossing, Passage passage) {
    if (!crossing.surface.valid()) return std::nullopt;
    return end_face(caster_.attribute(node, {crossing, passage}));
  }

  /// The part of the entry's face. Of an interval that is cut off at its start: the first part in file order that the
  /// ray is in there, which intervals tell exactly, where the coordinates of the start would be rounded.
  PartId part_of(const FacedInterval& faced) {
    const Scene& scene = caster_.scene();
    if (faced.entry) return scene.leaf(faced.entry->leaf).part;
    const auto [start, end] = faced.interval;
    for (std::uint32_t i = 0; i < scene.parts().size(); ++i) {
      caster_.intervals(scene.parts()[i].node, part_list_, {start.t, end.t});
      if (!part_list_.empty() && part_list_.front().entry.t == start.t) return PartId(i);
    }
    return {};
  }

  Caster caster_;
  std::optional<PacketCaster> packets_;
  IntervalBatch batch_;
  const IntervalReport& report_;
  const Rows& rows_;
  Span span_;
  By by_;
  IntervalList list_;
  IntervalList part_list_;
  PartOverlaps overlaps_;
  RayAnswer answer_;
  bool is_begun_ = false;  // the caster is at the present ray
};

/// What all parts of one result have alike. Files of rays are told apart by their sizes.
PartLabel label_of(const text::Document& document, const IntervalsOptions& options, Span span) {
  PartLabel label(document, options.scene);
  label.add("tmin", number(span.from));
  label.add("tmax", number(span.to));
  label.add("by", options.by == By::scene ? "scene" : "part");
  label.add("format", options.format == Format::csv ? "csv" : "json");
  std::error_code error;
  const auto bytes = std::filesystem::file_size(options.rays.file, error);
  if (!error) label.add("rays", fmt::format("{} bytes", bytes));
  return label;
}

void run(const IntervalsOptions& options) {
  const Span span = options.span();
  check_distinct(std::array{NamedFile{"the scene", options.scene.path}, NamedFile{"--rays", options.rays.file}},
                 std::array{NamedFile{"-o", options.output}});
  Rows rows(options.rays, options.scene);
  Output output(options.output);
  DocumentInput document = read_document(options.scene);
  const PartLabel label = options.rays.range.empty() ? PartLabel() : label_of(document.document, options, span);
  const SceneInput input = compile_document(std::move(document), options.scene);
  if (options.by == By::part && input.scene.parts().empty()) {
    throw Error(ErrorCode::usage, {options.scene.path, 0, 0}, "the scene has no parts", "--by part lists nothing else",
                "name some with part(\"name\") { .. }, or leave --by out");
  }
  const IntervalReport report(input.scene, options.format, rows.range().first);
  std::optional<Cells> cells;
  if (IntervalWorker::suits(input.scene, options.rays, span, options.by)) cells.emplace(input.scene);
  output.write(report.head());
  answer_rows([&](NumberRow& row) { return rows.next(row); }, output,
              [&] { return IntervalWorker(input.scene, cells ? &*cells : nullptr, report, rows, span, options.by); });
  if (options.rays.range.empty() || options.format == Format::table) {
    output.write(report.tail());
  } else {
    output.write(options.format == Format::csv ? csv_mark(rows.range(), label) : json_mark(rows.range(), label));
  }
  output.commit();
}

}  // namespace

Command intervals_command() {
  auto options = std::make_shared<IntervalsOptions>();
  Command command{.name = "intervals", .summary = "List where rays are inside the solid"};
  add_rows_option(command, options->rays, "One ray: its origin and its direction, which need not be unit");
  add_range_option(command, options->rays);
  command.add({.names = "--line",
               .value = {},
               .help = "Take the whole line, from -inf to inf, instead of the ray from t = 0 on",
               .take = into(options->whole_line)});
  command.add({.names = "--tmin",
               .value = "T",
               .help = "Where rays begin; -inf is allowed",
               .preset = "0",
               .take = into(options->t_min),
               .conflicts = {"--line"}});
  command.add({.names = "--tmax",
               .value = "T",
               .help = "Where rays end",
               .preset = "inf",
               .take = into(options->t_max),
               .conflicts = {"--line"}});
  command.add(choice<By>("--by", options->by,
                         "One list for the scene, or one for each part; what is in no part is then left out",
                         {{"scene", By::scene}, {"part", By::part}}));
  command.add(choice<Format>("--format", options->format, "The format of the output",
                             {{"table", Format::table}, {"csv", Format::csv}, {"json", Format::json}}));
  command.add(output_option(options->output));
  add_scene_options(command, options->scene);
  command.details =
      "t counts in units of the direction. Normals are unit and point out of the solid. Solids are named by the "
      "line:column of their statement. The columns of a file of rays stand in the order of --rays, with a header or "
      "without.\n"
      "With --by scene the part is that of the entry's face. If an interval is cut off at its start, the part is the "
      "first one in the file that holds the start.";
  command.examples = {"csgcast intervals part.csg --ray 0,0,100,0,0,-1",
                      "csgcast intervals part.csg --rays rays.csv --format csv -o intervals.csv"};
  command.run = [options] { on_threads(options->scene.threads, [&] { run(*options); }); };
  return command;
}

}  // namespace csgcast::cli
