// SPDX-License-Identifier: MIT
#include "csg/text/syntax/detail/parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "csg/base/digits.h"
#include "csg/base/number_text.h"
#include "csg/text/syntax/openscad_language.h"
#include "csg/text/syntax/shortened.h"

namespace csgcast::text {
namespace {

constexpr int deepest_list = 1000;
constexpr std::size_t longest_list = std::size_t{1} << 22;
constexpr std::size_t most_arguments = 1000;

Value value_at(const Token& token) {
  Value value;
  value.line = token.line;
  value.column = token.column;
  return value;
}

std::uint8_t modifier_of(const Token& token) {
  if (token.is('%')) return background;
  if (token.is('#')) return highlight;
  if (token.is('!')) return root_only;
  return token.is('*') ? disabled : 0;
}

/// Marks that go on with an expression where a plain value has ended, or begin one.
bool is_operator(const Token& token) {
  constexpr std::string_view operators = "+-*/%^<>=&|!?:.(";
  return token.kind == Token::Kind::punctuation && operators.find(token.spelling[0]) != std::string_view::npos;
}

}  // namespace

Parser::Parser(std::string_view text, const FileName& file) : lexer_(text, file) { step(); }

void Parser::step() { token_ = lexer_.next(); }

bool Parser::accept(char mark) {
  if (!token_.is(mark)) return false;
  step();
  return true;
}

void Parser::fail(const Token& token, const std::string& expected, std::string_view remedy) const {
  throw Error(ErrorCode::syntax, place(token), fmt::format("expected {}, found {}", expected, describe(token)), "",
              std::string(remedy));
}

void Parser::never_closed(const Token& opening) const {
  const std::string_view mark = opening.is('{') ? "}" : opening.is('(') ? ")" : "]";
  throw Error(ErrorCode::syntax, place(opening), fmt::format("'{}' is never closed", opening.spelling),
              "the text ends before", fmt::format("add the missing '{}'", mark));
}

void Parser::reject_language(const Token& token, const std::string& problem) const {
  throw Error(ErrorCode::syntax, place(token), problem, std::string(language_reason), std::string(export_remedy));
}

void Parser::too_much(const Token& token, const std::string& problem, const std::string& why) const {
  throw Error(ErrorCode::limit, place(token), problem, why, "split it");
}

/// What is being read, and the brace that opened it.
struct Parser::Open {
  enum class Kind : std::uint8_t {
    block,   ///< a statement with a block
    child,   ///< a statement whose only child goes on without a block
    braces,  ///< a block without a statement: its statements belong to what is around it
  };
  Kind kind;
  Node node;
  Token brace;
};

std::vector<Node> Parser::statements() {
  std::vector<Node> top;
  std::vector<Open> open;
  const auto siblings = [&]() -> std::vector<Node>& { return open.empty() ? top : open.back().node.children; };
  // A statement is done, and so are those whose only child it is.
  const auto done = [&](Node node) {
    siblings().push_back(std::move(node));
    while (!open.empty() && open.back().kind == Open::Kind::child) {
      Node parent = std::move(open.back().node);
      open.pop_back();
      siblings().push_back(std::move(parent));
    }
  };
  const auto close = [&] {
    Open last = std::move(open.back());
    open.pop_back();
    if (last.kind == Open::Kind::block) return done(std::move(last.node));
    for (Node& node : last.node.children) siblings().push_back(std::move(node));
  };
  while (true) {
    const bool awaits_child = !open.empty() && open.back().kind == Open::Kind::child;
    if (token_.kind == Token::Kind::end && open.empty()) return top;
    if (token_.kind == Token::Kind::end && !awaits_child) never_closed(open.back().brace);
    if (!awaits_child && accept(';')) continue;
    if (!awaits_child && token_.is('{')) {
      open.push_back({Open::Kind::braces, {}, token_});
      step();
      continue;
    }
    if (!open.empty() && !awaits_child && accept('}')) {
      close();
      continue;
    }
    Node node = statement_head();
    if (node.name.starts_with('$')) {
      if (awaits_child) fail(token_, "a statement", "put the variable before it, with a ';'");
      siblings().push_back(std::move(node));
    } else if (token_.is('{')) {
      node.has_block = true;
      open.push_back({Open::Kind::block, std::move(node), token_});
      step();
    } else if (accept(';')) {
      done(std::move(node));
    } else if (token_.kind == Token::Kind::identifier || modifier_of(token_) != 0) {
      node.has_block = true;
      open.push_back({Open::Kind::child, std::move(node), token_});
    } else {
      fail(token_, fmt::format("';' or '{{' after '{}(..)'", shortened(node.name)),
           "end the statement with ';' or give it a block { .. }");
    }
  }
}

Node Parser::statement_head() {
  Node node;
  node.modifiers = modifiers();
  if (token_.is('}'))
    fail(token_, "a statement", "remove this '}', which closes nothing, or add the '{' that it lacks");
  if (token_.kind != Token::Kind::identifier) fail(token_, "a statement", "write one such as cube(size = 1);");
  const Token name = token_;
  step();
  node.name = name.spelling;
  node.line = name.line;
  node.column = name.column;
  if (name.spelling.starts_with('$') && token_.is('=')) return special_variable(name, node.modifiers);
  if (is_openscad_keyword(node.name)) reject_language(name, fmt::format("'{}' is no statement of a scene", node.name));
  if (token_.is('=')) reject_language(name, fmt::format("'{}' is a variable", shortened(node.name)));
  if (!token_.is('('))
    fail(token_, fmt::format("'(' after '{}'", shortened(node.name)),
         "write its arguments in ( ), even if there are none");
  const Token opening = token_;
  step();
  digits_ = 0;
  node.arguments = arguments(opening);
  node.digits = static_cast<std::uint8_t>(std::min(digits_, Digits::most));
  return node;
}

/// `$fn = 50;` as a statement of that name with the value as its only argument.
Node Parser::special_variable(const Token& name, std::uint8_t modifiers) {
  Node node;
  node.name = name.spelling;
  node.line = name.line;
  node.column = name.column;
  node.modifiers = modifiers;
  step();
  Argument argument;
  argument.line = token_.line;
  argument.column = token_.column;
  argument.value = value(0);
  node.arguments.push_back(std::move(argument));
  reject_expression();
  if (!accept(';')) fail(token_, fmt::format("';' after the value of '{}'", node.name), "end it with ';'");
  return node;
}

std::uint8_t Parser::modifiers() {
  std::uint8_t result = 0;
  while (const std::uint8_t modifier = modifier_of(token_)) {
    result = static_cast<std::uint8_t>(result | modifier);
    step();
  }
  return result;
}

std::vector<Argument> Parser::arguments(const Token& opening) {
  std::vector<Argument> result;
  while (!accept(')')) {
    if (token_.kind == Token::Kind::end) never_closed(opening);
    if (result.size() == most_arguments) too_much(token_, "too many arguments", "a statement may have 1,000");
    result.push_back(argument());
    if (token_.is(')') || accept(',')) continue;
    if (token_.kind == Token::Kind::end) never_closed(opening);
    reject_expression();
    fail(token_, "',' or ')' after an argument", "separate arguments with ','");
  }
  return result;
}

Argument Parser::argument() {
  Argument result;
  result.line = token_.line;
  result.column = token_.column;
  if (token_.kind != Token::Kind::identifier) {
    result.value = value(0);
    return result;
  }
  const Token first = token_;
  step();
  if (accept('=')) {
    const int before = digits_;
    result.name = first.spelling;
    result.value = value(0);
    if (result.name.starts_with('$')) digits_ = before;
  } else {
    result.value = word(first);
  }
  return result;
}

Value Parser::value(int depth) {
  const Token first = token_;
  Value result = value_at(first);
  switch (first.kind) {
    case Token::Kind::number:
      return number(first, Sign::plus);
    case Token::Kind::identifier:
      step();
      return word(first);
    case Token::Kind::string:
      result.data = first.content;
      step();
      return result;
    case Token::Kind::punctuation:
      if (first.is('+') || first.is('-')) return signed_value();
      if (!first.is('[')) break;
      result.data = list(depth + 1);
      return result;
    case Token::Kind::end:
      break;
  }
  reject_expression();
  fail(first, "a value", "write a number, true, false, undef, a \"string\" or a [list]");
}

Value Parser::signed_value() {
  const Token first = token_;
  const Sign sign = first.is('-') ? Sign::minus : Sign::plus;
  step();
  if (token_.kind == Token::Kind::number) return number(first, sign);
  const bool is_word = token_.spelling == "inf" || token_.spelling == "nan";
  if (!is_word) {
    if (token_.kind == Token::Kind::identifier)
      reject_language(token_, fmt::format("'{}' is no number", shortened(token_.spelling)));
    fail(token_, fmt::format("a number after '{}'", first.spelling), "write a plain number such as -2.5");
  }
  Value result = value_at(first);
  result.data = Value::Word{fmt::format("{}{}", sign == Sign::minus ? "-" : "", token_.spelling)};
  step();
  return result;
}

Value Parser::number(const Token& first, Sign sign) {
  const ParsedNumber magnitude = parse_number(token_.spelling);
  if (magnitude.fault != NumberFault::none) {
    throw Error(ErrorCode::bad_value, place(first), fmt::format("{} is too large", describe(token_)),
                "the largest double is about 1.8e308", "write a smaller number");
  }
  if (magnitude.value != std::trunc(magnitude.value)) digits_ = std::max(digits_, digits_written(token_.spelling));
  Value result = value_at(first);
  result.data = sign == Sign::minus ? -magnitude.value : magnitude.value;
  step();
  return result;
}

Value Parser::word(const Token& word) const {
  Value result = value_at(word);
  if (word.spelling == "true" || word.spelling == "false") {
    result.data = word.spelling == "true";
  } else if (word.spelling == "inf" || word.spelling == "nan") {
    result.data = Value::Word{std::string(word.spelling)};
  } else if (word.spelling != "undef") {
    reject_language(word, fmt::format("'{}' is no value", shortened(word.spelling)));
  }
  return result;
}

List Parser::list(int depth) {
  const Token opening = token_;
  if (depth > deepest_list) {
    throw Error(ErrorCode::limit, place(opening), "this list is nested too deeply", "lists may nest 1,000 deep",
                "remove brackets");
  }
  step();
  List result;
  while (!accept(']')) {
    if (token_.kind == Token::Kind::end) never_closed(opening);
    if (result.size() == longest_list) too_much(token_, "this list is too long", "a list may have 4,194,304 entries");
    if (result.empty()) result.reserve(4);
    result.push_back(value(depth));
    if (token_.is(']') || accept(',')) continue;
    if (token_.kind == Token::Kind::end) never_closed(opening);
    reject_expression();
    fail(token_, "',' or ']' after a list's entry", "separate entries with ','");
  }
  return result;
}

void Parser::reject_expression() const {
  if (is_operator(token_)) reject_language(token_, fmt::format("unexpected {} in a value", describe(token_)));
}

}  // namespace csgcast::text
