// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "csg/text/syntax/detail/lexer.h"
#include "csg/text/syntax/syntax.h"

namespace csgcast::text {

/// The grammar, one token ahead. See reader.h for what it throws.
///
///     statement := ";" | "{" statement* "}" | SPECIAL "=" value ";"
///                | ("%" | "#" | "!" | "*")* NAME "(" arguments ")" (";" | "{" statement* "}" | statement)
///
/// SPECIAL is a name that begins with `$`. A block without a name is its statements; `;` alone is nothing.
///
///     arguments := [argument ("," argument)* [","]]     argument := [NAME "="] value
///     value     := ["+" | "-"] NUMBER | ["+" | "-"] ("inf" | "nan") | "true" | "false" | "undef" | STRING
///                | "[" [value ("," value)* [","]] "]"
class Parser {
 public:
  Parser(std::string_view text, const FileName& file);

  /// All statements of the text.
  std::vector<Node> statements();

 private:
  struct Open;
  enum class Sign { plus, minus };

  void step();
  bool accept(char mark);
  [[noreturn]] void fail(const Token& token, const std::string& expected, std::string_view remedy) const;
  [[noreturn]] void never_closed(const Token& opening) const;
  [[noreturn]] void reject_language(const Token& token, const std::string& problem) const;
  [[noreturn]] void too_much(const Token& token, const std::string& problem, const std::string& why) const;

  Node statement_head();
  Node special_variable(const Token& name, std::uint8_t modifiers);
  std::uint8_t modifiers();
  std::vector<Argument> arguments(const Token& opening);
  Argument argument();
  Value value(int depth);
  Value signed_value();
  Value number(const Token& first, Sign sign);
  Value word(const Token& word) const;
  List list(int depth);
  void reject_expression() const;

  Place place(const Token& token) const { return {lexer_.file(), token.line, token.column}; }

  Lexer lexer_;
  Token token_;
  int digits_ = 0;  ///< Node::digits of the statement that is being read
};

}  // namespace csgcast::text
