// SPDX-License-Identifier: MIT
#include "verify/comparison.h"

#include <fmt/format.h>

#include <algorithm>

#include "csg/base/add_members.h"

namespace csgcast::verify {
namespace {

// This limits the memory, and is enough to fill any packet.
constexpr std::size_t rays_at_once = 16;

bool same(const Crossing& a, const Crossing& b) { return a.surface == b.surface && a.t == b.t; }

bool same(const std::optional<Hit>& a, const std::optional<Hit>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->passage == b->passage && same(a->crossing, b->crossing);
}

std::string to_text(const Crossing& c) {
  return c.surface.valid() ? fmt::format("t = {} on surface {}", c.t, c.surface.index())
                           : fmt::format("t = {} on no surface", c.t);
}

std::string to_text(const std::optional<Hit>& hit) {
  if (!hit) return "none";
  return (hit->passage == Passage::entry ? "entry at " : "exit at ") + to_text(hit->crossing);
}

/// Empty if the lists are the same.
std::string difference(const IntervalList& found, const IntervalList& expected) {
  if (found.size() != expected.size()) return fmt::format("{} intervals, not {}", found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto tell = [i](const char* end, const Crossing& a, const Crossing& b) {
      return fmt::format("interval {}: {} at {}, not {}", i, end, to_text(a), to_text(b));
    };
    if (!same(found[i].entry, expected[i].entry)) return tell("entry", found[i].entry, expected[i].entry);
    if (!same(found[i].exit, expected[i].exit)) return tell("exit", found[i].exit, expected[i].exit);
  }
  return {};
}

std::string difference(Question question, const Answers& found, const Answers& expected) {
  switch (question) {
    case Question::any_hit:
      if (found.any_hit == expected.any_hit) return {};
      return found.any_hit ? "a hit, where there is none" : "no hit, where there is one";
    case Question::first_hit:
      if (same(found.first_hit, expected.first_hit)) return {};
      return to_text(found.first_hit) + ", not " + to_text(expected.first_hit);
    case Question::ray:
      return difference(found.ray, expected.ray);
    case Question::line:
      return difference(found.line, expected.line);
    case Question::reversed:
      return difference(found.reversed, expected.reversed);
  }
  return {};
}

Crossing mirrored(const Crossing& c) { return {-c.t, c.surface, c.root}; }

/// Makes the list that the reversed ray must see.
void mirror(const IntervalList& list, IntervalList& result) {
  result.clear();
  for (auto i = list.rbegin(); i != list.rend(); ++i) result.push_back({mirrored(i->exit), mirrored(i->entry)});
}

/// The first crossing that a list over [0, infinity) keeps.
std::optional<Hit> first_of(const IntervalList& list) {
  if (list.empty()) return std::nullopt;
  if (list.front().entry.surface.valid()) return Hit{list.front().entry, Passage::entry};
  if (list.front().exit.surface.valid()) return Hit{list.front().exit, Passage::exit};
  return std::nullopt;
}

}  // namespace

Tally& Tally::operator+=(const Tally& other) {
  return add_members<&Tally::rays, &Tally::intervals, &Tally::flagged, &Tally::exact_decisions, &Tally::wrong>(*this,
                                                                                                               other);
}

std::string_view name(Question question) {
  switch (question) {
    case Question::any_hit:
      return "any hit";
    case Question::first_hit:
      return "first hit";
    case Question::ray:
      return "ray";
    case Question::line:
      return "whole line";
    case Question::reversed:
      return "reversed line";
  }
  return {};
}

std::string interval_options(const Mismatch& mismatch) {
  const bool reversed = mismatch.question == Question::reversed;
  const Point o = mismatch.ray.origin();
  Vector d = mismatch.ray.direction();
  if (reversed) d = Vector{} - d;  // the subtraction avoids negative zeros
  const bool whole_line = reversed || mismatch.question == Question::line;
  return fmt::format("{}--ray={},{},{},{},{},{}", whole_line ? "--line " : "", o.x, o.y, o.z, d.x, d.y, d.z);
}

Comparison::Comparison(const Scene& scene, std::span<const EngineKind> kinds)
    : subject_(scene), exact_(scene, exact_predicates()), answers_(kinds.size(), std::vector<Answers>(rays_at_once)) {
  for (const EngineKind& kind : kinds) {
    names_.push_back(kind.name);
    engines_.push_back(kind.make(subject_));
  }
}

void Comparison::compare(std::span<const Ray> rays, std::span<Tally> tallies, std::vector<Mismatch>& mismatches,
                         std::size_t most) {
  while (!rays.empty()) {
    const std::span<const Ray> packet = rays.first(std::min(rays.size(), rays_at_once));
    rays = rays.subspan(packet.size());
    for (std::size_t e = 0; e < engines_.size(); ++e)
      engines_[e]->answer(packet, std::span(answers_[e]).first(packet.size()));
    for (std::size_t i = 0; i < packet.size(); ++i) {
      ask_exact(packet[i]);
      for (std::size_t e = 0; e < engines_.size(); ++e)
        judge(e, packet[i], answers_[e][i], tallies[e], mismatches, most);
    }
  }
}

void Comparison::judge(std::size_t engine, const Ray& ray, const Answers& found, Tally& tally,
                       std::vector<Mismatch>& mismatches, std::size_t most) const {
  ++tally.rays;
  tally.intervals += expected_.line.size();
  tally.flagged += found.flagged ? 1 : 0;
  tally.exact_decisions += found.exact_decisions;
  for (const Question question :
       {Question::line, Question::ray, Question::reversed, Question::first_hit, Question::any_hit}) {
    std::string text = difference(question, found, expected_);
    if (text.empty()) continue;
    ++tally.wrong;
    if (mismatches.size() < most) mismatches.push_back({ray, names_[engine], question, std::move(text)});
    return;
  }
}

void Comparison::ask_exact(const Ray& ray) {
  exact_.begin(ray);
  exact_.intervals(expected_.ray);
  exact_.intervals(expected_.line, Span::line());
  mirror(expected_.line, expected_.reversed);
  expected_.first_hit = first_of(expected_.ray);
  expected_.any_hit = !expected_.ray.empty();
}

}  // namespace csgcast::verify
