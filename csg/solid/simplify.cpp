// SPDX-License-Identifier: MIT
#include "csg/solid/simplify.h"

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "csg/solid/detail/growing_solid.h"

namespace csgcast {
namespace {

using Kind = Solid::Kind;
using detail::GrowingSolid;

// How often each node occurs as a child: a shared node is simplified once, and never spliced into its parents, which
// would undo the sharing.
std::unordered_map<const void*, std::uint32_t> count_parents(const Solid& root) {
  std::unordered_map<const void*, std::uint32_t> parents;
  std::vector<const Solid*> open{&root};
  parents[root.identity()] = 1;
  while (!open.empty()) {
    const Solid& solid = *open.back();
    open.pop_back();
    for (const Solid& child : solid.children()) {
      if (++parents[child.identity()] == 1 && !child.children().empty()) open.push_back(&child);
    }
  }
  return parents;
}

// A walk from the leaves up with a stack of its own.
class Simplifier {
 public:
  explicit Simplifier(const Solid& root) : root_(root), parents_(count_parents(root)) {}

  Solid run() {
    enter(root_);
    for (;;) {
      Frame& top = frames_.back();
      if (top.next_child < top.solid->children().size()) {
        visit(top.solid->children()[top.next_child++]);
        continue;
      }
      GrowingSolid result = leave();
      if (frames_.empty()) return std::move(result).finished();
      receive(std::move(result));
    }
  }

 private:
  struct Frame {
    const Solid* solid = nullptr;
    std::size_t next_child = 0;
    GrowingSolid value;  // of a Boolean operator: grows child by child; of another node: the child
  };

  static bool is_boolean(Kind kind) { return kind == Kind::unite || kind == Kind::intersect || kind == Kind::subtract; }

  void enter(const Solid& solid) {
    Frame& frame = frames_.emplace_back();
    frame.solid = &solid;
    if (solid.children().empty()) frame.value = GrowingSolid(solid, false);
  }

  void visit(const Solid& child) {
    const auto known = shared_.find(child.identity());
    if (known != shared_.end()) {
      receive(known->second);
    } else if (child.children().empty()) {
      receive(GrowingSolid(child, false));
    } else {
      enter(child);
    }
  }

  void receive(GrowingSolid child) {
    Frame& parent = frames_.back();
    if (is_boolean(parent.solid->kind())) {
      parent.value.append(*parent.solid, parent.next_child - 1, std::move(child));
    } else {
      parent.value = std::move(child);
    }
  }

  GrowingSolid leave() {
    Frame frame = std::move(frames_.back());
    frames_.pop_back();
    const Solid& solid = *frame.solid;
    GrowingSolid result = std::move(frame.value);
    if (is_boolean(solid.kind())) {
      result.close(solid);
    } else {
      result = rebuilt(solid, std::move(result));
    }
    if (parents_[solid.identity()] == 1) return result;
    const bool has_part = result.has_part();
    result = GrowingSolid(std::move(result).finished(), has_part);
    shared_.emplace(solid.identity(), result);
    return result;
  }

  // A node with one child, or none, over its simplified child.
  static GrowingSolid rebuilt(const Solid& solid, GrowingSolid child) {
    switch (solid.kind()) {
      case Kind::complement:
        return std::move(child).complemented(solid);
      case Kind::part:
        return rewrapped(solid, std::move(child), true);
      case Kind::look:
        return child.is(Kind::empty) ? child : rewrapped(solid, std::move(child), child.has_part());
      case Kind::transform: {
        const bool unmoved = child.is(Kind::empty) || child.is(Kind::everything) || solid.transform().is_identity();
        return unmoved ? child : rewrapped(solid, std::move(child), child.has_part());
      }
      default:
        return child;
    }
  }

  static GrowingSolid rewrapped(const Solid& solid, GrowingSolid child, bool has_part) {
    Solid inner = std::move(child).finished();
    if (inner.identity() == solid.children()[0].identity()) return {solid, has_part};
    switch (solid.kind()) {
      case Kind::part:
        return {named(std::move(inner), solid.part()).at(solid.place()), has_part};
      case Kind::look:
        return {with_look(std::move(inner), solid.look()).at(solid.place()), has_part};
      default:
        return {transformed(std::move(inner), solid.transform()).at(solid.place()), has_part};
    }
  }

  const Solid& root_;
  std::unordered_map<const void*, std::uint32_t> parents_;
  std::unordered_map<const void*, GrowingSolid> shared_;
  std::vector<Frame> frames_;
};

}  // namespace

Solid simplified(const Solid& solid) { return Simplifier(solid).run(); }

}  // namespace csgcast
