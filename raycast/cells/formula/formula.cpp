// SPDX-License-Identifier: MIT
#include "raycast/cells/formula/formula.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "raycast/cells/formula/leaf_terms.h"

namespace csgcast::detail {
namespace {

// Lays out a scene's tree, node by node.
class Layout {
 public:
  Layout(const Scene& scene, Formula& formula) : scene_(scene), formula_(formula) {}

  /// Makes nodes empty that do not meet a box. The box must outlive this.
  Layout& near(const Box& box) {
    near_ = &box;
    return *this;
  }
  /// Makes a node empty, or everything.
  Layout& with(NodeId node, bool as_everything) {
    replaced_ = node;
    as_everything_ = as_everything;
    return *this;
  }

  /// Lays out the tree below a node, behind the terms that exist. Returns false if there are more terms than
  /// `most_terms` then. In that case it stopped early, and the formula is no longer valid.
  bool run(NodeId root, std::size_t most_terms = SIZE_MAX) {
    visit(root);
    while (!open_.empty()) {
      if (formula_.terms.size() > most_terms) {
        formula_.terms.resize(1);
        return false;
      }
      Open& last = open_.back();
      if (last.next < last.children.size()) {
        visit(last.children[last.next++]);
        continue;
      }
      Term& term = formula_.terms[last.start];
      term.size = static_cast<std::uint32_t>(formula_.terms.size()) - last.start;
      open_.pop_back();
    }
    return true;
  }

 private:
  struct Open {
    std::span<const NodeId> children;
    std::size_t next;
    std::uint32_t start;
  };

  static Term::Op op_of(Node::Op op) {
    switch (op) {
      case Node::Op::intersect:
        return Term::Op::intersect;
      case Node::Op::subtract:
        return Term::Op::subtract;
      case Node::Op::complement:
        return Term::Op::complement;
      default:
        return Term::Op::unite;
    }
  }

  void visit(NodeId id) {
    const Node& node = scene_.node(id);
    if (id == replaced_) return add_constant(as_everything_);
    if (near_ != nullptr && csgcast::intersection(node.box, *near_).is_null()) return add_constant(false);
    if (node.op == Node::Op::leaf) return append_leaf(scene_, LeafId(node.first), formula_.terms);
    if (node.op == Node::Op::empty || node.op == Node::Op::everything)
      return add_constant(node.op == Node::Op::everything);
    const auto start = static_cast<std::uint32_t>(formula_.terms.size());
    formula_.terms.push_back({1, 0, op_of(node.op)});
    open_.push_back({scene_.children(node), 0, start});
  }

  // Adds an operator without operands: an empty union is nothing, an empty intersection is everything.
  void add_constant(bool value) { formula_.terms.push_back({1, 0, value ? Term::Op::intersect : Term::Op::unite}); }

  const Scene& scene_;
  Formula& formula_;
  const Box* near_ = nullptr;
  NodeId replaced_;
  bool as_everything_ = false;
  std::vector<Open> open_;
};

// Adds an operand. A constant becomes an operator without operands.
void append(Formula& whole, const Formula& operand) {
  if (!operand.is_constant()) {
    whole.terms.insert(whole.terms.end(), operand.terms.begin(), operand.terms.end());
  } else {
    whole.terms.push_back({1, 0, operand.value ? Term::Op::intersect : Term::Op::unite});
  }
}

// Folds an operator over the operands that `add` lays out.
template <class Add>
Formula joined(Term::Op op, Add&& add) {
  Formula whole;
  whole.terms.push_back({1, 0, op});
  add(whole);
  whole.terms.front().size = static_cast<std::uint32_t>(whole.terms.size());
  Formula folded;
  Folder().fold(
      whole, folded, [](const Term&) { return Truth::unknown; }, [](const Term&) { return Truth::unknown; });
  return folded;
}

Formula difference(const Formula& from, const Formula& less) {
  return joined(Term::Op::subtract, [&](Formula& whole) {
    append(whole, from);
    append(whole, less);
  });
}

}  // namespace

Formula formula_of(const Scene& scene, NodeId node) { return formula_of_difference(scene, node, {}); }

Formula formula_of_difference(const Scene& scene, NodeId node, std::span<const NodeId> less) {
  return joined(Term::Op::subtract, [&](Formula& whole) {
    Layout layout(scene, whole);
    layout.run(node);
    for (const NodeId other : less) layout.run(other);
  });
}

Formula formula_of_common(const Scene& scene, NodeId a, NodeId b) {
  return joined(Term::Op::intersect, [&](Formula& whole) {
    Layout layout(scene, whole);
    layout.run(a);
    layout.run(b);
  });
}

std::optional<Formula> formula_of_effect(const Scene& scene, NodeId root, NodeId node, bool as_everything,
                                         const Box& near, std::size_t most_terms) {
  bool is_short = true;
  const auto tree = [&](NodeId of, NodeId replaced) {
    return joined(Term::Op::unite, [&](Formula& whole) {
      is_short = Layout(scene, whole).near(near).with(replaced, as_everything).run(of, most_terms) && is_short;
    });
  };
  const Formula with = tree(root, NodeId());
  if (!is_short) return std::nullopt;
  const Formula without = tree(root, node);
  const Formula own = tree(node, NodeId());
  if (!is_short) return std::nullopt;
  // The value differs where one of the two trees holds and the other does not. That is inside the node, or outside of
  // it if the node becomes everything.
  return joined(Term::Op::intersect, [&](Formula& whole) {
    append(whole, as_everything ? joined(Term::Op::complement, [&](Formula& outside) { append(outside, own); }) : own);
    append(whole, joined(Term::Op::unite, [&](Formula& either) {
             append(either, difference(with, without));
             append(either, difference(without, with));
           }));
  });
}

void Folder::begin(const Formula& from, Formula& result) {
  result_ = &result;
  result.terms.clear();
  result.value = from.value;
  open_.clear();
  at_ = 0;
  done_ = false;
}

void Folder::open(const Term& term) {
  const auto start = static_cast<std::uint32_t>(result_->terms.size());
  const bool associates = term.op == Term::Op::unite || term.op == Term::Op::intersect;
  const bool is_merged = associates && !open_.empty() && open_.back().op == term.op;
  if (!is_merged) result_->terms.push_back(term);
  open_.push_back({static_cast<std::uint32_t>(at_) + term.size, start, 0, 0, term.op, is_merged});
  ++at_;
}

void Folder::deliver(Truth value, std::span<const Term> operand) {
  if (value != Truth::unknown) return settle(value == Truth::yes);
  result_->terms.insert(result_->terms.end(), operand.begin(), operand.end());
  keep();
}

// Keeps an operand of the operator on top.
void Folder::keep() {
  if (open_.empty()) return;
  ++open_.back().kept;
  ++open_.back().seen;
}

// Treats an operand of the operator on top as a constant. This may make the operator, and those above it, constant.
void Folder::settle(bool value) {
  while (!open_.empty()) {
    Operator& top = open_.back();
    bool absorbs = true;
    switch (top.op) {
      case Term::Op::unite:
        absorbs = value;
        break;
      case Term::Op::complement:
        value = !value;
        break;
      case Term::Op::subtract:
        absorbs = (top.seen == 0) != value;
        if (!absorbs && top.seen == 0) {
          top.op = Term::Op::complement;  // the operator is everything less the second operand now
          result_->terms[top.start].op = Term::Op::complement;
        }
        if (absorbs) value = false;
        break;
      default:
        absorbs = !value;
    }
    if (!absorbs) {
      ++top.seen;
      return;
    }
    result_->terms.resize(top.start);
    at_ = top.end;
    open_.pop_back();
  }
  result_->value = value;
  done_ = true;
}

void Folder::close_finished() {
  while (!open_.empty() && open_.back().end == at_) {
    const Operator top = open_.back();
    open_.pop_back();
    close(top);
    if (done_) return;
  }
}

void Folder::close(const Operator& top) {
  if (top.is_merged) {
    open_.back().kept += top.kept;
    ++open_.back().seen;
    return;
  }
  std::vector<Term>& terms = result_->terms;
  if (top.kept == 0) {
    terms.resize(top.start);
    return settle(top.op != Term::Op::unite);
  }
  const bool is_plain = top.kept == 1 && top.op != Term::Op::leaf && top.op != Term::Op::complement;
  if (is_plain) {
    // The only operand that is left replaces the operator.
    terms.erase(terms.begin() + top.start);
  } else {
    terms[top.start].size = static_cast<std::uint32_t>(terms.size()) - top.start;
  }
  keep();
}

}  // namespace csgcast::detail
