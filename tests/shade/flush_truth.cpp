// SPDX-License-Identifier: MIT
#include "tests/shade/flush_truth.h"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace csgcast::test {
namespace {

constexpr int side = 6;
constexpr double bore_radius = 0.17;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Numbers of 500 bits with what the template below needs.
struct Long {
  mpf_class value{0, 500};
  Long(double v = 0) : value(v, 500) {}  // NOLINT(google-explicit-constructor)
  explicit Long(const mpf_class& v) : value(v, 500) {}
  explicit operator double() const { return value.get_d(); }
  friend Long operator+(const Long& a, const Long& b) { return Long(mpf_class(a.value + b.value)); }
  friend Long operator-(const Long& a, const Long& b) { return Long(mpf_class(a.value - b.value)); }
  friend Long operator*(const Long& a, const Long& b) { return Long(mpf_class(a.value * b.value)); }
  friend Long operator/(const Long& a, const Long& b) { return Long(mpf_class(a.value / b.value)); }
  friend bool operator<(const Long& a, const Long& b) { return a.value < b.value; }
  friend bool operator==(const Long& a, const Long& b) { return a.value == b.value; }
};
Long square_root(const Long& a) { return Long(mpf_class(::sqrt(a.value))); }
long double square_root(long double a) { return std::sqrt(a); }

template <class Real>
using Place = std::array<Real, 3>;

// Where leaves stand in the file.
std::size_t brick(int i, int j) { return static_cast<std::size_t>(side * i + j); }
std::size_t slot(int i) { return static_cast<std::size_t>(side * side + i); }
std::size_t bore(int i, int j) { return static_cast<std::size_t>(side * side + side) + brick(i, j); }
constexpr std::size_t ground = 2 * side * side + side;

// The column or row of bricks that a coordinate is in.
template <class Real>
int cell(const Real& x) {
  return std::clamp(static_cast<int>(std::floor(static_cast<double>(x))), 0, side - 1);
}

template <class Real>
bool in_bore(const Place<Real>& p) {
  const Real x = p[0] - Real(cell(p[0]) + 0.5), y = p[1] - Real(cell(p[1]) + 0.5);
  return x * x + y * y < Real(bore_radius) * Real(bore_radius);
}

template <class Real>
bool in_slot(const Place<Real>& p) {
  const Real x = p[0] - Real(cell(p[0]));
  return Real(0.25) < x && x < Real(0.75) && Real(0.5) < p[2];
}

template <class Real>
bool in_solid(const Place<Real>& p) {
  if (p[2] < Real(0)) return true;
  const bool in_slab = Real(0) < p[0] && p[0] < Real(side) && Real(0) < p[1] && p[1] < Real(side) && p[2] < Real(1);
  return in_slab && !in_slot(p) && !in_bore(p);
}

template <class Real>
struct Line {
  Place<Real> origin, direction;
  Place<Real> at(const Real& t) const {
    return {origin[0] + t * direction[0], origin[1] + t * direction[1], origin[2] + t * direction[2]};
  }
};

template <class Real>
void add_plane(const Line<Real>& line, std::size_t axis, double place, std::vector<Real>& crossings) {
  if (line.direction[axis] == Real(0)) return;
  crossings.push_back((Real(place) - line.origin[axis]) / line.direction[axis]);
}

template <class Real>
void add_bore(const Line<Real>& line, int i, int j, std::vector<Real>& crossings) {
  const Real x = line.origin[0] - Real(i + 0.5), y = line.origin[1] - Real(j + 0.5);
  const Real &dx = line.direction[0], &dy = line.direction[1];
  const Real a = dx * dx + dy * dy, b = x * dx + y * dy;
  // The squared distance of the line is (x dy - y dx)² / a: no cancellation but that of the distance itself.
  const Real w = x * dy - y * dx;
  const Real discriminant = a * Real(bore_radius) * Real(bore_radius) - w * w;
  if (!(Real(0) < discriminant)) return;
  const Real root = square_root(discriminant);
  crossings.push_back((Real(0) - b - root) / a);
  crossings.push_back((root - b) / a);
}

template <class Real>
std::vector<Real> sorted_crossings(const Line<Real>& line) {
  std::vector<Real> crossings;
  for (int i = 0; i < side; ++i) {
    for (const double x : {i + 0.25, i + 0.75}) add_plane(line, 0, x, crossings);
    for (int j = 0; j < side; ++j) add_bore(line, i, j, crossings);
  }
  for (const double end : {0.0, double(side)}) {
    add_plane(line, 0, end, crossings);
    add_plane(line, 1, end, crossings);
  }
  for (const double z : {0.0, 0.5, 1.0}) add_plane(line, 2, z, crossings);
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

// The leaves whose faces a boundary point of the solid is on, to within 1e-9.
std::vector<std::size_t> leaves_at(const Place<double>& p) {
  constexpr double near = 1e-9;
  const auto is = [&](double a, double b) { return std::fabs(a - b) <= near; };
  std::vector<std::size_t> leaves;
  for (const double dx : {-near, near}) {
    for (const double dy : {-near, near}) {
      const int i = cell(p[0] + dx), j = cell(p[1] + dy);
      const double x = p[0] - i, y = p[1] - j;
      const bool on_end = is(p[0], 0) || is(p[0], side) || is(p[1], 0) || is(p[1], side);
      if (on_end || is(p[2], 1)) leaves.push_back(brick(i, j));
      if (is(x, 0.25) || is(x, 0.75) || is(p[2], 0.5)) leaves.push_back(slot(i));
      if (is(std::hypot(x - 0.5, y - 0.5), bore_radius)) leaves.push_back(bore(i, j));
    }
  }
  if (is(p[2], 0)) leaves.push_back(ground);
  return leaves;
}

template <class Real>
FlushEnd end_at(const Line<Real>& line, const Real& t) {
  const Place<Real> p = line.at(t);
  return {static_cast<double>(t),
          leaves_at({static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])})};
}

// None if two crossings are closer than `closest`, but for equal ones if that is 0.
template <class Real>
std::optional<std::vector<FlushEnd>> truth(const Ray& ray, double closest) {
  const Point o = ray.origin();
  const Vector d = ray.direction();
  const Line<Real> line{{Real(o.x), Real(o.y), Real(o.z)}, {Real(d.x), Real(d.y), Real(d.z)}};
  const std::vector<Real> crossings = sorted_crossings(line);
  std::vector<FlushEnd> ends;
  bool inside = false;
  const auto pass = [&](const Real& midway, const FlushEnd& end) {
    const bool now = in_solid(line.at(midway));
    if (now != inside) ends.push_back(end);
    inside = now;
  };
  if (crossings.empty()) return ends;
  pass(crossings.front() - Real(1), {-infinity, {}});
  for (std::size_t k = 0; k < crossings.size(); ++k) {
    if (k + 1 == crossings.size()) {
      pass(crossings[k] + Real(1), end_at(line, crossings[k]));
      break;
    }
    const Real width = crossings[k + 1] - crossings[k];
    if (static_cast<double>(width) <= closest && (closest > 0 || width == Real(0))) {
      if (closest > 0) return std::nullopt;
      continue;
    }
    pass(crossings[k] + Real(0.5) * width, end_at(line, crossings[k]));
  }
  if (inside) ends.push_back({infinity, {}});
  return ends;
}

}  // namespace

std::vector<FlushEnd> flush_truth(const Ray& ray) {
  if (const auto ends = truth<long double>(ray, 1e-9)) return *ends;
  return *truth<Long>(ray, 0);
}

}  // namespace csgcast::test
