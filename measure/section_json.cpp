// SPDX-License-Identifier: MIT
#include "measure/section_json.h"

#include <cmath>
#include <initializer_list>
#include <span>

#include "csg/base/number_text.h"

namespace csgcast {
namespace {

void append_value(std::string& out, double value) {
  if (!std::isfinite(value))
    out += "null";
  else
    append_number(out, value);
}

void append_list(std::string& out, std::span<const double> values) {
  out += '[';
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) out += ", ";
    append_value(out, values[i]);
  }
  out += ']';
}

void append_list(std::string& out, std::initializer_list<double> values) {
  append_list(out, std::span(values.begin(), values.size()));
}

void append_arc(std::string& out, const SectionArc& arc) {
  out += "      {\"kind\": ";
  out += arc.is_straight() ? "\"line\"" : "\"conic\"";
  out += ", \"from\": ";
  append_list(out, {arc.from.u, arc.from.v});
  out += ", \"middle\": ";
  append_list(out, {arc.middle.u, arc.middle.v});
  out += ", \"to\": ";
  append_list(out, {arc.to.u, arc.to.v});
  out += ", \"conic\": ";
  append_list(out, arc.conic);
  out += ", \"surface\": " + std::to_string(arc.surface.index()) + '}';
}

}  // namespace

std::string section_json(const Section& section) {
  std::string out = "{\n";
  const auto key = [&](const char* name) -> std::string& { return out.append("  \"").append(name).append("\": "); };
  const auto flag = [&](const char* name, bool value) { key(name) += value ? "true,\n" : "false,\n"; };
  const auto list = [&](const char* name, std::initializer_list<double> values) {
    append_list(key(name), values);
    out += ",\n";
  };
  const auto value = [&](const char* name, double number) {
    append_value(key(name), number);
    out += ",\n";
  };
  flag("unbounded", !section.is_bounded);
  list("origin", {section.origin.x, section.origin.y, section.origin.z});
  list("u", {section.u.x, section.u.y, section.u.z});
  list("v", {section.v.x, section.v.y, section.v.z});
  value("area", section.area.value);
  value("area_error", section.area.error);
  value("perimeter", section.perimeter.value);
  value("perimeter_error", section.perimeter.error);
  value("place_error", section.place_error);
  flag("closed", section.is_closed);
  key("loops") += '[';
  const char* separator = "\n";
  for (const SectionLoop& loop : section.loops) {
    out.append(separator).append("    [");
    separator = ",\n";
    const char* between = "\n";
    for (const SectionArc& arc : loop) {
      out += between;
      between = ",\n";
      append_arc(out, arc);
    }
    out += "\n    ]";
  }
  return out + (section.loops.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

}  // namespace csgcast
