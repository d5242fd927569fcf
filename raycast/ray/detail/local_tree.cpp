// SPDX-License-Identifier: MIT
#include "raycast/ray/detail/local_tree.h"

#include <algorithm>

namespace csgcast::detail {

void LocalTree::clear() {
  entries_.clear();
  children_.clear();
  parent_.clear();
  leaves_.clear();
  entry_of_.clear();
  open_nodes_.clear();
  pending_.clear();
}

void LocalTree::add(Entry entry) {
  const auto index = static_cast<std::uint32_t>(entries_.size());
  pending_.push_back(index);
  entries_.push_back(entry);
  parent_.push_back(index);
}

void LocalTree::add_leaf(LeafId leaf) {
  entry_of_.push_back(static_cast<std::uint32_t>(entries_.size()));
  add({Node::Op::leaf, static_cast<std::uint32_t>(leaves_.size()), 0});
  leaves_.push_back(leaf);
}

// Closes the node on top of the stack. All its children have entries by now, and the node's own entry takes them.
void LocalTree::close() {
  const OpenNode top = open_nodes_.back();
  open_nodes_.pop_back();
  const Entry entry{top.node->op, static_cast<std::uint32_t>(children_.size()),
                    static_cast<std::uint32_t>(pending_.size() - top.pending)};
  for (std::size_t i = top.pending; i < pending_.size(); ++i)
    parent_[pending_[i]] = static_cast<std::uint32_t>(entries_.size());
  children_.insert(children_.end(), pending_.begin() + static_cast<std::ptrdiff_t>(top.pending), pending_.end());
  pending_.resize(top.pending);
  add(entry);
}

// The truth of an entry that is not a leaf, computed from its children's.
Truth LocalTree::value_of(const Entry& entry) const {
  const auto children = std::span(children_).subspan(entry.first, entry.count);
  switch (entry.op) {
    case Node::Op::leaf:
    case Node::Op::empty:
      return Truth::no;
    case Node::Op::everything:
      return Truth::yes;
    case Node::Op::complement:
      return opposite(value_[children[0]]);
    case Node::Op::unite: {
      Truth value = Truth::no;
      for (const std::uint32_t child : children) value = std::max(value, value_[child]);
      return value;
    }
    case Node::Op::intersect: {
      Truth value = Truth::yes;
      for (const std::uint32_t child : children) value = std::min(value, value_[child]);
      return value;
    }
    case Node::Op::subtract: {
      Truth value = value_[children[0]];
      for (const std::uint32_t child : children.subspan(1)) value = std::min(value, opposite(value_[child]));
      return value;
    }
  }
  return Truth::no;
}

Truth LocalTree::evaluate(std::span<const Truth> leaf_truth) {
  value_.resize(entries_.size());
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    value_[i] = entry.op == Node::Op::leaf ? leaf_truth[entry.first] : value_of(entry);
  }
  return value_.back();
}

Truth LocalTree::update(std::size_t slot, Truth leaf_truth) {
  std::uint32_t at = entry_of_[slot];
  Truth value = leaf_truth;
  while (value_[at] != value) {
    value_[at] = value;
    if (parent_[at] == at) break;
    at = parent_[at];
    value = value_of(entries_[at]);
  }
  return value_.back();
}

LeafId LocalTree::first_holding_leaf() {
  active_.assign(entries_.size(), 0);
  active_.back() = value_.back() == Truth::yes;
  LeafId first;
  for (std::size_t i = entries_.size(); i-- > 0;) {
    if (!active_[i]) continue;
    const Entry& entry = entries_[i];
    if (entry.op == Node::Op::leaf) first = std::min(first, leaves_[entry.first]);
    // In a difference only the first child can hold the place. In a complement no child can.
    std::uint32_t holding = 0;
    if (entry.op == Node::Op::unite || entry.op == Node::Op::intersect) holding = entry.count;
    if (entry.op == Node::Op::subtract) holding = 1;
    for (std::uint32_t k = 0; k < holding; ++k) {
      const std::uint32_t child = children_[entry.first + k];
      active_[child] = value_[child] == Truth::yes;
    }
  }
  return first;
}

}  // namespace csgcast::detail
