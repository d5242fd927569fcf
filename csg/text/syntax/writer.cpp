// SPDX-License-Identifier: MIT
#include "csg/text/syntax/writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "csg/base/number_text.h"
#include "csg/base/tree_walk.h"

namespace csgcast::text {
namespace {

/// Deeper statements are indented no further: a million nested ones would else take a million times a million tabs.
constexpr std::size_t deepest_indent = 32;

void write_string(const std::string& content, std::string& out) {
  out += '"';
  for (const char c : content) {
    switch (c) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\t':
        out += "\\t";
        break;
      case '\r':
        out += "\\r";
        break;
      default:
        out += c;
    }
  }
  out += '"';
}

/// Lists nest at most 1,000 deep (the reader's limit), so this may recurse.
struct ValueWriter {
  std::string& out;

  void operator()(Undef) const { out += "undef"; }
  void operator()(bool value) const { out += value ? "true" : "false"; }
  void operator()(double value) const { out += shortest_number(value); }
  void operator()(const std::string& content) const { write_string(content, out); }
  void operator()(const Value::Word& word) const { out += word.name; }
  void operator()(const List& list) const {
    out += '[';
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (i > 0) out += ", ";
      std::visit(*this, list[i].data);
    }
    out += ']';
  }
};

void write_modifiers(std::uint8_t modifiers, std::string& out) {
  if (modifiers & disabled) out += '*';
  if (modifiers & root_only) out += '!';
  if (modifiers & background) out += '%';
  if (modifiers & highlight) out += '#';
}

bool opens_block(const Node& node) { return node.has_block || !node.children.empty(); }

void indent(std::size_t depth, std::string& out) { out.append(std::min(depth, deepest_indent), '\t'); }

/// The statement up to `;` or `{`, with the line's end. OpenSCAD puts modifiers before the indent.
void write_head(const Node& node, std::size_t depth, std::string& out) {
  write_modifiers(node.modifiers, out);
  indent(depth, out);
  out += node.name;
  if (node.name.starts_with('$')) {  // a special variable
    out += " = ";
    std::visit(ValueWriter{out}, node.arguments.front().value.data);
    out += ";\n";
    return;
  }
  out += '(';
  for (std::size_t i = 0; i < node.arguments.size(); ++i) {
    const Argument& argument = node.arguments[i];
    if (i > 0) out += ", ";
    if (!argument.name.empty()) out += argument.name + " = ";
    std::visit(ValueWriter{out}, argument.value.data);
  }
  out += opens_block(node) ? ") {\n" : ");\n";
}

}  // namespace

std::string write(const Document& document) {
  std::string out;
  TreeWalk<const Node, std::size_t> walk;  // with the depth of what stands in a node's block
  walk.run(
      document.nodes, 0,
      [&out](const Node& node, std::size_t depth) {
        write_head(node, depth, out);
        return opens_block(node) ? std::optional(depth + 1) : std::nullopt;
      },
      [](const Node& node) { return std::span(node.children); },
      [&out](const Node&, std::size_t, std::size_t depth) {
        indent(depth, out);
        out += "}\n";
      });
  return out + '\n';
}

}  // namespace csgcast::text
