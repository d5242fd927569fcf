// SPDX-License-Identifier: MIT
#include "shade/film/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "csg/base/length.h"

namespace csgcast::detail {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// In front of a perspective eye is what is at least this share of its distance along the view: 89 degrees off it.
constexpr double least_depth = 0.02;

}  // namespace

Outline::Outline(const CameraFrame& camera, const Box& box) {
  is_everywhere_ = !box.is_finite() && !box.is_null();
  if (is_everywhere_ || box.is_null()) return;
  std::vector<Place> places;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Point p;
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[axis] = ((corner >> axis) & 1u) != 0 ? box.upper[axis] : box.lower[axis];
    const Vector v = p - camera.eye;
    const double depth = camera.parallel ? 1 : dot(v, camera.forward);
    if (!camera.parallel && !(depth > least_depth * length(v))) is_everywhere_ = true;
    const double scale = depth * camera.pixel;
    places.push_back({camera.width / 2 + dot(v, camera.right) / scale, camera.height / 2 - dot(v, camera.up) / scale});
    if (!std::isfinite(places.back().x) || !std::isfinite(places.back().y)) is_everywhere_ = true;
  }
  if (is_everywhere_) return;
  // The lower and the upper chain of the hull, from left to right and back. Source: Andrew 1979.
  std::sort(places.begin(), places.end(), [](Place a, Place b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t start = corners_.size();
    for (const Place& p : places) {
      while (corners_.size() >= start + 2) {
        const Place& a = corners_[corners_.size() - 2];
        const Place& b = corners_.back();
        if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0) break;
        corners_.pop_back();
      }
      corners_.push_back(p);
    }
    corners_.pop_back();
    std::reverse(places.begin(), places.end());
  }
}

Outline::Columns Outline::columns(double y0, double y1) const {
  if (is_everywhere_) return {-infinity, infinity};
  const double low = y0 - 1;
  const double high = y1 + 1;
  Columns found{infinity, -infinity};
  const auto take = [&](double x) {
    found.first = std::min(found.first, x);
    found.last = std::max(found.last, x);
  };
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Place a = corners_[i];
    const Place b = corners_[(i + 1) % corners_.size()];
    if (a.y >= low && a.y <= high) take(a.x);
    for (const double y : {low, high}) {
      if ((a.y < y) != (b.y < y)) take(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
  }
  return {found.first - 1, found.last + 1};
}

}  // namespace csgcast::detail
