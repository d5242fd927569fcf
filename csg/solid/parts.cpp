// SPDX-License-Identifier: MIT
#include "csg/solid/parts.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace csgcast {
namespace {

using Kind = Solid::Kind;

// Whether parts below such a node are parts of the whole.
bool hands_on_parts(Kind kind) { return kind == Kind::unite || kind == Kind::transform || kind == Kind::look; }

// A walk from the leaves up with a stack of its own; a shared node is walked once.
class Selection {
 public:
  explicit Selection(std::span<const std::string> names) : names_(names.begin(), names.end()) {}

  Solid run(const Solid& root) {
    visit(root);
    while (!frames_.empty()) {
      Frame& top = frames_.back();
      if (top.next_child < top.solid->children().size()) {
        visit(top.solid->children()[top.next_child++]);
      } else {
        const Frame done = std::move(top);
        frames_.pop_back();
        hand_up(shared_.insert_or_assign(done.solid->identity(), rebuilt(done)).first->second);
      }
    }
    return result_;
  }

 private:
  struct Frame {
    const Solid* solid = nullptr;
    std::size_t next_child = 0;
    std::vector<Solid> kept;  // children that are not empty
  };

  void visit(const Solid& solid) {
    const auto known = shared_.find(solid.identity());
    if (known != shared_.end()) {
      hand_up(known->second);
    } else if (hands_on_parts(solid.kind())) {
      frames_.emplace_back().solid = &solid;
    } else if (solid.kind() == Kind::part && names_.contains(solid.part().name)) {
      hand_up(solid);
    }
  }

  void hand_up(const Solid& solid) {
    if (frames_.empty()) {
      result_ = solid;
    } else if (solid.kind() != Kind::empty) {
      frames_.back().kept.push_back(solid);
    }
  }

  static Solid rebuilt(const Frame& frame) {
    const Solid& solid = *frame.solid;
    if (frame.kept.empty()) return {};
    switch (solid.kind()) {
      case Kind::transform:
        return transformed(frame.kept.front(), solid.transform()).at(solid.place());
      case Kind::look:
        return with_look(frame.kept.front(), solid.look()).at(solid.place());
      default:
        return frame.kept.size() == 1 ? frame.kept.front() : unite(frame.kept).at(solid.place());
    }
  }

  std::unordered_set<std::string> names_;
  std::unordered_map<const void*, Solid> shared_;
  std::vector<Frame> frames_;
  Solid result_;
};

}  // namespace

std::vector<std::string> part_names(const Solid& solid) {
  std::vector<std::string> names;
  std::unordered_set<std::string> known;
  std::unordered_set<const void*> seen;
  std::vector<const Solid*> open{&solid};
  while (!open.empty()) {
    const Solid& top = *open.back();
    open.pop_back();
    if (!seen.insert(top.identity()).second) continue;
    if (top.kind() == Kind::part && known.insert(top.part().name).second) names.push_back(top.part().name);
    if (!hands_on_parts(top.kind())) continue;
    for (std::size_t i = top.children().size(); i > 0; --i) open.push_back(&top.children()[i - 1]);
  }
  return names;
}

const std::string* unknown_part(std::span<const std::string> known, std::span<const std::string> names) {
  const auto at = std::ranges::find_if(
      names, [&](const std::string& name) { return std::ranges::find(known, name) == known.end(); });
  return at != names.end() ? &*at : nullptr;
}

Solid only_parts(const Solid& solid, std::span<const std::string> names) { return Selection(names).run(solid); }

}  // namespace csgcast
