// SPDX-License-Identifier: MIT
#include "csg/solid/parts.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "csg/base/tree_walk.h"

namespace csgcast {
namespace {

using Kind = Solid::Kind;

// True if parts below such a node are parts of the whole.
bool hands_on_parts(Kind kind) { return kind == Kind::unite || kind == Kind::transform || kind == Kind::look; }

// Finds what is left of each node, from the leaves up. A shared node is walked once.
class Selection {
 public:
  explicit Selection(std::span<const std::string> names) : names_(names.begin(), names.end()) {}

  Solid run(const Solid& root) {
    TreeWalk<const Solid, Kept> walk;
    const Kept whole = walk.run(
        {&root, 1}, Kept{}, [this](const Solid& solid, Kept& above) { return enter(solid, above); },
        [](const Solid& solid) { return solid.children(); },
        [this](const Solid& solid, Kept kept, Kept& above) {
          keep(shared_.insert_or_assign(solid.identity(), rebuilt(solid, std::move(kept))).first->second, above);
        });
    return whole.empty() ? Solid() : whole.front();
  }

 private:
  using Kept = std::vector<Solid>;  // children that are not empty

  std::optional<Kept> enter(const Solid& solid, Kept& above) const {
    const auto known = shared_.find(solid.identity());
    if (known != shared_.end()) {
      keep(known->second, above);
    } else if (hands_on_parts(solid.kind())) {
      return Kept{};
    } else if (solid.kind() == Kind::part && names_.contains(solid.part().name)) {
      keep(solid, above);
    }
    return std::nullopt;
  }

  static void keep(const Solid& solid, Kept& above) {
    if (solid.kind() != Kind::empty) above.push_back(solid);
  }

  static Solid rebuilt(const Solid& solid, Kept kept) {
    if (kept.empty()) return {};
    switch (solid.kind()) {
      case Kind::transform:
        return transformed(kept.front(), solid.transform()).at(solid.place());
      case Kind::look:
        return with_look(kept.front(), solid.look()).at(solid.place());
      default:
        return kept.size() == 1 ? kept.front() : unite(std::move(kept)).at(solid.place());
    }
  }

  std::unordered_set<std::string> names_;
  std::unordered_map<const void*, Solid> shared_;
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
