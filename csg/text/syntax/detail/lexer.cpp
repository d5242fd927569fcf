// SPDX-License-Identifier: MIT
#include "csg/text/syntax/detail/lexer.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "csg/text/syntax/detail/utf8.h"
#include "csg/text/syntax/shortened.h"

namespace csgcast::text {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

std::optional<std::uint32_t> hexadecimal_digit(char c) {
  if (is_digit(c)) return static_cast<std::uint32_t>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<std::uint32_t>(c - 'a' + 10);
  if (c >= 'A' && c <= 'F') return static_cast<std::uint32_t>(c - 'A' + 10);
  return std::nullopt;
}

}  // namespace

std::string describe(const Token& token) {
  const std::string spelling = shortened(token.spelling);
  switch (token.kind) {
    case Token::Kind::end:
      return "the end of the text";
    case Token::Kind::identifier:
      return fmt::format("the word '{}'", spelling);
    case Token::Kind::number:
      return fmt::format("the number {}", spelling);
    case Token::Kind::string:
      return "a string";
    case Token::Kind::punctuation:
      break;
  }
  return fmt::format("'{}'", spelling);
}

Lexer::Lexer(std::string_view text, FileName file) : text_(text), file_(std::move(file)) {
  if (text_.substr(0, byte_order_mark.size()) == byte_order_mark) position_ = line_start_ = byte_order_mark.size();
}

char Lexer::peek(std::size_t ahead) const { return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0'; }

void Lexer::advance() {
  if (text_[position_++] != '\n') return;
  ++line_;
  line_start_ = position_;
}

int Lexer::column() const {
  constexpr std::size_t largest = std::numeric_limits<int>::max();
  return static_cast<int>(std::min(position_ - line_start_ + 1, largest));
}

Token Lexer::start_token(Token::Kind kind) const {
  Token token;
  token.kind = kind;
  token.line = line_;
  token.column = column();
  return token;
}

void Lexer::finish(Token& token, std::size_t start) const { token.spelling = text_.substr(start, position_ - start); }

Token Lexer::next() {
  skip_blanks();
  if (at_end()) return start_token(Token::Kind::end);
  const char c = peek();
  if (is_letter(c) || (c == '$' && is_letter(peek(1)))) return identifier();
  if (is_digit(c) || (c == '.' && is_digit(peek(1)))) return number();
  if (c == '"') return string();
  if (c < '!' || c > '~') reject_byte();
  Token token = start_token(Token::Kind::punctuation);
  const std::size_t start = position_;
  advance();
  finish(token, start);
  return token;
}

void Lexer::skip_blanks() {
  while (!at_end()) {
    if (is_blank(peek())) {
      advance();
    } else if (peek() == '/' && peek(1) == '/') {
      while (!at_end() && peek() != '\n') advance();
    } else if (peek() == '/' && peek(1) == '*') {
      skip_block_comment();
    } else {
      return;
    }
  }
}

void Lexer::skip_block_comment() {
  const Place start = here();
  advance();
  advance();
  while (!at_end()) {
    if (peek() == '*' && peek(1) == '/') {
      advance();
      advance();
      return;
    }
    advance();
  }
  throw Error(ErrorCode::syntax, start, "this comment is never closed", "the text ends inside it", "end it with '*/'");
}

Token Lexer::identifier() {
  Token token = start_token(Token::Kind::identifier);
  const std::size_t start = position_;
  advance();
  while (is_letter(peek()) || is_digit(peek())) advance();
  finish(token, start);
  return token;
}

Token Lexer::number() {
  Token token = start_token(Token::Kind::number);
  const std::size_t start = position_;
  while (is_digit(peek())) advance();
  if (peek() == '.') advance();
  while (is_digit(peek())) advance();
  if (peek() == 'e' || peek() == 'E') {
    const bool has_sign = peek(1) == '+' || peek(1) == '-';
    if (is_digit(peek(has_sign ? 2 : 1))) {
      advance();
      if (has_sign) advance();
      while (is_digit(peek())) advance();
    }
  }
  finish(token, start);
  if (is_letter(peek()) || peek() == '.') {
    throw Error(ErrorCode::syntax, here(), fmt::format("'{}' cannot follow {}", peek(), describe(token)),
                "numbers have no units and at most one point", "write a plain number such as 2.5 or 1e-3");
  }
  return token;
}

Token Lexer::string() {
  Token token = start_token(Token::Kind::string);
  const Place opening = here();
  const std::size_t start = position_;
  advance();
  while (!at_end() && peek() != '"') {
    if (peek() == '\\') {
      escape(token.content);
      continue;
    }
    if (peek() == '\0') reject_byte();
    token.content += peek();
    advance();
  }
  if (at_end()) {
    throw Error(ErrorCode::syntax, opening, "this string is never closed", "the text ends inside it",
                "end it with '\"'");
  }
  advance();
  finish(token, start);
  return token;
}

void Lexer::escape(std::string& content) {
  const Place start = here();
  advance();
  if (at_end()) return;  // the string's own error says more
  const char kind = peek();
  advance();
  switch (kind) {
    case '"':
    case '\\':
      content += kind;
      return;
    case 'n':
      content += '\n';
      return;
    case 't':
      content += '\t';
      return;
    case 'r':
      content += '\r';
      return;
    case 'x':
      return code_point(content, 2, start);
    case 'u':
      return code_point(content, 4, start);
    case 'U':
      return code_point(content, 6, start);
    default:
      break;
  }
  throw Error(ErrorCode::syntax, start, "unknown escape in a string", "after '\\' stands none of \" \\ n t r x u U",
              "write '\\\\' for a backslash");
}

void Lexer::code_point(std::string& content, std::size_t digits, const Place& start) {
  std::uint32_t code = 0;
  bool good = true;
  for (std::size_t i = 0; good && i < digits; ++i) {
    const auto digit = hexadecimal_digit(peek());
    good = digit.has_value();
    if (!good) break;
    code = code << 4 | *digit;
    advance();
  }
  if (digits == 2) good = good && code < 0x80;
  if (good && code == 0) code = ' ';  // as OpenSCAD does
  if (good && append_code_point(content, code)) return;
  if (at_end()) return;  // the string's own error says more
  throw Error(ErrorCode::syntax, start, "this escape stands for no character",
              "it takes two (x, up to 7f), four (u) or six (U) hexadecimal digits of a Unicode character",
              "write the character itself");
}

void Lexer::reject_byte() const {
  const auto byte = static_cast<unsigned char>(peek());
  const std::string remedy = "delete it; only strings and comments may hold other characters than ASCII";
  if (byte == 0) throw Error(ErrorCode::syntax, here(), "a zero byte", "this is not a text", "give a scene text");
  const auto code = first_code_point(text_.substr(position_, 4));
  if (!code) throw Error(ErrorCode::syntax, here(), fmt::format("byte 0x{:02x} is not UTF-8", byte), "", remedy);
  throw Error(ErrorCode::syntax, here(), fmt::format("unexpected character U+{:04X}", *code), "", remedy);
}

}  // namespace csgcast::text
