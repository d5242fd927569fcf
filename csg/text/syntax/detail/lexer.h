// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "csg/base/error.h"

namespace csgcast::text {

struct Token {
  enum class Kind { end, identifier, number, string, punctuation };

  Kind kind = Kind::end;
  std::string_view spelling;  ///< as it stands in the text; of the end: empty
  std::string content;        ///< of a string: what its escapes stand for
  int line = 0;
  int column = 0;

  bool is(char mark) const { return kind == Kind::punctuation && spelling[0] == mark; }
};

/// The token in an error message's words: `'{'`, `the word 'cube'`, `the end of the text`.
std::string describe(const Token& token);

/// Cuts a scene text into tokens, leaving out white space and comments. Any printable ASCII character that starts
/// nothing else is punctuation; what it means is the reader's business. Throws Error(syntax) for bytes that no text has
/// (control characters, broken UTF-8, other letters outside strings and comments), and for strings and comments that
/// are never closed, at their start.
class Lexer {
 public:
  /// `text` must outlive the lexer and its tokens.
  Lexer(std::string_view text, FileName file);

  Token next();
  const FileName& file() const { return file_; }

 private:
  bool at_end() const { return position_ >= text_.size(); }
  /// The byte `ahead` of the present one; 0 past the end.
  char peek(std::size_t ahead = 0) const;
  void advance();
  int column() const;
  Place here() const { return {file_, line_, column()}; }

  void skip_blanks();
  void skip_block_comment();
  Token start_token(Token::Kind kind) const;
  void finish(Token& token, std::size_t start) const;
  Token identifier();
  Token number();
  Token string();
  void escape(std::string& content);
  void code_point(std::string& content, std::size_t digits, const Place& start);
  [[noreturn]] void reject_byte() const;

  std::string_view text_;
  FileName file_;
  std::size_t position_ = 0;
  std::size_t line_start_ = 0;
  int line_ = 1;
};

}  // namespace csgcast::text
