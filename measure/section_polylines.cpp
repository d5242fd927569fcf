// SPDX-License-Identifier: MIT
#include "measure/section_polylines.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "csg/base/error.h"

namespace csgcast {
namespace {

constexpr std::size_t most_points = std::size_t{1} << 24;
constexpr int most_halvings = 40;

struct PlaneVector {
  double u = 0;
  double v = 0;
};

PlaneVector operator-(PlanePoint a, PlanePoint b) { return {a.u - b.u, a.v - b.v}; }
double dot(PlaneVector a, PlaneVector b) { return a.u * b.u + a.v * b.v; }
double cross(PlaneVector a, PlaneVector b) { return a.u * b.v - a.v * b.u; }
PlaneVector turned(PlaneVector a) { return {-a.v, a.u}; }

/// The longest coordinate of an arc's points.
double longest(const SectionArc& arc) {
  double most = 0;
  for (const PlanePoint& p : {arc.from, arc.middle, arc.to})
    most = std::fmax(most, std::fmax(std::fabs(p.u), std::fabs(p.v)));
  return most;
}

/// A conic's arcs by their chords. A line meets a conic twice at most, so an arc lies on one side of its chord; the
/// point farthest from the chord, the shoulder, is where the tangent is along it.
class ArcFlattener {
 public:
  ArcFlattener(const std::array<double, 6>& conic, double tolerance, std::vector<PlanePoint>& points)
      : conic_(conic), tolerance_(tolerance), points_(points) {}

  /// Appends what is between two points of the arc, without them. `side`: any point on the arc's side of the chord.
  void add(PlanePoint from, PlanePoint to, PlanePoint side, int halvings = 0) {
    const std::optional<PlanePoint> shoulder = shoulder_of(from, to, side);
    if (!shoulder || halvings >= most_halvings || is_flat(from, to, *shoulder)) return;
    // The whole arc is on one side of either new chord, and the other end on the other side.
    add(from, *shoulder, mirrored(to, from, *shoulder), halvings + 1);
    if (points_.size() >= most_points) {
      throw Error(ErrorCode::limit, {}, "the polylines of the section have more than 16777216 points",
                  fmt::format("chords within {} of the arcs are very short", tolerance_), "give a larger tolerance");
    }
    points_.push_back(*shoulder);
    add(*shoulder, to, mirrored(from, *shoulder, to), halvings + 1);
  }

 private:
  PlaneVector gradient(PlanePoint p) const {
    return {2 * conic_[0] * p.u + conic_[1] * p.v + conic_[3], conic_[1] * p.u + 2 * conic_[2] * p.v + conic_[4]};
  }
  /// The conic's matrix times a vector, twice.
  PlaneVector curved(PlaneVector d) const {
    return {2 * conic_[0] * d.u + conic_[1] * d.v, conic_[1] * d.u + 2 * conic_[2] * d.v};
  }

  /// A point on the other side of the line through a and b.
  static PlanePoint mirrored(PlanePoint p, PlanePoint a, PlanePoint b) {
    const PlaneVector along = b - a;
    const double off = cross(along, p - a) / dot(along, along);
    const PlaneVector across = turned(along);
    return {a.u - off * across.u, a.v - off * across.v};
  }

  /// Nothing if doubles cannot tell the arc from its chord.
  std::optional<PlanePoint> shoulder_of(PlanePoint from, PlanePoint to, PlanePoint side) const {
    const PlaneVector chord = to - from;
    const PlanePoint middle{0.5 * (from.u + to.u), 0.5 * (from.v + to.v)};
    // Along the diameter through the middle: bend / 8 = slope s + curve s²; there the tangent is along the chord.
    const double bend = dot(chord, curved(chord));
    const PlaneVector diameter = turned(curved(chord));
    const double slope = dot(gradient(middle), diameter);
    const double curve = 0.5 * dot(diameter, curved(diameter));
    const double square = slope * slope + 0.5 * bend * curve;
    if (!(square >= 0)) return std::nullopt;
    const double s = -0.5 * (slope + std::copysign(std::sqrt(square), slope));
    const bool is_left = cross(chord, side - from) > 0;
    std::optional<PlanePoint> nearest;
    double least = HUGE_VAL;
    for (const double along : {s / curve, -0.125 * bend / s}) {
      const PlanePoint p{middle.u + along * diameter.u, middle.v + along * diameter.v};
      const double off = cross(chord, p - from);
      // A hyperbola's other branch has such a point too, farther away.
      if (!std::isfinite(along) || off == 0 || (off > 0) != is_left || std::fabs(off) >= least) continue;
      least = std::fabs(off);
      nearest = p;
    }
    return nearest;
  }

  /// Whether the arc is near its chord, and nowhere beyond the chord's ends.
  bool is_flat(PlanePoint from, PlanePoint to, PlanePoint shoulder) const {
    const PlaneVector chord = to - from;
    const double off = cross(chord, shoulder - from);
    if (std::fabs(off) > tolerance_ * std::sqrt(dot(chord, chord))) return false;
    // The tangents at the ends, towards the arc's side, lean inwards.
    const auto leans = [&](PlanePoint end, PlaneVector inwards) {
      const PlaneVector tangent = turned(gradient(end));
      return (cross(chord, tangent) > 0) == (off > 0) ? dot(tangent, inwards) >= 0 : dot(tangent, inwards) <= 0;
    };
    return leans(from, chord) && leans(to, {-chord.u, -chord.v});
  }

  const std::array<double, 6>& conic_;
  double tolerance_;
  std::vector<PlanePoint>& points_;
};

}  // namespace

std::vector<std::vector<PlanePoint>> section_polylines(const Section& section, double tolerance) {
  if (!(tolerance > 0) || !std::isfinite(tolerance)) {
    throw Error(ErrorCode::bad_value, {}, fmt::format("a tolerance of {}", tolerance),
                "it is how far a curve may be from its chords", "give a length above 0");
  }
  require_bounded(section);
  std::vector<std::vector<PlanePoint>> lines;
  for (const SectionLoop& loop : section.loops) {
    std::vector<PlanePoint>& points = lines.emplace_back();
    for (const SectionArc& arc : loop) {
      points.push_back(arc.from);
      if (arc.is_straight()) continue;
      // An arc may go nearly round: halves of it have chords that tell their sides.
      ArcFlattener flattener(arc.conic, std::fmax(tolerance, 0x1p-50 * longest(arc)), points);
      const auto beyond = [](PlanePoint p, PlanePoint a, PlanePoint b) {
        return PlanePoint{a.u + b.u - p.u, a.v + b.v - p.v};
      };
      flattener.add(arc.from, arc.middle, beyond(arc.to, arc.from, arc.middle));
      points.push_back(arc.middle);
      flattener.add(arc.middle, arc.to, beyond(arc.from, arc.middle, arc.to));
    }
    const PlanePoint first = points.front(), last = loop.back().to;
    const bool is_closed = std::hypot(last.u - first.u, last.v - first.v) <= 2 * section.place_error;
    points.push_back(is_closed ? first : last);
  }
  return lines;
}

}  // namespace csgcast
