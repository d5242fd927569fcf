// SPDX-License-Identifier: MIT
#include "tests/oracle/quadrics/definition.h"

#include <algorithm>
#include <cmath>

#include "tests/oracle/quadrics/face_rules.h"

namespace csgcast::oracle::quadrics {
namespace {

using State = Formula::State;

constexpr std::size_t most_choices = 16;  // as a power of two

struct Event {
  Root t;
  std::size_t surface;
};

struct LineStart {
  State state;                // towards t = -infinity
  std::vector<Event> events;  // ascending in t, ties by the product's id
};

// The sign of a polynomial before all its roots; one that vanishes everywhere counts as positive.
bool is_positive_before(const LinePolynomial& polynomial) {
  if (sign_of(polynomial.square) != 0) return sign_of(polynomial.square) > 0;
  if (sign_of(polynomial.slope) != 0) return sign_of(polynomial.slope) < 0;
  return sign_of(polynomial.value) >= 0;
}

State state_of(const Formula& formula, const std::vector<bool>& positive) {
  State state;
  for (const Copy& copy : formula.copies()) state.push_back(positive[copy.surface] == copy.positive);
  return state;
}

// Signs and crossings of every surface along a line.
struct Course {
  std::vector<bool> positive;
  std::vector<Event> events;
};

Course course_of(const Formula& formula, const Ray& ray) {
  const RationalLine line{exact(ray.origin()), exact(ray.direction())};
  Course course;
  for (std::size_t i = 0; i < formula.surfaces().size(); ++i) {
    const LinePolynomial polynomial = formula.surfaces()[i].along(line);
    course.positive.push_back(is_positive_before(polynomial));
    for (Root& root : Root::sign_changes(polynomial)) course.events.push_back({std::move(root), i});
  }
  return course;
}

LineStart start_of_line(const Subject& subject, Course course) {
  LineStart start{state_of(subject.formula(), course.positive), std::move(course.events)};
  std::sort(start.events.begin(), start.events.end(), [&subject](const Event& a, const Event& b) {
    const int order = compare(a.t, b.t);
    return order != 0 ? order < 0 : subject.surface_id(a.surface) < subject.surface_id(b.surface);
  });
  return start;
}

DefinedEnd cut(double t) { return std::isfinite(t) ? DefinedEnd{Root(Rational(t)), std::nullopt} : DefinedEnd{}; }

LineAnswer follow(const Subject& subject, Course course) {
  const Formula& formula = subject.formula();
  auto [state, events] = start_of_line(subject, std::move(course));
  LineAnswer answer;
  bool is_inside = formula.value(state);
  DefinedEnd entry;
  for (auto next = events.begin(); next != events.end();) {
    const Root t = next->t;
    std::vector<std::size_t> group;
    State after = state;
    for (; next != events.end() && compare(next->t, t) == 0; ++next) {
      group.push_back(next->surface);
      after = formula.flipped(std::move(after), next->surface);
    }
    answer.ties += group.size() > 1 ? 1 : 0;
    if (formula.value(after) != is_inside) {
      const DefinedEnd end{t, face_at(subject, state, group)};
      if (is_inside) answer.list.push_back({entry, end});
      entry = end;
      is_inside = !is_inside;
    }
    state = std::move(after);
  }
  if (is_inside) answer.list.push_back({entry, {}});
  return answer;
}

}  // namespace

LineAnswer answer_on_line(const Subject& subject, const Ray& ray) {
  return follow(subject, course_of(subject.formula(), ray));
}

// The departed surface is t (square t + slope): away from the start it changes its sign at -slope / square.
DepartingAnswer answer_on_departing_ray(const Subject& subject, const Ray& ray, std::size_t surface,
                                        bool given_positive) {
  const LinePolynomial polynomial =
      subject.formula().surfaces()[surface].along({exact(ray.origin()), exact(ray.direction())});
  const int at_start = sign_of(polynomial.slope);
  const int in_the_end = sign_of(polynomial.square);
  const int after = at_start != 0 ? at_start : in_the_end;
  const bool positive_after = after != 0 ? after > 0 : given_positive;
  Course course = course_of(subject.formula(), ray);
  std::erase_if(course.events, [surface](const Event& event) { return event.surface == surface; });
  course.positive[surface] = positive_after;
  if (at_start * in_the_end < 0) course.events.push_back({Root(-polynomial.slope / polynomial.square), surface});
  return {clipped(follow(subject, std::move(course)).list, Span{}), positive_after, in_the_end == 0};
}

DefinedList clipped(const DefinedList& line, Span span) {
  const DefinedEnd from = cut(span.from);
  const DefinedEnd to = cut(span.to);
  DefinedList list;
  for (DefinedInterval interval : line) {
    if (from.t && interval.exit.t && compare(*interval.exit.t, *from.t) <= 0) continue;
    if (to.t && interval.entry.t && compare(*interval.entry.t, *to.t) >= 0) continue;
    if (from.t && (!interval.entry.t || compare(*interval.entry.t, *from.t) < 0)) interval.entry = from;
    if (to.t && (!interval.exit.t || compare(*interval.exit.t, *to.t) > 0)) interval.exit = to;
    list.push_back(interval);
  }
  return list;
}

PointAnswer answer_at_point(const Subject& subject, Point p) {
  const Formula& formula = subject.formula();
  const RationalPoint place = exact(p);
  std::vector<bool> positive;
  std::vector<std::size_t> zeros;
  for (std::size_t i = 0; i < formula.surfaces().size(); ++i) {
    const int sign = sign_of(formula.surfaces()[i].at(place));
    positive.push_back(sign > 0);
    if (sign == 0) zeros.push_back(i);
  }
  PointAnswer answer;
  answer.zeros = zeros.size();
  if (zeros.size() > most_choices) return answer;
  State state = state_of(formula, positive);
  const bool first = formula.value(state);
  answer.location = first ? Location::inside : Location::outside;
  for (std::uint32_t choice = 1; choice < (1u << zeros.size()); ++choice) {
    // Gray code: one flip leads to the next choice.
    state = formula.flipped(std::move(state), zeros[static_cast<std::size_t>(__builtin_ctz(choice))]);
    if (formula.value(state) == first) continue;
    answer.location = Location::boundary;
    break;
  }
  return answer;
}

}  // namespace csgcast::oracle::quadrics
