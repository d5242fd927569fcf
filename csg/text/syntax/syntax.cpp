// SPDX-License-Identifier: MIT
#include "csg/text/syntax/syntax.h"

#include <utility>

namespace csgcast::text {
namespace {

/// All of a node but its children.
void copy_statement(const Node& from, Node& to) {
  to.name = from.name;
  to.modifiers = from.modifiers;
  to.arguments = from.arguments;
  to.has_block = from.has_block;
  to.line = from.line;
  to.column = from.column;
}

bool equal_statements(const Node& a, const Node& b) {
  return a.name == b.name && a.modifiers == b.modifiers && a.has_block == b.has_block &&
         a.children.size() == b.children.size() && a.arguments == b.arguments;
}

}  // namespace

Node::Node(const Node& other) {
  std::vector<std::pair<const Node*, Node*>> pending{{&other, this}};
  while (!pending.empty()) {
    const auto [from, to] = pending.back();
    pending.pop_back();
    copy_statement(*from, *to);
    to->children.resize(from->children.size());
    for (std::size_t i = 0; i < from->children.size(); ++i) pending.emplace_back(&from->children[i], &to->children[i]);
  }
}

Node& Node::operator=(const Node& other) {
  if (this != &other) *this = Node(other);
  return *this;
}

Node::~Node() {
  if (children.empty()) return;
  // Each round frees a list whose nodes have handed their own children over, so no destructor finds anything below it.
  std::vector<std::vector<Node>> pending;
  pending.push_back(std::move(children));
  while (!pending.empty()) {
    std::vector<Node> siblings = std::move(pending.back());
    pending.pop_back();
    for (Node& node : siblings) {
      if (!node.children.empty()) pending.push_back(std::exchange(node.children, {}));
    }
  }
}

void Node::give_up() {
  std::vector<Argument>().swap(arguments);
  Node below;  // takes them apart without recursion
  below.children.swap(children);
}

bool operator==(const Node& a, const Node& b) {
  std::vector<std::pair<const Node*, const Node*>> pending{{&a, &b}};
  while (!pending.empty()) {
    const auto [left, right] = pending.back();
    pending.pop_back();
    if (!equal_statements(*left, *right)) return false;
    for (std::size_t i = 0; i < left->children.size(); ++i) {
      pending.emplace_back(&left->children[i], &right->children[i]);
    }
  }
  return true;
}

}  // namespace csgcast::text
