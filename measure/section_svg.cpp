// SPDX-License-Identifier: MIT
#include "measure/section_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "csg/base/number_text.h"

namespace csgcast {
namespace {

constexpr double pi = std::numbers::pi;

struct Ellipse {
  PlanePoint center;
  double along = 0;  ///< half axes
  double across = 0;
  double turn = 0;  ///< direction of the first axis, in radians anticlockwise

  /// The angle of a point in the ellipse's own circle.
  double angle(PlanePoint p) const {
    const double x = p.u - center.u, y = p.v - center.v;
    const double c = std::cos(turn), s = std::sin(turn);
    return std::atan2((c * y - s * x) / across, (c * x + s * y) / along);
  }
  PlanePoint at(double angle) const {
    const double x = along * std::cos(angle), y = across * std::sin(angle);
    return {center.u + std::cos(turn) * x - std::sin(turn) * y, center.v + std::sin(turn) * x + std::cos(turn) * y};
  }
};

/// Returns nothing for another conic, or for one so much larger than its arc that its numbers mean little.
std::optional<Ellipse> ellipse_of(const SectionArc& arc) {
  const auto& [a, b, c, d, e, f] = arc.conic;
  const double det = 4 * a * c - b * b;
  if (!(det > 0x1p-40 * (a * a + b * b + c * c))) return std::nullopt;
  Ellipse ellipse;
  ellipse.center = {(b * e - 2 * c * d) / det, (b * d - 2 * a * e) / det};
  const double value = 0.5 * (d * ellipse.center.u + e * ellipse.center.v) + f;
  const double mean = 0.5 * (a + c);
  const double half = std::hypot(0.5 * (a - c), 0.5 * b);
  const double first = mean + (mean > 0 ? half : -half);  // the eigenvalue of greater magnitude
  const double second = 0.25 * det / first;
  ellipse.along = std::sqrt(-value / second);
  ellipse.across = std::sqrt(-value / first);
  // The longer axis belongs to the smaller eigenvalue.
  ellipse.turn = half > 0x1p-50 * std::fabs(mean) ? 0.5 * std::atan2(b, a - c) + (mean > 0 ? 0.5 * pi : 0) : 0;
  const double size = std::hypot(arc.to.u - arc.from.u, arc.to.v - arc.from.v) +
                      std::hypot(arc.middle.u - arc.from.u, arc.middle.v - arc.from.v);
  const bool is_sound = std::isfinite(ellipse.along) && ellipse.across > 0 && ellipse.along < 1e6 * size;
  return is_sound ? std::optional(ellipse) : std::nullopt;
}

class PathWriter {
 public:
  explicit PathWriter(double tolerance) : tolerance_(tolerance) {}

  void add(const SectionLoop& loop) {
    append('M', loop.front().from);
    reach(loop.front().from);
    for (const SectionArc& arc : loop) add(arc);
    text_ += "Z\n";
  }

  const std::string& text() const { return text_; }
  bool has_bounds() const { return least_.u <= greatest_.u; }
  PlanePoint least() const { return least_; }
  PlanePoint greatest() const { return greatest_; }

 private:
  void add(const SectionArc& arc) {
    reach(arc.to);
    if (arc.is_straight()) {
      append('L', arc.to);
    } else if (const std::optional<Ellipse> ellipse = ellipse_of(arc)) {
      add(arc, *ellipse);
    } else {
      add_bezier(arc.conic, arc.from, arc.middle, 0);
      add_bezier(arc.conic, arc.middle, arc.to, 0);
    }
  }

  void add(const SectionArc& arc, const Ellipse& ellipse) {
    const double from = ellipse.angle(arc.from);
    const auto way = [&](PlanePoint p) {  // the angle from the start, anticlockwise, in [0, 2 pi)
      const double angle = ellipse.angle(p) - from;
      return angle < 0 ? angle + 2 * pi : angle;
    };
    const bool is_anticlockwise = way(arc.middle) < way(arc.to);
    const double angle = is_anticlockwise ? way(arc.to) : 2 * pi - way(arc.to);
    for (int i = 1; i < 32; ++i) reach(ellipse.at(from + (is_anticlockwise ? 1 : -1) * angle * i / 32));
    // In pictures down is positive, so sweep 0 is anticlockwise.
    text_ += fmt::format("A{} {} {} {} {} {}", number(ellipse.along), number(ellipse.across),
                         number(-ellipse.turn * 180 / pi), angle > pi ? 1 : 0, is_anticlockwise ? 0 : 1, place(arc.to));
  }

  /// Between two points of a conic this draws the parabola with the same tangents there. It is halved until it is close
  /// enough.
  void add_bezier(const std::array<double, 6>& k, PlanePoint p, PlanePoint q, int depth) {
    const auto gradient = [&](PlanePoint at) {
      return PlanePoint{2 * k[0] * at.u + k[1] * at.v + k[3], k[1] * at.u + 2 * k[2] * at.v + k[4]};
    };
    const PlanePoint gp = gradient(p), gq = gradient(q);
    const double det = gp.u * gq.v - gp.v * gq.u;
    const double cp = gp.u * p.u + gp.v * p.v, cq = gq.u * q.u + gq.v * q.v;
    const PlanePoint corner{(cp * gq.v - cq * gp.v) / det, (gp.u * cq - gq.u * cp) / det};
    const PlanePoint middle{0.5 * (p.u + q.u), 0.5 * (p.v + q.v)};
    const std::optional<PlanePoint> shoulder = crossing(k, middle, corner);
    if (!shoulder) {
      append('L', q);  // the run is as straight as doubles can tell
      return;
    }
    reach(*shoulder);
    const double off = std::hypot(shoulder->u - 0.5 * (middle.u + corner.u), shoulder->v - 0.5 * (middle.v + corner.v));
    if (off > 0.5 * tolerance_ && depth < 24) {
      add_bezier(k, p, *shoulder, depth + 1);
      add_bezier(k, *shoulder, q, depth + 1);
    } else {
      text_ += fmt::format("Q{} {}", place(corner), place(q));
    }
  }

  /// The place where the conic crosses the straight way between two points.
  static std::optional<PlanePoint> crossing(const std::array<double, 6>& k, PlanePoint from, PlanePoint to) {
    const double du = to.u - from.u, dv = to.v - from.v;
    const double a = (k[0] * du + k[1] * dv) * du + k[2] * dv * dv;
    const double b = (2 * k[0] * from.u + k[1] * from.v + k[3]) * du + (k[1] * from.u + 2 * k[2] * from.v + k[4]) * dv;
    const double c = (k[0] * from.u + k[1] * from.v + k[3]) * from.u + (k[2] * from.v + k[4]) * from.v + k[5];
    const double d = b * b - 4 * a * c;
    if (!(d >= 0)) return std::nullopt;
    const double s = -0.5 * (b + std::copysign(std::sqrt(d), b));
    for (const double t : {c / s, s / a}) {
      if (t > 0 && t < 1) return PlanePoint{from.u + t * du, from.v + t * dv};
    }
    return std::nullopt;
  }

  void append(char command, PlanePoint p) { text_ += fmt::format("{}{}", command, place(p)); }

  static std::string place(PlanePoint p) { return fmt::format("{} {}", number(p.u), number(-p.v)); }

  void reach(PlanePoint p) {
    least_ = {std::fmin(least_.u, p.u), std::fmin(least_.v, p.v)};
    greatest_ = {std::fmax(greatest_.u, p.u), std::fmax(greatest_.v, p.v)};
  }

  double tolerance_;
  std::string text_;
  PlanePoint least_{HUGE_VAL, HUGE_VAL};
  PlanePoint greatest_{-HUGE_VAL, -HUGE_VAL};
};

}  // namespace

double unseen_tolerance(const Section& section) { return 1e-6 * std::sqrt(section.area.value) + section.place_error; }

PlaneRectangle seen_rectangle(const Section& section) {
  require_bounded(section);
  PathWriter path(1);
  for (const SectionLoop& loop : section.loops) path.add(loop);
  if (!path.has_bounds()) return {{0, 0}, {1, 1}};
  const auto [least, greatest] = std::pair(path.least(), path.greatest());
  const double margin = 0.02 * std::fmax(greatest.u - least.u, greatest.v - least.v);
  return {{least.u - margin, least.v - margin}, {greatest.u + margin, greatest.v + margin}};
}

std::string section_svg(const Section& section, double tolerance) {
  require_bounded(section);
  PathWriter path(tolerance);
  for (const SectionLoop& loop : section.loops) path.add(loop);
  const auto [least, greatest] = seen_rectangle(section);
  const double width = greatest.u - least.u;
  const double height = greatest.v - least.v;
  const double pixels = 800 / std::fmax(width, height);
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  out += fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" viewBox=\"{} {} {} {}\">\n",
      std::fmax(width * pixels, 1), std::fmax(height * pixels, 1), number(least.u), number(-greatest.v), number(width),
      number(height));
  out += fmt::format("<desc>Area {} within {}, perimeter {} within {}. Curves are within {} of the section.</desc>\n",
                     number(section.area.value), number(section.area.error), number(section.perimeter.value),
                     number(section.perimeter.error), number(section.place_error + tolerance));
  out +=
      "<path fill=\"#9fb8d0\" fill-rule=\"evenodd\" stroke=\"#1b2733\" stroke-width=\"1.5\" "
      "vector-effect=\"non-scaling-stroke\" stroke-linejoin=\"round\" d=\"\n";
  out += path.text();
  return out + "\"/>\n</svg>\n";
}

}  // namespace csgcast
