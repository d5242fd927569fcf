// SPDX-License-Identifier: MIT
#include "csg/solid/simplify.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "csg/base/tree_walk.h"
#include "csg/solid/detail/growing_solid.h"

namespace csgcast {
namespace {

using Kind = Solid::Kind;
using detail::GrowingSolid;

// Counts how often each node occurs as a child. A shared node is simplified once. It is never spliced into its parents,
// because that would undo the sharing.
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

class Simplifier {
 public:
  explicit Simplifier(const Solid& root) : root_(root), parents_(count_parents(root)) {}

  Solid run() {
    TreeWalk<const Solid, Level> walk;
    Level whole = walk.run(
        {&root_, 1}, Level{}, [this](const Solid& solid, Level& above) { return enter(solid, above); },
        [](const Solid& solid) { return solid.children(); },
        [this](const Solid& solid, Level level, Level& above) { above.add(leave(solid, std::move(level.value))); });
    return std::move(whole.value).finished();
  }

 private:
  static bool is_boolean(Kind kind) { return kind == Kind::unite || kind == Kind::intersect || kind == Kind::subtract; }

  struct Level {
    const Solid* boolean = nullptr;  // the node, if it is a Boolean operator
    std::size_t children = 0;        // of it, so far
    GrowingSolid value{};            // for a Boolean operator it grows child by child; for another node it is the child

    void add(GrowingSolid child) {
      if (boolean != nullptr) {
        value.append(*boolean, children++, std::move(child));
      } else {
        value = std::move(child);
      }
    }
  };

  std::optional<Level> enter(const Solid& solid, Level& above) {
    const auto known = shared_.find(solid.identity());
    if (known != shared_.end()) {
      above.add(known->second);
    } else if (solid.children().empty()) {
      above.add(GrowingSolid(solid, false));
    } else {
      return Level{is_boolean(solid.kind()) ? &solid : nullptr};
    }
    return std::nullopt;
  }

  GrowingSolid leave(const Solid& solid, GrowingSolid result) {
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

  // A node with one child, over its simplified child.
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
};

}  // namespace

Solid simplified(const Solid& solid) { return Simplifier(solid).run(); }

}  // namespace csgcast
