// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "csg/base/digits.h"
#include "csg/base/error.h"
#include "csg/base/vector.h"
#include "csg/solid/look.h"
#include "csg/solid/rules/rules.h"
#include "csg/solid/scene_description.h"
#include "csg/text/statement/builder.h"
#include "csg/text/statement/detail/facets.h"
#include "csg/text/syntax/syntax.h"

namespace csgcast::text {

/// The argument names of a statement: positional ones in order, and those that must be named.
struct Parameters {
  std::vector<std::string_view> positional;
  std::vector<std::string_view> named;
};

/// What statements say of `$fn`, `$fa` and `$fs` to all that is below them.
struct SpecialVariables {
  static constexpr std::array<std::string_view, 3> names{"$fn", "$fa", "$fs"};

  std::optional<double> fn{};
  std::optional<double> fa{};
  std::optional<double> fs{};

  /// What is said of one of the names; null for another name.
  std::optional<double>* find(std::string_view name) {
    return name == "$fn" ? &fn : name == "$fa" ? &fa : name == "$fs" ? &fs : nullptr;
  }
};

/// Whether OpenSCAD reads the value as undef: `undef`, `inf`, `nan`.
bool counts_as_undef(const Value& value);

/// A statement with its arguments bound to names and typed access to them.
///
/// As in OpenSCAD, `undef`, `inf` and `nan` count as an argument that is not given (with a warning for the last two),
/// and so does a vector that holds one. Everything else of the wrong type throws Error(wrong_type) at the argument, or
/// at the entry of its list.
class Call {
 public:
  /// Throws Error(unknown_name) for a name that is none of the parameters, Error(bad_value) for one given twice and for
  /// too many positional ones.
  Call(const Node& node, const FileName& file, const Parameters& parameters, const BuildOptions& options,
       const SpecialVariables& specials, SceneDescription& scene);

  const std::string& name() const { return node_.name; }
  Place place() const { return {file_, node_.line, node_.column}; }
  Place place(const Value& value) const { return {file_, value.line, value.column}; }
  /// Where the argument stands; the statement's place if it is not given.
  Place place(std::string_view name) const;
  const BuildOptions& options() const { return options_; }
  /// How many the numbers of the text have.
  Digits digits() const { return scene_.digits; }
  void warn(std::string text) const { scene_.warnings.push_back({place(), std::move(text)}); }
  /// Says that something round became a polyhedron.
  void count_faceted() const { ++scene_.faceted; }

  /// The value of an argument; null if it counts as not given.
  const Value* find(std::string_view name) const;

  std::optional<double> number(std::string_view name) const;
  double number_or(std::string_view name, double otherwise) const;
  double required_number(std::string_view name) const;
  /// `$fn`, `$fa` and `$fs` of this statement: its own arguments, else what the statements around it say.
  SpecialVariables specials() const;
  /// The same, with OpenSCAD's defaults for what nothing says.
  Fineness fineness() const;
  bool boolean_or(std::string_view name, bool otherwise) const;
  std::optional<std::string> string(std::string_view name) const;
  /// A list of exactly three numbers.
  std::optional<Vector> vector(std::string_view name) const;
  Vector required_vector(std::string_view name) const;
  /// A list of two or three numbers; `third` stands for the last one if it is missing.
  std::optional<Vector> padded_vector(std::string_view name, double third) const;
  /// A list of three numbers that are not negative: linear light or absorption.
  std::optional<Rgb> rgb(std::string_view name) const;
  /// A list of any values; null if it counts as not given.
  const List* list(std::string_view name) const;

  // Entries of lists; `what` names them in errors ("a point", "a face").
  double entry(const Value& value, std::string_view what) const;
  Vector vector_entry(const Value& value, std::string_view what) const;
  const List& list_entry(const Value& value, std::string_view what) const;

  /// Throws Error(bad_value) at the argument unless `holds`; `rule` goes on from "'r' of 'sphere' must ".
  void require(bool holds, std::string_view name, std::string_view rule) const;
  /// Likewise if a rule is broken.
  void require(const std::optional<BrokenRule>& broken) const;
  [[noreturn]] void missing(std::string_view name, std::string_view what) const;
  [[noreturn]] void reject(ErrorCode code, const Place& place, const std::string& problem, const std::string& why,
                           const std::string& remedy) const;

 private:
  void bind(const Argument& argument, const Parameters& parameters, std::size_t& position);
  void warn_of_words(const Argument& argument, std::string_view name) const;
  [[noreturn]] void wrong_type(std::string_view name, const Value& value, std::string_view expected) const;
  [[noreturn]] void unknown_argument(const Argument& argument, const Parameters& parameters) const;

  const Node& node_;
  const FileName& file_;
  const BuildOptions& options_;
  SpecialVariables specials_;
  SceneDescription& scene_;
  std::vector<std::pair<std::string_view, const Argument*>> bound_;
};

}  // namespace csgcast::text
