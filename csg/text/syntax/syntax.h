// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "csg/base/error.h"

namespace csgcast::text {

struct Value;
/// `[a, b, ...]`, possibly empty.
using List = std::vector<Value>;
struct Undef {
  friend bool operator==(Undef, Undef) = default;
};

/// A literal of the scene text. Numbers are kept as the double they read to; `inf` and `nan` stand as words (OpenSCAD
/// reads them as undef).
struct Value {
  struct Word {  ///< an identifier where a value stands: `inf`, `-inf`, `nan`; OpenSCAD reads it as undef
    std::string name;
    friend bool operator==(const Word&, const Word&) = default;
  };
  std::variant<Undef, bool, double, std::string, List, Word> data;
  int line = 0;
  int column = 0;

  /// Equal content; places do not count.
  friend bool operator==(const Value& a, const Value& b) { return a.data == b.data; }
};

/// `name = value`, or a positional value with an empty name.
struct Argument {
  std::string name;
  Value value;
  int line = 0;
  int column = 0;
  friend bool operator==(const Argument& a, const Argument& b) { return a.name == b.name && a.value == b.value; }
};

enum Modifier : std::uint8_t { background = 1, highlight = 2, root_only = 4, disabled = 8 };  // % # ! *

/// One statement of the scene text: any name, any arguments; what they mean is the builder's business.
struct Node {
  std::string name;
  std::uint8_t modifiers = 0;
  std::vector<Argument> arguments;
  /// The most significant digits of a number in the arguments, but for whole ones and those of special variables.
  std::uint8_t digits = 0;
  bool has_block = false;  ///< `{ }` rather than `;`
  std::vector<Node> children;
  int line = 0;
  int column = 0;

  // Copies, assignments and the destructor are iterative: trees may be a million deep.
  Node() = default;
  Node(const Node& other);
  Node(Node&&) noexcept = default;
  Node& operator=(const Node& other);
  Node& operator=(Node&&) noexcept = default;
  ~Node();

  /// Forgets arguments and children, and gives their memory back.
  void give_up();
};

/// Equal content, iteratively; places do not count.
bool operator==(const Node& a, const Node& b);

/// A whole scene text.
struct Document {
  FileName file;  ///< as errors name it
  std::vector<Node> nodes;

  /// Equal statements; the file's name does not count.
  friend bool operator==(const Document& a, const Document& b) { return a.nodes == b.nodes; }
};

}  // namespace csgcast::text
