// SPDX-License-Identifier: MIT
#include "raycast/cells/build/cut_look.h"

#include <algorithm>

namespace csgcast::detail {
namespace {

constexpr std::size_t most_entries = 128;

}  // namespace

HolderTree::HolderTree(const Scene& scene, NodeId root) {
  // A node that still has to be laid out, and the entry that it is an operand of.
  struct Open {
    NodeId node;
    std::size_t parent;
  };
  constexpr std::size_t no_parent = most_entries;
  std::vector<Open> open{{root, no_parent}};
  std::vector<std::size_t> parents;
  while (!open.empty()) {
    const Open at = open.back();
    open.pop_back();
    if (entries_.size() == most_entries) return;
    const Node& node = scene.node(at.node);
    Entry entry;
    std::size_t operands = 0;
    const auto children = node.op == Node::Op::leaf ? std::span<const NodeId>() : scene.children(node);
    switch (node.op) {
      case Node::Op::leaf:
        entry.op = Entry::Op::leaf;
        entry.leaf = LeafId(node.first);
        break;
      case Node::Op::unite:
      case Node::Op::intersect:
        entry.op = node.op == Node::Op::unite ? Entry::Op::unite : Entry::Op::intersect;
        operands = children.size();
        break;
      case Node::Op::subtract:
        entry.op = Entry::Op::subtract;
        operands = 1;
        break;
      default:
        break;
    }
    const std::size_t index = entries_.size();
    entries_.push_back(entry);
    parents.push_back(at.parent);
    for (std::size_t k = operands; k-- > 0;) open.push_back({children[k], index});
  }
  for (std::size_t i = entries_.size(); i-- > 0;) {
    entries_[i].end = std::max(entries_[i].end, static_cast<std::uint32_t>(i + 1));
    if (parents[i] == no_parent) continue;
    Entry& parent = entries_[parents[i]];
    parent.end = std::max(parent.end, entries_[i].end);
  }
  is_small_ = true;
}

// Sets the value of each entry. Operands come after their operators, so their values are known first when going
// backwards.
void HolderTree::evaluate(Search& search, const std::function<Truth(LeafId)>& leaf) const {
  std::vector<Truth>& value = search.value;
  value.assign(entries_.size(), Truth::unknown);
  for (std::size_t i = entries_.size(); i-- > 0;) {
    const Entry& entry = entries_[i];
    std::size_t operands = 0, yes = 0, no = 0;
    for (std::size_t k = i + 1; k < entry.end; k = entries_[k].end) {
      ++operands;
      yes += value[k] == Truth::yes ? 1 : 0;
      no += value[k] == Truth::no ? 1 : 0;
    }
    switch (entry.op) {
      case Entry::Op::leaf:
        value[i] = leaf(entry.leaf);
        break;
      case Entry::Op::unite:
        value[i] = yes > 0 ? Truth::yes : no == operands ? Truth::no : Truth::unknown;
        break;
      case Entry::Op::intersect:
        value[i] = no > 0 ? Truth::no : yes == operands ? Truth::yes : Truth::unknown;
        break;
      case Entry::Op::subtract:
        value[i] = no > 0 ? Truth::no : Truth::unknown;  // operands that are subtracted are ignored
        break;
      case Entry::Op::other:
        break;
    }
  }
}

// Gathers the leaves that may hold a place inside the solid, and marks those that certainly do. If an intersection
// holds the place, all its operands do. If a union does, those operands do that are true there.
void HolderTree::gather(Search& search) const {
  search.candidates.clear();
  enum : std::uint8_t { out, maybe, sure };
  std::uint8_t state[most_entries] = {};
  if (!entries_.empty()) state[0] = sure;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (state[i] == out) continue;
    const Entry& entry = entries_[i];
    if (entry.op == Entry::Op::leaf) search.candidates.push_back({entry.leaf.index(), state[i] == sure});
    std::size_t possible = 0;
    for (std::size_t k = i + 1; k < entry.end; k = entries_[k].end) possible += search.value[k] != Truth::no ? 1 : 0;
    for (std::size_t k = i + 1; k < entry.end; k = entries_[k].end) {
      if (search.value[k] == Truth::no) continue;
      const bool follows = entry.op != Entry::Op::unite || possible == 1 || search.value[k] == Truth::yes;
      state[k] = follows ? state[i] : std::uint8_t{maybe};
    }
  }
  std::sort(search.candidates.begin(), search.candidates.end(),
            [](const Search::Candidate& a, const Search::Candidate& b) { return a.leaf < b.leaf; });
}

HolderTree::Shown HolderTree::shown(const Scene& scene, Search& search,
                                    const std::function<Truth(LeafId)>& leaf) const {
  if (!is_small_) return {};
  evaluate(search, leaf);
  gather(search);
  LookId look;
  for (const Search::Candidate& candidate : search.candidates) {
    const LookId own = scene.leaf(LeafId(candidate.leaf)).look;
    if (look.valid() && own != look) return {};
    look = own;
    if (candidate.is_sure) return {true, look, false};
  }
  return {true, look, true};
}

}  // namespace csgcast::detail
