// SPDX-License-Identifier: MIT
#include "measure/search/farthest.h"

#include <array>

#include "measure/sheet/tetrahedron.h"

namespace csgcast::detail {
namespace {

class Finder {
 public:
  Finder(std::span<const LinearForm> forms, std::span<const double> off, Vector direction, double least)
      : forms_(forms), off_(off), direction_(direction) {
    best_.reach = least;
  }

  void add(const Tetrahedron& t, std::size_t next, const TruthTable& table) {
    if (table.is_never()) return;
    const auto reach = [&](std::size_t i) { return dot(direction_, t[i]); };
    std::size_t farthest = 0;
    for (std::size_t i = 1; i < 4; ++i) {
      if (reach(i) > reach(farthest)) farthest = i;
    }
    if (!(reach(farthest) > best_.reach)) return;
    if (table.is_always()) {
      best_ = {reach(farthest), t[farthest], 0.25 * (t[0] + t[1] + t[2] + t[3])};
      found_ = true;
      return;
    }
    while (!table.depends_on(next)) ++next;
    // If the form is nearly zero, either sign is possible.
    std::array<double, 4> lower{};
    std::array<double, 4> upper{};
    for (std::size_t i = 0; i < 4; ++i) {
      const double at = forms_[next].at(t[i]);
      lower[i] = at - off_[next];
      upper[i] = at + off_[next];
    }
    const auto nothing = [](const auto&) {};
    cut(
        t, lower, [&](const Tetrahedron& part) { add(part, next + 1, table.with(next, false)); }, nothing, nothing);
    cut(
        t, upper, nothing, [&](const Tetrahedron& part) { add(part, next + 1, table.with(next, true)); }, nothing);
  }

  std::optional<Corner> best() const { return found_ ? std::optional(best_) : std::nullopt; }

 private:
  std::span<const LinearForm> forms_;
  std::span<const double> off_;
  Vector direction_;
  Corner best_;
  bool found_ = false;
};

}  // namespace

std::optional<Corner> farthest_corner(std::span<const LinearForm> forms, std::span<const double> off,
                                      const TruthTable& table, Vector half, Vector direction, double least) {
  Finder finder(forms, off, direction, least);
  for (const Tetrahedron& t : tetrahedra_of_box(half)) finder.add(t, 0, table);
  return finder.best();
}

}  // namespace csgcast::detail
