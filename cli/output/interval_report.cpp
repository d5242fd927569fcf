// SPDX-License-Identifier: MIT
#include "cli/output/interval_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cli/output/csv.h"
#include "cli/output/json.h"
#include "cli/output/printable.h"
#include "cli/output/table.h"
#include "csg/base/length.h"
#include "csg/base/number_text.h"

namespace csgcast::cli {
namespace {

template <class Tag>
std::string coordinates(const Triple<Tag>& t) {
  return fmt::format("{},{},{}", number(t.x), number(t.y), number(t.z));
}

/// The angle between the ray and the face's normal in degrees, 0 to 90, to two digits.
std::string obliquity(const Ray& ray, const std::optional<EndFace>& face) {
  if (!face) return "-";
  const double cosine = std::min(1.0, std::fabs(dot(normalised(ray.direction()), face->normal)));
  return fmt::format("{:.2f}", std::acos(cosine) * 180 / std::numbers::pi);
}

void append_normal(std::string& out, const std::optional<EndFace>& face) {
  out += ',';
  if (!face) {
    out += ",,";
    return;
  }
  out += coordinates(face->normal);
}

void json_normal(Json& json, const char* name, const std::optional<EndFace>& face) {
  json.key(name);
  if (face) {
    json.value(face->normal);
  } else {
    json.null();
  }
}

void json_text(Json& json, const char* name, const std::string& text) {
  json.key(name);
  if (text.empty()) {
    json.null();
  } else {
    json.value(text);
  }
}

}  // namespace

std::string IntervalReport::head() const {
  switch (format_) {
    case Format::csv:
      return "ray,t_entry,t_exit,entry_nx,entry_ny,entry_nz,exit_nx,exit_ny,exit_nz,entry_solid,exit_solid,part\n";
    case Format::json:
      return "{\"rays\": [";
    case Format::table:
      break;
  }
  return {};
}

std::string IntervalReport::tail() const { return format_ == Format::json ? "\n]}\n" : ""; }

void IntervalReport::append(std::string& out, std::uint64_t index, const Ray& ray, const RayAnswer& answer) const {
  switch (format_) {
    case Format::csv:
      for (const FacedInterval& interval : answer.intervals) append_csv(out, index, interval);
      return;
    case Format::json:
      append_json(out, index, ray, answer);
      return;
    case Format::table:
      append_table(out, index, ray, answer);
      return;
  }
}

void IntervalReport::append_csv(std::string& out, std::uint64_t index, const FacedInterval& interval) const {
  fmt::format_to(std::back_inserter(out), "{},", index);
  append_number(out, interval.interval.entry.t);
  out += ',';
  append_number(out, interval.interval.exit.t);
  append_normal(out, interval.entry);
  append_normal(out, interval.exit);
  const std::string* part = part_name(interval.part);
  out += ',' + solid_place(interval.entry) + ',' + solid_place(interval.exit) + ',';
  if (part != nullptr) out += csv_field(*part);
  out += '\n';
}

void IntervalReport::append_json(std::string& out, std::uint64_t index, const Ray& ray, const RayAnswer& answer) const {
  out += index == first_ ? "\n" : ",\n";
  Json json(out);
  json.begin_object(Json::Layout::compact).member("ray", index);
  json.member("origin", ray.origin()).member("direction", ray.direction()).key("intervals").begin_array();
  for (const FacedInterval& faced : answer.intervals) {
    const auto [entry, exit] = faced.interval;
    json.begin_object().member("t_entry", entry.t).member("t_exit", exit.t);
    json.member("unbounded", std::isinf(entry.t) || std::isinf(exit.t));
    json_normal(json, "entry_normal", faced.entry);
    json_normal(json, "exit_normal", faced.exit);
    json_text(json, "entry_solid", solid_place(faced.entry));
    json_text(json, "exit_solid", solid_place(faced.exit));
    json.key("part");
    if (const std::string* part = part_name(faced.part)) {
      json.value(*part);
    } else {
      json.null();
    }
    json.end_object();
  }
  json.end_array();
  if (shows_overlaps()) {
    json.key("overlaps").begin_array();
    for (const PartOverlap& overlap : answer.overlaps) {
      json.begin_object().key("parts").begin_array().value(*part_name(overlap.first));
      json.value(*part_name(overlap.second)).end_array();
      json.member("t_entry", overlap.common.entry.t).member("t_exit", overlap.common.exit.t).end_object();
    }
    json.end_array().member("overlap_count", answer.overlap_count);
  }
  json.end_object();
}

void IntervalReport::append_table(std::string& out, std::uint64_t index, const Ray& ray,
                                  const RayAnswer& answer) const {
  if (index > first_) out += '\n';
  out += fmt::format("ray {} from {} along {}", index, coordinates(ray.origin()), coordinates(ray.direction()));
  if (answer.intervals.empty()) {
    out += ": nothing\n";
    return;
  }
  out += '\n';
  using enum Table::Align;
  Table table({{"t_entry"},
               {"t_exit"},
               {"length"},
               {"entry_obliquity"},
               {"exit_obliquity"},
               {"entry_solid", left},
               {"exit_solid", left},
               {"part", left}});
  const auto solid = [&](const std::optional<EndFace>& face) {
    return face ? fmt::format("{} {}", word(scene_.leaf(face->leaf).kind), solid_place(face)) : "-";
  };
  for (const FacedInterval& faced : answer.intervals) {
    const auto [entry, exit] = faced.interval;
    const std::string* part = part_name(faced.part);
    table.add({number(entry.t), number(exit.t), number((exit.t - entry.t) * length(ray.direction())),
               obliquity(ray, faced.entry), obliquity(ray, faced.exit), solid(faced.entry), solid(faced.exit),
               part != nullptr ? printable(*part) : "-"});
  }
  table.append_to(out, "  ");
  append_overlaps(out, ray, answer);
}

void IntervalReport::append_overlaps(std::string& out, const Ray& ray, const RayAnswer& answer) const {
  if (answer.overlaps.empty()) return;
  using enum Table::Align;
  Table table({{"t_entry"}, {"t_exit"}, {"length"}, {"overlap of", left}, {"with", left}});
  for (const PartOverlap& overlap : answer.overlaps) {
    const auto [entry, exit] = overlap.common;
    table.add({number(entry.t), number(exit.t), number((exit.t - entry.t) * length(ray.direction())),
               printable(*part_name(overlap.first)), printable(*part_name(overlap.second))});
  }
  table.append_to(out, "  ");
  if (answer.overlap_count > answer.overlaps.size())
    out += fmt::format("  and {} more overlaps\n", answer.overlap_count - answer.overlaps.size());
}

/// `line:column` of the leaf that a face belongs to; empty without a face.
std::string IntervalReport::solid_place(const std::optional<EndFace>& face) const {
  if (!face) return {};
  const Place& place = scene_.leaf(face->leaf).place;
  return fmt::format("{}:{}", place.line, place.column);
}

const std::string* IntervalReport::part_name(PartId part) const {
  return part.valid() ? &scene_.parts()[part.index()].name.name : nullptr;
}

}  // namespace csgcast::cli
