// SPDX-License-Identifier: MIT
#include "csg/text/statement/detail/call.h"

#include <fmt/format.h>

#include <algorithm>

#include "csg/base/number_text.h"
#include "csg/text/syntax/shortened.h"
#include "csg/text/syntax/suggestion.h"

namespace csgcast::text {
namespace {

std::string describe(const Value& value) {
  struct Describer {
    std::string operator()(Undef) const { return "undef"; }
    std::string operator()(bool truth) const { return truth ? "true" : "false"; }
    std::string operator()(double number) const { return shortest_number(number); }
    std::string operator()(const std::string&) const { return "a string"; }
    std::string operator()(const List& list) const {
      return fmt::format("a list with {} {}", list.size(), list.size() == 1 ? "entry" : "entries");
    }
    std::string operator()(const Value::Word& word) const { return word.name; }
  };
  return std::visit(Describer{}, value.data);
}

/// The first `inf` or `nan` in a value; null if there is none. Lists nest at most 1,000 deep, so this may recurse.
const Value::Word* first_word(const Value& value) {
  if (const auto* word = std::get_if<Value::Word>(&value.data)) return word;
  const auto* list = std::get_if<List>(&value.data);
  if (list == nullptr) return nullptr;
  for (const Value& entry : *list) {
    if (const auto* word = first_word(entry)) return word;
  }
  return nullptr;
}

/// The numbers of a list with `least` to three entries, the others being `third`; nothing if one of them counts as
/// undef, null if the value is no such list.
struct VectorReading {
  bool fits = false;
  std::optional<Vector> vector;
};

VectorReading read_vector(const Value& value, std::size_t least, double third) {
  const auto* list = std::get_if<List>(&value.data);
  if (list == nullptr || list->size() < least || list->size() > 3) return {};
  Vector vector{third, third, third};
  bool defined = true;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const Value& entry = (*list)[i];
    const auto* number = std::get_if<double>(&entry.data);
    if (number == nullptr && !counts_as_undef(entry)) return {};
    if (number == nullptr) defined = false;
    if (number != nullptr) vector[i] = *number;
  }
  return {true, defined ? std::optional(vector) : std::nullopt};
}

}  // namespace

bool counts_as_undef(const Value& value) {
  return std::holds_alternative<Undef>(value.data) || std::holds_alternative<Value::Word>(value.data);
}

Call::Call(const Node& node, const FileName& file, const Parameters& parameters, const BuildOptions& options,
           const SpecialVariables& specials, SceneDescription& scene)
    : node_(node), file_(file), options_(options), specials_(specials), scene_(scene) {
  std::size_t position = 0;
  for (const Argument& argument : node.arguments) bind(argument, parameters, position);
}

void Call::bind(const Argument& argument, const Parameters& parameters, std::size_t& position) {
  const auto at = [&] { return Place{file_, argument.line, argument.column}; };
  std::string_view name = argument.name;
  if (name.empty()) {
    if (position == parameters.positional.size()) {
      reject(ErrorCode::bad_value, at(), fmt::format("too many arguments for '{}'", node_.name),
             fmt::format("it takes {} without a name", parameters.positional.size()), "remove this one or name it");
    }
    name = parameters.positional[position++];
  } else {
    const auto has = [&](const auto& names) { return std::find(names.begin(), names.end(), name) != names.end(); };
    if (!has(parameters.positional) && !has(parameters.named)) unknown_argument(argument, parameters);
  }
  const auto same_name = [&](const auto& other) { return other.first == name; };
  if (std::any_of(bound_.begin(), bound_.end(), same_name)) {
    reject(ErrorCode::bad_value, at(), fmt::format("'{}' of '{}' is given twice", name, node_.name), "", "remove one");
  }
  bound_.emplace_back(name, &argument);
  warn_of_words(argument, name);
}

void Call::warn_of_words(const Argument& argument, std::string_view name) const {
  const Value::Word* word = first_word(argument.value);
  if (word == nullptr) return;
  scene_.warnings.push_back(
      {{file_, argument.line, argument.column},
       fmt::format("'{}' in '{}' of '{}' counts as undef, as in OpenSCAD", word->name, name, node_.name)});
}

void Call::unknown_argument(const Argument& argument, const Parameters& parameters) const {
  std::vector<std::string_view> known = parameters.positional;
  known.insert(known.end(), parameters.named.begin(), parameters.named.end());
  const std::string all =
      known.empty() ? "it takes none; remove this one" : fmt::format("it takes {}", fmt::join(known, ", "));
  reject(ErrorCode::unknown_name, {file_, argument.line, argument.column},
         fmt::format("'{}' has no argument '{}'", node_.name, shortened(argument.name)), "",
         did_you_mean(argument.name, known, all));
}

Place Call::place(std::string_view name) const {
  for (const auto& [bound_name, argument] : bound_) {
    if (bound_name == name) return {file_, argument->line, argument->column};
  }
  return place();
}

const Value* Call::find(std::string_view name) const {
  for (const auto& [bound_name, argument] : bound_) {
    if (bound_name == name) return counts_as_undef(argument->value) ? nullptr : &argument->value;
  }
  return nullptr;
}

std::optional<double> Call::number(std::string_view name) const {
  const Value* value = find(name);
  if (value == nullptr) return std::nullopt;
  const auto* number = std::get_if<double>(&value->data);
  if (number == nullptr) wrong_type(name, *value, "a number");
  return *number;
}

double Call::number_or(std::string_view name, double otherwise) const { return number(name).value_or(otherwise); }

SpecialVariables Call::specials() const {
  SpecialVariables said = specials_;
  for (const std::string_view name : SpecialVariables::names) {
    if (const std::optional<double> own = number(name)) *said.find(name) = own;
  }
  return said;
}

Fineness Call::fineness() const {
  constexpr Fineness otherwise;
  const SpecialVariables said = specials();
  return {said.fn.value_or(otherwise.fn), said.fa.value_or(otherwise.fa), said.fs.value_or(otherwise.fs)};
}

double Call::required_number(std::string_view name) const {
  const auto result = number(name);
  if (!result) missing(name, "a number");
  return *result;
}

bool Call::boolean_or(std::string_view name, bool otherwise) const {
  const Value* value = find(name);
  if (value == nullptr) return otherwise;
  const auto* truth = std::get_if<bool>(&value->data);
  if (truth == nullptr) wrong_type(name, *value, "true or false");
  return *truth;
}

std::optional<std::string> Call::string(std::string_view name) const {
  const Value* value = find(name);
  if (value == nullptr) return std::nullopt;
  const auto* content = std::get_if<std::string>(&value->data);
  if (content == nullptr) wrong_type(name, *value, "a \"string\"");
  return *content;
}

std::optional<Vector> Call::vector(std::string_view name) const {
  const Value* value = find(name);
  if (value == nullptr) return std::nullopt;
  const VectorReading reading = read_vector(*value, 3, 0);
  if (!reading.fits) wrong_type(name, *value, "a list of three numbers");
  return reading.vector;
}

Vector Call::required_vector(std::string_view name) const {
  const auto result = vector(name);
  if (!result) missing(name, "a list of three numbers");
  return *result;
}

std::optional<Vector> Call::padded_vector(std::string_view name, double third) const {
  const Value* value = find(name);
  if (value == nullptr) return std::nullopt;
  const VectorReading reading = read_vector(*value, 2, third);
  if (!reading.fits) wrong_type(name, *value, "a list of two or three numbers");
  return reading.vector;
}

std::optional<Rgb> Call::rgb(std::string_view name) const {
  const auto channels = vector(name);
  if (!channels) return std::nullopt;
  require(channels->x >= 0 && channels->y >= 0 && channels->z >= 0, name, "not have a negative channel");
  return Rgb{channels->x, channels->y, channels->z};
}

const List* Call::list(std::string_view name) const {
  const Value* value = find(name);
  if (value == nullptr) return nullptr;
  const auto* list = std::get_if<List>(&value->data);
  if (list == nullptr) wrong_type(name, *value, "a list");
  return list;
}

double Call::entry(const Value& value, std::string_view what) const {
  const auto* number = std::get_if<double>(&value.data);
  if (number != nullptr) return *number;
  reject(ErrorCode::wrong_type, place(value), fmt::format("{} of '{}' must be a number", what, node_.name),
         fmt::format("it is {}", describe(value)), "give a number");
}

Vector Call::vector_entry(const Value& value, std::string_view what) const {
  const VectorReading reading = read_vector(value, 3, 0);
  if (reading.vector) return *reading.vector;
  reject(ErrorCode::wrong_type, place(value),
         fmt::format("{} of '{}' must be a list of three numbers", what, node_.name),
         fmt::format("it is {}", describe(value)), "give [x, y, z]");
}

const List& Call::list_entry(const Value& value, std::string_view what) const {
  const auto* list = std::get_if<List>(&value.data);
  if (list != nullptr) return *list;
  reject(ErrorCode::wrong_type, place(value), fmt::format("{} of '{}' must be a list", what, node_.name),
         fmt::format("it is {}", describe(value)), "put it into [ ]");
}

void Call::require(bool holds, std::string_view name, std::string_view rule) const {
  if (holds) return;
  const Value* value = find(name);
  reject(ErrorCode::bad_value, place(name), fmt::format("'{}' of '{}' must {}", name, node_.name, rule),
         value == nullptr ? "" : fmt::format("it is {}", describe(*value)), "give another value");
}

void Call::require(const std::optional<BrokenRule>& broken) const {
  if (broken) require(false, broken->argument, broken->rule);
}

void Call::missing(std::string_view name, std::string_view what) const {
  reject(ErrorCode::bad_value, place(), fmt::format("'{}' needs the argument '{}'", node_.name, name),
         "it has no default", fmt::format("give {}", what));
}

void Call::wrong_type(std::string_view name, const Value& value, std::string_view expected) const {
  reject(ErrorCode::wrong_type, place(name), fmt::format("'{}' of '{}' must be {}", name, node_.name, expected),
         fmt::format("it is {}", describe(value)), fmt::format("give {}", expected));
}

void Call::reject(ErrorCode code, const Place& place, const std::string& problem, const std::string& why,
                  const std::string& remedy) const {
  throw Error(code, place, problem, why, remedy);
}

}  // namespace csgcast::text
