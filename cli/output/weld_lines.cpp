// SPDX-License-Identifier: MIT
#include "cli/output/weld_lines.h"

#include "cli/output/labelled_row.h"

namespace csgcast::cli {
namespace {

/// Three digits of a length or share that is only known to a few.
std::string about(double value) { return fmt::format("{:.3g}", value); }

/// A length, and what share of the scene's size it is, if it has one.
std::string with_share(double length, double size) {
  return size > 0 ? fmt::format("{} (relative {})", about(length), about(length / size)) : about(length);
}

}  // namespace

void append_welding(std::string& out, const WeldReport& report) {
  std::string text = "nothing";
  if (report.surfaces > 0) {
    text = fmt::format("{} joined {}; moved by at most {}", counted(report.surfaces, "surface"),
                       counted(report.clusters, "other"), with_share(report.widest, report.size));
  }
  append_row(out, "welded", text + (report.incomplete ? "; cut short: very many surfaces nearly coincide" : ""));
  if (report.near_miss_count == 0) return;
  const std::string advice =
      report.suggested_tolerance > 0
          ? fmt::format("--weld {} would join them, but for wider ones", about(report.suggested_tolerance))
          : "of all widths, so none can be told from what is meant";
  append_row(out, "near misses",
             fmt::format("{} of surfaces, not one but near; {}", counted(report.near_miss_count, "pair"), advice));
  for (const NearMiss& miss : report.near_misses) {
    append_row(out, "",
               fmt::format("{}:{} and {}:{}  gap {}", miss.first.line, miss.first.column, miss.second.line,
                           miss.second.column, with_share(miss.gap, report.size)));
  }
}

std::string joined_line(const WeldReport& report, Digits digits) {
  return fmt::format(
      "numbers have up to {} digits, and faces that may be one by these were joined: {}, moved by at most {} (--weld 0 "
      "joins none)",
      digits.count(), counted(report.surfaces, "surface"), about(report.widest));
}

std::string near_misses_line(const WeldReport& report) {
  const double least = report.near_misses.front().gap;
  const std::string advice = report.suggested_tolerance > 0
                                 ? fmt::format("; --weld {} would join some", about(report.suggested_tolerance))
                                 : std::string();
  return fmt::format(
      "{} of faces that touch or overlap are nearly one, from a gap of {} on (csgcast info lists them{})",
      counted(report.near_miss_count, "pair"), about(least), advice);
}

void json_welding(Json& json, const WeldReport& report) {
  json.key("welded").begin_object().member("surfaces", std::uint64_t(report.surfaces));
  json.member("clusters", std::uint64_t(report.clusters)).member("widest", report.widest);
  json.member("incomplete", report.incomplete);
  json.member("near_miss_count", std::uint64_t(report.near_miss_count));
  json.member("suggested_tolerance", report.suggested_tolerance).key("near_misses").begin_array();
  for (const NearMiss& miss : report.near_misses) {
    json.begin_object(Json::Layout::compact);
    json.member("first", fmt::format("{}:{}", miss.first.line, miss.first.column));
    json.member("second", fmt::format("{}:{}", miss.second.line, miss.second.column));
    json.member("gap", miss.gap).end_object();
  }
  json.end_array().end_object();
}

}  // namespace csgcast::cli
