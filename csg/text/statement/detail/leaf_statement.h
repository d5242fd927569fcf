// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "csg/solid/solid.h"
#include "csg/text/syntax/syntax.h"

namespace csgcast::text {

Value number_value(double number);
Value list_value(const Vector& v);
/// A statement without a block and without arguments.
Node statement(std::string name);
/// Counts the value's digits for Node::digits.
void add_argument(Node& node, std::string name, Value value);

/// The statement that makes a leaf with exactly these forms, or the same set; none if there is none in doubles.
std::optional<Node> leaf_statement(const LeafShape& shape);

}  // namespace csgcast::text
