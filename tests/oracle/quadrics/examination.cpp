// SPDX-License-Identifier: MIT
#include "tests/oracle/quadrics/examination.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string_view>

#include "csg/base/length.h"
#include "raycast/ray/caster.h"
#include "tests/oracle/quadrics/judge.h"
#include "tests/support/effort.h"

namespace csgcast::oracle::quadrics {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr int rays_a_trial = 25;
// The product may answer `boundary` where more surfaces than this vanish: 2^12 choices are past its budget.
constexpr std::size_t most_zeros = 11;

template <class Tag>
std::string text(const Triple<Tag>& v) {
  return fmt::format("({:a}, {:a}, {:a})", v.x, v.y, v.z);
}

std::string_view name(Location location) {
  constexpr std::string_view names[] = {"inside", "outside", "boundary"};
  return names[static_cast<std::size_t>(location)];
}

// One solid under test.
class Examination {
 public:
  Examination(const Solid& solid, std::string title, test::RandomSolids& random, Tally& tally)
      : subject_(solid), title_(std::move(title)), random_(random), tally_(tally), caster_(subject_.scene()) {
    ++tally_.solids;
    complain_of(subject_.complaint());
  }

  void examine(const Ray& ray) {
    ++tally_.rays;
    const std::string solid_title = title_;
    title_ += fmt::format(": ray {} + t {}", text(ray.origin()), text(ray.direction()));
    try {
      examine_queries(ray);
    } catch (const Error& error) {
      complain_of(error.what());
    }
    title_ = solid_title;
  }

 private:
  void examine_queries(const Ray& ray) {
    caster_.begin(ray);
    const LineAnswer answer = answer_on_line(subject_, ray);
    tally_.ties += answer.ties;
    examine_span({}, answer.list);
    examine_span(Span::line(), answer.list);
    if (!answer.list.empty()) examine_spans_at_end(answer.list);
    const FoundList forward = found_list(caster_, Span::line());
    count_ends(answer.list);
    examine_point(some_point(ray, answer.list));
    if (!answer.list.empty()) examine_departure(ray, answer.list);
    caster_.begin(Ray(ray.origin(), -ray.direction()));
    complain_of(difference_of_mirrored(forward, found_list(caster_, Span::line())));
  }

  void examine_span(Span span, const DefinedList& line) { examine_list(span, clipped(line, span)); }

  void examine_list(Span span, const DefinedList& expected) {
    const FoundList found = found_list(caster_, span);
    ++tally_.lists;
    tally_.intervals += expected.size();
    std::string complaint = difference(subject_, found, expected);
    if (complaint.empty()) complaint = difference(subject_, caster_.first_hit(span), expected);
    if (complaint.empty() && caster_.any_hit(span) != !expected.empty()) complaint = "any_hit";
    if (complaint.empty()) return;
    complain_of(fmt::format("t in [{:a}, {:a}]: {}: found {}, expected {}", span.from, span.to, complaint,
                            to_text(found), to_text(subject_, expected)));
  }

  // At the double nearest to an end of the line's list, or one beside it.
  void examine_spans_at_end(const DefinedList& line) {
    const DefinedInterval& interval = line[random_.index(line.size())];
    for (const DefinedEnd& end : {interval.entry, interval.exit}) {
      double t = end.t ? end.t->nearest() : inf;
      if (!std::isfinite(t)) continue;
      const std::size_t kind = random_.index(4);
      if (kind == 0) t = std::nextafter(t, -inf);
      if (kind == 1) t = std::nextafter(t, inf);
      if (!std::isfinite(t)) continue;
      examine_span({t, inf}, line);
      examine_span({-inf, t}, line);
    }
  }

  // The start, an end's rounded place, or one a few ulps off along one axis.
  Point some_point(const Ray& ray, const DefinedList& line) {
    const std::size_t kind = random_.index(3);
    if (kind == 0 || line.empty()) return ray.origin();
    const DefinedInterval& interval = line[random_.index(line.size())];
    const DefinedEnd& end = interval.entry.t ? interval.entry : interval.exit;
    const Point p = end.t ? ray.at(end.t->nearest()) : ray.origin();
    if (!is_finite(p)) return ray.origin();
    if (kind == 1) return p;
    Point moved = p;
    const std::size_t axis = random_.index(3);
    moved[axis] = std::nextafter(p[axis], random_.index(2) == 0 ? -inf : inf);
    return is_finite(moved) ? moved : p;
  }

  void examine_point(Point p) {
    const PointAnswer expected = answer_at_point(subject_, p);
    ++tally_.points;
    tally_.on_surfaces += expected.zeros > 0 ? 1 : 0;
    const Location found = caster_.locate(p);
    const bool may_give_up = expected.zeros > most_zeros && found == Location::boundary;
    if (!expected.location || found == *expected.location || may_give_up) return;
    complain_of(fmt::format("locate {}: {}, not {}", text(p), name(found), name(*expected.location)));
  }

  // On from an end, back from it, or anywhere, as shadows and reflections go.
  void examine_departure(const Ray& ray, const DefinedList& line) {
    const DefinedInterval& interval = line[random_.index(line.size())];
    const DefinedEnd& end = interval.entry.face ? interval.entry : interval.exit;
    if (!end.face) return;
    const Point start = ray.at(end.t->nearest());
    const Vector d = ray.direction();
    const Vector directions[] = {d, -d, length(d) * random_.direction()};
    const Vector direction = directions[random_.index(3)];
    if (!is_finite(start) || !is_finite(direction) || !Ray::in_range(start, direction)) return;
    // From afar the rounded place is far off the surface, as the scene goes: no departure from it.
    if (length(ray.origin() - Point{}) > 0x1p10 * length(start - Point{})) return;
    const Ray departing(start, direction);
    const std::size_t surface = end.face->surface;
    const bool given_positive = random_.index(2) == 0;
    const DepartingAnswer expected = answer_on_departing_ray(subject_, departing, surface, given_positive);
    const bool positive = expected.is_linear ? given_positive : expected.positive_after;
    const Departure departure{subject_.surface_id(surface), positive ? Sense::positive : Sense::negative};
    ++tally_.departures;
    const std::string ray_title = title_;
    title_ += fmt::format(": departs from #{} at {} + t {}, {}", departure.surface.index(), text(start),
                          text(direction), positive ? "positive" : "negative");
    caster_.begin(departing, departure);
    examine_list({}, expected.list);
    title_ = ray_title;
  }

  void count_ends(const DefinedList& list) {
    for (const DefinedInterval& interval : list) {
      for (const DefinedEnd* end : {&interval.entry, &interval.exit}) {
        if (!end->face) continue;
        ++tally_.ends;
        tally_.surface_walks += end->face->surface_by_walk ? 1 : 0;
        tally_.leaf_walks += end->face->leaf_by_walk ? 1 : 0;
      }
    }
  }

  void complain_of(const std::string& complaint) {
    if (!complaint.empty()) tally_.complain(title_ + ": " + complaint);
  }

  Subject subject_;
  std::string title_;
  test::RandomSolids& random_;
  Tally& tally_;
  Caster caster_;
};

}  // namespace

void Tally::complain(std::string text) {
  ++wrong;
  if (complaints.size() < 5) complaints.push_back(std::move(text));
}

std::uint64_t rays_a_family() { return test::long_run() ? 20'000 : 400; }

Tally check_family(const stress::Family& family, std::uint64_t rays) {
  Tally tally;
  for (std::uint64_t seed = 1; tally.rays < rays; ++seed) {
    test::RandomSolids random(seed);
    const stress::Trial trial = family.make(random, rays_a_trial);
    Examination examination(trial.solid, fmt::format("{}, seed {}", family.name, seed), random, tally);
    for (const Ray& ray : trial.rays) {
      if (tally.rays < rays) examination.examine(ray);
    }
  }
  return tally;
}

std::string summary(const std::string& family, const Tally& tally) {
  return fmt::format(
      "{:40} {:5} solids {:6} rays {:7} lists {:7} intervals {:7} ends ({} + {} by walks) {:6} ties {:6} departures "
      "{:6} points ({} on surfaces); wrong {}",
      family, tally.solids, tally.rays, tally.lists, tally.intervals, tally.ends, tally.surface_walks, tally.leaf_walks,
      tally.ties, tally.departures, tally.points, tally.on_surfaces, tally.wrong);
}

}  // namespace csgcast::oracle::quadrics
