// SPDX-License-Identifier: MIT
#include "csg/text/statement/builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "csg/base/tree_walk.h"
#include "csg/text/statement/detail/document_digits.h"
#include "csg/text/statement/detail/statements.h"
#include "csg/text/syntax/each_statement.h"
#include "csg/text/syntax/openscad_language.h"
#include "csg/text/syntax/shortened.h"
#include "csg/text/syntax/suggestion.h"

namespace csgcast::text {
namespace {

bool is_skipped(const Node& node) { return (node.modifiers & (background | disabled)) != 0; }

bool is_scene_statement(const Node& node) {
  const Statement* statement = find_statement(node.name);
  return statement != nullptr && std::holds_alternative<SceneStatement>(statement->meaning);
}

/// The first statement with `!` in file order; null if there is none. As in OpenSCAD it may stand below `%`, but not
/// below `*`.
Node* find_root(std::vector<Node>& nodes) {
  std::vector<std::span<Node>> open{nodes};
  while (!open.empty()) {
    if (open.back().empty()) {
      open.pop_back();
      continue;
    }
    Node& node = open.back().front();
    open.back() = open.back().subspan(1);
    if ((node.modifiers & disabled) != 0 || is_scene_statement(node)) continue;
    if ((node.modifiers & root_only) != 0) return &node;
    open.emplace_back(node.children);
  }
  return nullptr;
}

/// What may stand below a statement.
struct Below {
  bool top = true;                      ///< nothing is above: camera, light, background and settings may stand here
  const Node* forbids_parts = nullptr;  ///< the innermost statement above that a part must not stand in
  SpecialVariables specials{};
};

bool is_special_variable(const Node& node) { return node.name.starts_with('$'); }

/// Walks the statements in file order; arguments are read when a statement is entered, solids combined when it is left.
class Builder {
 public:
  Builder(Document document, const BuildOptions& options) : document_(std::move(document)), options_(options) {}

  SceneDescription build();

 private:
  /// An operator whose statements are being read; or the whole document.
  struct Operator {
    Combine combine = unite;
    Below below{};
    std::vector<Solid> solids{};
  };

  Solid build_solid(std::span<Node> nodes, const SpecialVariables& specials);
  std::optional<Operator> enter(Node& node, Operator& above);
  void leave(Node& node, Operator done, Operator& above);
  void apply(const Node& node, const Statement& statement, const SceneStatement& meaning);
  Solid make_solid(const Node& node, const Statement& statement, const SolidStatement& meaning,
                   const SpecialVariables& specials);
  Operator open(const Node& node, const Statement& statement, const OperatorStatement& meaning, Below below);

  const Statement& statement_of(const Node& node) const;
  Call call(const Node& node, const Statement& statement, const SpecialVariables& specials = {}) {
    return {node, document_.file, statement.parameters, options_, specials, scene_};
  }
  void set_specials(std::span<const Node> nodes, SpecialVariables& specials);
  Place place(const Node& node) const { return {document_.file, node.line, node.column}; }
  void reject_children(const Node& node) const;
  void require_top(const Node& node, const Below& below) const;
  void require_part_allowed(const Node& part, const Below& below) const;
  void warn_of_repeated_part(const Call& part);

  Document document_;
  const BuildOptions& options_;
  SceneDescription scene_;
  std::uint64_t unsupported_ = 0;                    ///< how many statements are
  std::vector<std::string_view> applied_;            ///< names of the scene statements so far
  std::unordered_map<std::string, int> part_lines_;  ///< where each part name stood first
};

SceneDescription Builder::build() {
  each_statement(std::span<const Node>(document_.nodes),
                 [this](const Node& node) { unsupported_ += is_unsupported(node) ? 1 : 0; });
  const std::optional<Digits> given = digits_given(document_);
  scene_.digits = given ? *given : digits_shown(document_);
  SpecialVariables specials;
  set_specials(document_.nodes, specials);
  Node* root = find_root(document_.nodes);
  if (root == nullptr) {
    scene_.solid = build_solid(document_.nodes, specials);
    return std::move(scene_);
  }
  for (const Node& node : document_.nodes) {
    if (is_skipped(node) || !is_scene_statement(node)) continue;
    const Statement& statement = statement_of(node);
    apply(node, statement, std::get<SceneStatement>(statement.meaning));
  }
  scene_.solid = build_solid({root, 1}, specials);
  return std::move(scene_);
}

/// As in OpenSCAD a variable holds in all of its block, also before it stands, and the last one of a name counts.
void Builder::set_specials(std::span<const Node> nodes, SpecialVariables& specials) {
  static const Parameters value{{"value"}, {}};
  for (const Node& node : nodes) {
    if (!is_special_variable(node) || is_skipped(node)) continue;
    const Call variable(node, document_.file, value, options_, {}, scene_);
    if (std::optional<double>* special = specials.find(node.name)) {
      *special = variable.number("value");
    } else {
      variable.warn(fmt::format("'{}' has no effect here: only $fn, $fa and $fs do", shortened(node.name)));
    }
  }
}

Solid Builder::build_solid(std::span<Node> nodes, const SpecialVariables& specials) {
  TreeWalk<Node, Operator> walk;
  Operator top;
  top.below.specials = specials;
  Operator whole = walk.run(
      nodes, std::move(top), [this](Node& node, Operator& above) { return enter(node, above); },
      [](Node& node) { return std::span(node.children); },
      [this](Node& node, Operator done, Operator& above) { leave(node, std::move(done), above); });
  return whole.combine(std::move(whole.solids));
}

std::optional<Builder::Operator> Builder::enter(Node& node, Operator& above) {
  if (is_skipped(node) || is_special_variable(node)) return std::nullopt;
  if (options_.skips_unsupported && is_unsupported(node)) {
    scene_.warnings.push_back({place(node), fmt::format("'{}' is left out: it is not supported yet", node.name)});
    return std::nullopt;
  }
  const Statement& statement = statement_of(node);
  if (const auto* meaning = std::get_if<OperatorStatement>(&statement.meaning)) {
    return open(node, statement, *meaning, above.below);
  }
  if (const auto* solid = std::get_if<SolidStatement>(&statement.meaning)) {
    above.solids.push_back(make_solid(node, statement, *solid, above.below.specials));
    node.give_up();
  } else {
    require_top(node, above.below);
    apply(node, statement, std::get<SceneStatement>(statement.meaning));
  }
  return std::nullopt;
}

void Builder::leave(Node& node, Operator done, Operator& above) {
  Solid solid = done.combine(std::move(done.solids));
  // A union of one is that one, which keeps its own place.
  if (solid.place().line == 0) solid = std::move(solid).at(place(node));
  node.give_up();
  above.solids.push_back(std::move(solid));
}

const Statement& Builder::statement_of(const Node& node) const {
  const Statement* statement = find_statement(node.name);
  if (statement == nullptr) {
    throw Error(ErrorCode::unknown_name, place(node), fmt::format("there is no statement '{}'", shortened(node.name)),
                "",
                did_you_mean(node.name, statement_names(),
                             fmt::format("if it is a module of an OpenSCAD program, {}", export_remedy)));
  }
  if (std::holds_alternative<UnsupportedStatement>(statement->meaning)) {
    const std::uint64_t more = unsupported_ > 0 ? unsupported_ - 1 : 0;
    throw Error(ErrorCode::unsupported, place(node), fmt::format("'{}' is not supported yet", node.name),
                more == 0 ? "it is valid OpenSCAD, but csgcast cannot make its solid"
                          : fmt::format("it is valid OpenSCAD, but csgcast cannot make its solid, nor those of {} more "
                                        "statements",
                                        more),
                "csgcast info lists all; --skip-unsupported leaves them out, as '*' before one does");
  }
  return *statement;
}

Solid Builder::make_solid(const Node& node, const Statement& statement, const SolidStatement& meaning,
                          const SpecialVariables& specials) {
  Solid solid = meaning.make(call(node, statement, specials));
  reject_children(node);
  return std::move(solid).at(place(node));
}

void Builder::apply(const Node& node, const Statement& statement, const SceneStatement& meaning) {
  const bool repeated = std::find(applied_.begin(), applied_.end(), node.name) != applied_.end();
  if (meaning.count == SceneStatement::Count::once && repeated) {
    throw Error(ErrorCode::bad_value, place(node), fmt::format("a second '{}'", node.name), "a scene has one at most",
                "remove one of them");
  }
  applied_.push_back(statement.name);
  meaning.apply(call(node, statement), scene_);
  reject_children(node);
}

Builder::Operator Builder::open(const Node& node, const Statement& statement, const OperatorStatement& meaning,
                                Below below) {
  const bool is_part = node.name == "part";
  if (is_part) require_part_allowed(node, below);
  const Call arguments = call(node, statement, below.specials);
  Combine combine = meaning.make(arguments);
  if (is_part) warn_of_repeated_part(arguments);
  below.top = false;
  below.specials = arguments.specials();
  set_specials(node.children, below.specials);
  if (meaning.parts == OperatorStatement::Parts::forbidden) below.forbids_parts = &node;
  return {std::move(combine), below};
}

void Builder::reject_children(const Node& node) const {
  if (node.children.empty()) return;
  throw Error(ErrorCode::bad_value, place(node.children.front()), fmt::format("'{}' takes no children", node.name),
              "only operators, transforms and looks do", fmt::format("end '{}(..)' with ';'", node.name));
}

void Builder::require_top(const Node& node, const Below& below) const {
  if (below.top) return;
  throw Error(ErrorCode::bad_value, place(node), fmt::format("'{}' stands below another statement", node.name),
              "it concerns the whole picture", "move it to the top of the file, outside all { }");
}

void Builder::require_part_allowed(const Node& part, const Below& below) const {
  if (below.forbids_parts == nullptr) return;
  throw Error(ErrorCode::bad_value, place(part),
              fmt::format("a part cannot stand below '{}'", below.forbids_parts->name),
              "parts may only stand below unions, groups, transforms and looks",
              fmt::format("move it around the '{}' of line {}", below.forbids_parts->name, below.forbids_parts->line));
}

void Builder::warn_of_repeated_part(const Call& part) {
  const auto [first, is_new] = part_lines_.try_emplace(part.string("name").value(), part.place().line);
  if (is_new) return;
  part.warn(
      fmt::format("a part of line {} is named '{}' too: they stay two parts", first->second, shortened(first->first)));
}

}  // namespace

bool is_unsupported(const Node& statement) {
  const Statement* found = find_statement(statement.name);
  return found != nullptr && std::holds_alternative<UnsupportedStatement>(found->meaning);
}

SceneDescription build(Document document, const BuildOptions& options) {
  return Builder(std::move(document), options).build();
}

}  // namespace csgcast::text
