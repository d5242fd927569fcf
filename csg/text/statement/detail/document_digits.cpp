// SPDX-License-Identifier: MIT
#include "csg/text/statement/detail/document_digits.h"

#include <cmath>
#include <cstdint>
#include <span>

#include "csg/text/statement/detail/statements.h"
#include "csg/text/syntax/each_statement.h"

namespace csgcast::text {
namespace {

/// An argument of `settings` by its name, or its place among those without a name.
const Value* argument(const Node& node, std::string_view name, std::size_t place) {
  std::size_t unnamed = 0;
  for (const Argument& argument : node.arguments) {
    if (argument.name == name || (argument.name.empty() && unnamed++ == place)) return &argument.value;
  }
  return nullptr;
}

bool has_lengths(const Node& node) {
  const Statement* statement = find_statement(node.name);
  return statement != nullptr && statement->has_lengths;
}

}  // namespace

bool is_digit_count(double number) { return number >= 1 && number <= Digits::most && number == std::trunc(number); }

std::optional<Digits> digits_given(const Document& document) {
  for (const Node& node : document.nodes) {
    if (node.name != "settings" || (node.modifiers & (background | disabled)) != 0) continue;
    const Value* value = argument(node, "digits", 2);
    const double* number = value != nullptr ? std::get_if<double>(&value->data) : nullptr;
    if (number != nullptr && is_digit_count(*number)) return Digits(static_cast<int>(*number));
  }
  return std::nullopt;
}

Digits digits_shown(const Document& document) {
  std::uint8_t most = 0;
  each_statement(std::span(document.nodes), [&](const Node& node) {
    if (node.digits > most && has_lengths(node)) most = node.digits;
  });
  return most >= Digits::fewest_shown && most <= Digits::most_rounded ? Digits(most) : Digits();
}

}  // namespace csgcast::text
