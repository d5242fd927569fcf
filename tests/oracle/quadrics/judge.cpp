// SPDX-License-Identifier: MIT
#include "tests/oracle/quadrics/judge.h"

#include <fmt/format.h>

#include <cmath>

namespace csgcast::oracle::quadrics {
namespace {

// Where a face belongs, but for its t.
std::string difference_of_face(const Subject& subject, const Attribution& found, const Face& face) {
  const Scene& scene = subject.scene();
  const FormulaLeaf& leaf = subject.formula().leaves()[face.leaf];
  if (found.leaf != subject.leaf_id(face.leaf)) return "leaf";
  if ((found.front == Sense::positive) != face.positive_before) return "side of the surface";
  const std::string part = found.part.valid() ? scene.parts()[found.part.index()].name.name : "";
  if (part != leaf.part) return "part";
  // A face that shows what was cut where no leaf holds the solid has no look by the definition.
  if (leaf.shows_cut && !face.holder) return {};
  const FormulaLeaf& shown = leaf.shows_cut ? subject.formula().leaves()[*face.holder] : leaf;
  return scene.look(found.look) == shown.look ? "" : "look";
}

std::string difference_of_crossing(const Subject& subject, const Crossing& found, const DefinedEnd& expected) {
  if (!expected.t) return std::isinf(found.t) && !found.surface.valid() ? "" : "an infinite end";
  if (!expected.face) {
    const bool is_cut =
        !found.surface.valid() && std::isfinite(found.t) && compare(*expected.t, Rational(found.t)) == 0;
    return is_cut ? "" : "an end that the span cuts";
  }
  if (!found.surface.valid() || found.surface != subject.surface_id(expected.face->surface)) return "surface";
  return is_nearest(found.t, *expected.t) ? "" : "t is not the nearest double";
}

std::string difference_of_end(const Subject& subject, const FoundEnd& found, const DefinedEnd& expected) {
  const std::string crossing = difference_of_crossing(subject, found.crossing, expected);
  if (!crossing.empty() || !expected.face) return crossing;
  return found.attribution ? difference_of_face(subject, *found.attribution, *expected.face) : "no attribution";
}

bool is_mirrored(const FoundEnd& a, const FoundEnd& b) {
  if (a.crossing.t != -b.crossing.t || a.crossing.surface != b.crossing.surface) return false;
  if (!a.attribution || !b.attribution) return !a.attribution && !b.attribution;
  return a.attribution->leaf == b.attribution->leaf && a.attribution->look == b.attribution->look &&
         a.attribution->front != b.attribution->front;
}

std::string to_text(const FoundEnd& end) {
  if (!end.crossing.surface.valid()) return fmt::format("{:a} -", end.crossing.t);
  return fmt::format("{:a} #{} leaf {}", end.crossing.t, end.crossing.surface.index(),
                     end.attribution ? end.attribution->leaf.index() : -1u);
}

std::string to_text(const Subject& subject, const DefinedEnd& end) {
  if (!end.t) return "infinite -";
  if (!end.face) return fmt::format("{:a} -", end.t->nearest());
  return fmt::format("{:a} #{} leaf {}", end.t->nearest(), subject.surface_id(end.face->surface).index(),
                     subject.leaf_id(end.face->leaf).index());
}

}  // namespace

FoundList found_list(Caster& caster, Span span) {
  IntervalList list;
  caster.intervals(list, span);
  FoundList found;
  const auto end = [&caster](const Crossing& crossing, Passage passage) {
    FoundEnd result{crossing, std::nullopt};
    if (crossing.surface.valid()) result.attribution = caster.attribute({crossing, passage});
    return result;
  };
  for (const Interval& interval : list) {
    found.push_back({end(interval.entry, Passage::entry), end(interval.exit, Passage::exit)});
  }
  return found;
}

std::string difference(const Subject& subject, const FoundList& found, const DefinedList& expected) {
  if (found.size() != expected.size()) return fmt::format("{} intervals, not {}", found.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::string entry = difference_of_end(subject, found[i].entry, expected[i].entry);
    if (!entry.empty()) return fmt::format("entry of interval {}: {}", i, entry);
    const std::string exit = difference_of_end(subject, found[i].exit, expected[i].exit);
    if (!exit.empty()) return fmt::format("exit of interval {}: {}", i, exit);
  }
  return {};
}

std::string difference(const Subject& subject, const std::optional<Hit>& found, const DefinedList& expected) {
  for (const DefinedInterval& interval : expected) {
    for (const Passage passage : {Passage::entry, Passage::exit}) {
      const DefinedEnd& end = passage == Passage::entry ? interval.entry : interval.exit;
      if (!end.face) continue;
      if (!found) return "no first hit";
      if (found->passage != passage) return "first hit: entry or exit";
      const std::string crossing = difference_of_crossing(subject, found->crossing, end);
      return crossing.empty() ? "" : "first hit: " + crossing;
    }
  }
  return found ? "a first hit of nothing" : "";
}

std::string difference_of_mirrored(const FoundList& forward, const FoundList& backward) {
  bool same = forward.size() == backward.size();
  for (std::size_t i = 0; same && i < forward.size(); ++i) {
    const FoundInterval& image = backward[backward.size() - 1 - i];
    same = is_mirrored(forward[i].entry, image.exit) && is_mirrored(forward[i].exit, image.entry);
  }
  return same ? "" : "the reversed ray's list is not the mirror image: " + to_text(backward);
}

std::string to_text(const FoundList& list) {
  std::string text;
  for (const FoundInterval& interval : list) {
    text += fmt::format("[{}, {}] ", to_text(interval.entry), to_text(interval.exit));
  }
  return text.empty() ? "nothing" : text;
}

std::string to_text(const Subject& subject, const DefinedList& list) {
  std::string text;
  for (const DefinedInterval& interval : list) {
    text += fmt::format("[{}, {}] ", to_text(subject, interval.entry), to_text(subject, interval.exit));
  }
  return text.empty() ? "nothing" : text;
}

}  // namespace csgcast::oracle::quadrics
