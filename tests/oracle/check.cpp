// SPDX-License-Identifier: MIT
#include "tests/oracle/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "raycast/ray/caster.h"
#include "tests/oracle/exact_answer.h"
#include "tests/oracle/nearest.h"
#include "tests/oracle/queries.h"
#include "tests/support/effort.h"

namespace csgcast::oracle {
namespace {

constexpr std::uint64_t points_a_model = 500;
constexpr std::uint64_t rays_a_model = 50;

template <class Tag>
std::string text(const Triple<Tag>& v) {
  return fmt::format("({:a}, {:a}, {:a})", v.x, v.y, v.z);
}

std::string text(const Crossing& end) {
  return end.surface.valid() ? fmt::format("{:a} #{}", end.t, end.surface.index()) : fmt::format("{:a} -", end.t);
}

std::string text(const ExactEnd& end) {
  if (!end.t) return "infinite -";
  const std::string t = fmt::format("{:a}", approximate(*end.t));
  if (!end.surface) return t + " -";
  return end.surface->valid() ? fmt::format("{} #{}", t, end.surface->index()) : t + " #missing";
}

template <class List>
std::string text_of_list(const List& list) {
  std::string result;
  for (const auto& interval : list) result += fmt::format("[{}, {}] ", text(interval.entry), text(interval.exit));
  return result.empty() ? "nothing" : result;
}

// Whether t is the nearest double to a fraction.
bool is_nearest_to(double t, const Rational& exact) {
  return is_nearest(t, [&exact](const Rational& number) { return sign_of(Rational(exact - number)); });
}

std::string_view name(Location location) {
  constexpr std::string_view names[] = {"inside", "outside", "boundary"};
  return names[static_cast<std::size_t>(location)];
}

// One model under test.
class Examination {
 public:
  Examination(const Subject& subject, std::string title, Tally& tally)
      : subject_(subject), title_(std::move(title)), tally_(tally), caster_(subject.scene()) {}
  ~Examination() { tally_.exact_calls += caster_.counts().exact_calls; }
  Examination(const Examination&) = delete;
  Examination& operator=(const Examination&) = delete;

  void examine_point(Point p) {
    ++tally_.points;
    const Location expected = exact_location(subject_, p);
    ++tally_.located[static_cast<std::size_t>(expected)];
    if (const auto by_mesh = location_by_meshes(subject_, p)) {
      ++tally_.mesh_verdicts;
      if (*by_mesh != expected)
        complain(fmt::format("oracles differ at {}: mesh {}, planes {}", text(p), name(*by_mesh), name(expected)));
    }
    const Location found = caster_.locate(p);
    if (found != expected) complain(fmt::format("locate {}: {} in place of {}", text(p), name(found), name(expected)));
  }

  void examine_ray(const Ray& ray, test::RandomSolids& random) {
    ++tally_.rays;
    caster_.begin(ray);
    const ExactList line = exact_intervals(subject_, ray);
    examine_span(ray, line, {});
    examine_span(ray, line, Span::line());
    if (line.empty() || random.index(2) == 0) return;
    // Spans that begin, and spans that end, near or exactly at an end of the line's list.
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const ExactInterval& interval = line[random.index(line.size())];
    for (const ExactEnd& end : {interval.entry, interval.exit}) {
      const double t = end.t ? approximate(*end.t) : infinity;
      if (!std::isfinite(t)) continue;
      examine_span(ray, line, {t, infinity});
      examine_span(ray, line, {-infinity, t});
    }
  }

 private:
  void examine_span(const Ray& ray, const ExactList& line, Span span) {
    const ExactList expected = clipped(line, span);
    tally_.intervals += expected.size();
    caster_.intervals(list_, span);
    const auto fail = [&](std::string_view what) {
      complain(fmt::format("{}: ray {} + t {}, t in [{:a}, {:a}]: found {}, expected {}", what, text(ray.origin()),
                           text(ray.direction()), span.from, span.to, text_of_list(list_), text_of_list(expected)));
    };
    bool same = list_.size() == expected.size();
    for (std::size_t i = 0; same && i < expected.size(); ++i) {
      same = agree(list_[i].entry, expected[i].entry) && agree(list_[i].exit, expected[i].exit);
    }
    if (!same) fail("intervals");
    if (!agrees_with_first_hit(span, expected)) fail("first_hit");
    if (caster_.any_hit(span) != !expected.empty()) fail("any_hit");
  }

  bool agrees_with_first_hit(Span span, const ExactList& expected) {
    const std::optional<Hit> hit = caster_.first_hit(span);
    for (const ExactInterval& interval : expected) {
      for (const Passage passage : {Passage::entry, Passage::exit}) {
        const ExactEnd& end = passage == Passage::entry ? interval.entry : interval.exit;
        if (end.surface) return hit && hit->passage == passage && agree(hit->crossing, end);
      }
    }
    return !hit;
  }

  // The same surface, and the nearest double.
  bool agree(const Crossing& found, const ExactEnd& expected) {
    if (!expected.t) return std::isinf(found.t) && !found.surface.valid();
    if (!expected.surface) return !found.surface.valid() && std::isfinite(found.t) && Rational(found.t) == *expected.t;
    if (!found.surface.valid() || found.surface != *expected.surface) return false;
    ++tally_.ends;
    return is_nearest_to(found.t, *expected.t);
  }

  void complain(const std::string& text) { tally_.complain(title_ + ": " + text); }

  const Subject& subject_;
  std::string title_;
  Tally& tally_;
  Caster caster_;
  IntervalList list_;
};

}  // namespace

void Tally::complain(std::string text) {
  ++wrong;
  if (complaints.size() < 5) complaints.push_back(std::move(text));
}

Workload workload() { return test::long_run() ? Workload{1'000'000, 100'000} : Workload{30'000, 3'000}; }

Tally check_family(const ModelMaker& make, std::uint64_t seed, Workload work) {
  Tally tally;
  while (tally.points < work.points || tally.rays < work.rays) {
    // Each model from its own seed, so that one that fails can be made again by itself.
    test::RandomSolids random(seed + tally.models);
    const std::string title = fmt::format("seed {}", seed + tally.models);
    ++tally.models;
    const Subject subject(make(random));
    if (const std::string complaint = subject.complaint(); !complaint.empty()) tally.complain(title + ": " + complaint);
    Examination examination(subject, title, tally);
    Queries queries(subject.model().operands, random);
    for (std::uint64_t i = 0; i < points_a_model && tally.points < work.points; ++i)
      examination.examine_point(queries.point());
    for (std::uint64_t i = 0; i < rays_a_model && tally.rays < work.rays; ++i)
      examination.examine_ray(queries.ray(), random);
  }
  return tally;
}

std::string summary(const std::string& family, const Tally& tally) {
  return fmt::format(
      "{:34} {:5} models {:8} points ({} in, {} out, {} on; {} by mesh) {:7} rays {:7} intervals {:7} ends; exact "
      "{}; wrong {}",
      family, tally.models, tally.points, tally.located[0], tally.located[1], tally.located[2], tally.mesh_verdicts,
      tally.rays, tally.intervals, tally.ends, tally.exact_calls, tally.wrong);
}

}  // namespace csgcast::oracle
