// SPDX-License-Identifier: MIT
// Whether a unit of length is special to speed: first hits and lists of 128 x 128 parallel rays across each scene and
// across the same scene at other scales, in turn, eleven times; the median rate at scale 1, and the medians of the
// other rates over it. "1 again" is the same scene compiled once more: the noise. Then how many rays need exact
// arithmetic if the scene's bounded solids, shrunk to a size of 1/100, stand on a slab of 2,000,000 and on a
// half-space. Usage: bench_units SCENE.csg ..
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "csg/base/length.h"
#include "csg/solid/primitives.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "raycast/ray/caster.h"
#include "tests/bench/rays_across.h"

namespace csgcast::bench {
namespace {

constexpr int side = 128;
constexpr std::size_t passes = 11;

struct Scale {
  const char* name;
  double factor;
};
constexpr std::array scales{Scale{"1", 1},     Scale{"1 again", 1}, Scale{"1e-3", 1e-3},
                            Scale{"1e3", 1e3}, Scale{"1e6", 1e6},   Scale{"2^60", 0x1p60}};

Solid scaled(const Solid& solid, double factor) { return transformed(solid, scaling({factor, factor, factor})); }

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// One scene at one scale, with its rays.
struct Subject {
  Subject(const Solid& solid, const std::vector<Ray>& rays_at_1, double factor)
      : scene(compile(scaled(solid, factor), Welding::derived())), caster(scene) {
    for (const Ray& ray : rays_at_1) {
      const Point o = ray.origin();
      rays.emplace_back(Point{factor * o.x, factor * o.y, factor * o.z}, ray.direction());
    }
  }

  /// Rays per second of processor time, in millions: what else the machine does counts less.
  template <class Query>
  double rate(const Query& query) {
    const std::clock_t start = std::clock();
    for (const Ray& ray : rays) {
      caster.begin(ray);
      query(caster);
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return 1e-6 * static_cast<double>(rays.size()) / seconds;
  }

  double share_flagged() const {
    const CasterCounts counts = caster.counts();
    return static_cast<double>(counts.rays_flagged) / static_cast<double>(counts.rays);
  }

  Scene scene;
  Caster caster;
  std::vector<Ray> rays;
};

/// The median rate at scale 1, then the median ratios of the others to it.
template <class Query>
void print_rates(std::deque<Subject>& subjects, const Query& query) {
  std::vector<double> at_1;
  std::vector<std::vector<double>> ratios(subjects.size());
  for (Subject& subject : subjects) subject.rate(query);
  for (std::size_t pass = 0; pass < passes; ++pass) {
    std::vector<double> rates;
    for (Subject& subject : subjects) rates.push_back(subject.rate(query));
    at_1.push_back(rates[0]);
    for (std::size_t k = 1; k < rates.size(); ++k) ratios[k].push_back(rates[k] / rates[0]);
  }
  fmt::print(" {:8.3f}", median(at_1));
  for (std::size_t k = 1; k < subjects.size(); ++k) fmt::print(" {:8.3f}", median(ratios[k]));
}

void report_scales(const std::string& name, const Solid& solid) {
  const Scene scene = compile(solid);
  const std::vector<Ray> rays = rays_across(scene.bounded_leaves(), normalised({-0.61, 0.37, -0.29}), side);
  std::deque<Subject> subjects;
  for (const Scale& scale : scales) subjects.emplace_back(solid, rays, scale.factor);
  fmt::print("{:12} first hit", name);
  print_rates(subjects, [](Caster& caster) { caster.first_hit({}, Rounding::close); });
  fmt::print("\n{:12} lists    ", "");
  IntervalList list;
  print_rates(subjects, [&list](Caster& caster) { caster.intervals(list); });
  fmt::print("\n{:12} flagged  ", "");
  for (const Subject& subject : subjects) fmt::print(" {:8.1e}", subject.share_flagged());
  fmt::print("\n");
}

/// What is bounded of a solid, its longest side 1/100, standing on the plane z = 0; none if nothing is.
std::optional<Solid> small_part(const Solid& solid) {
  std::vector<Solid> bounded;
  if (solid.kind() == Solid::Kind::unite) {
    for (const Solid& child : solid.children())
      if (bounds(child).is_finite()) bounded.push_back(child);
  } else if (bounds(solid).is_finite()) {
    bounded.push_back(solid);
  }
  if (bounded.empty()) return std::nullopt;
  const Solid part = unite(bounded);
  const Box box = bounds(part);
  const Vector size = box.size();
  // What already stands there to within the rounding of its box stays: its face is exactly in the plane.
  const double down = std::fabs(box.lower.z) < 1e-9 * size.z ? 0 : box.lower.z;
  return scaled(transformed(part, translation({-box.center().x, -box.center().y, -down})),
                1e-2 / std::max({size.x, size.y, size.z}));
}

/// A camera's rays: from `eye`, side x side through a square as wide as twice the part that stands at the origin.
std::vector<Ray> rays_from(Point eye, int count) {
  const Point target{0, 0, 0.005};
  const Vector forward = target - eye;
  const Vector right = normalised(cross(forward, {0, 0, 1}));
  const Vector up = normalised(cross(right, forward));
  std::vector<Ray> rays;
  for (int row = 0; row < count; ++row) {
    for (int column = 0; column < count; ++column) {
      const auto at = [&](int pixel) { return 0.02 * ((pixel + 0.5) / count - 0.5); };
      rays.emplace_back(eye, normalised(forward + at(column) * right + at(row) * up));
    }
  }
  return rays;
}

void report_on_ground(const std::string& name, const Solid& solid) {
  const std::optional<Solid> part = small_part(solid);
  if (!part) return;
  const std::array grounds{std::pair{"slab", transformed(box({2e6, 2e6, 1}), translation({-1e6, -1e6, -1}))},
                           std::pair{"half-space", halfspace({0, 0, 1}, 0)}};
  for (const auto& [ground, floor] : grounds) {
    const Scene scene = compile(*part + floor, Welding::derived());
    fmt::print("{:12} {:10}", name, ground);
    for (const Point eye : {Point{0.02, -0.03, 0.025}, Point{-0.035, -0.01, 0.004}, Point{0.3, 0.2, 0.05}}) {
      Caster caster(scene);
      IntervalList list;
      const std::vector<Ray> rays = rays_from(eye, 4 * side);
      for (const Ray& ray : rays) {
        caster.begin(ray);
        caster.first_hit();
        caster.intervals(list);
      }
      fmt::print(" {:10.1e}", static_cast<double>(caster.counts().rays_flagged) / static_cast<double>(rays.size()));
    }
    fmt::print("\n");
  }
}

void report(const std::vector<std::string>& files) {
  fmt::print("million rays per second at scale 1, and the rates at other scales over that\n{:22}", "scene");
  for (const Scale& scale : scales) fmt::print(" {:>8}", scale.name);
  fmt::print("\n");
  const auto for_each = [&files](auto&& print) {
    for (const std::string& file : files)
      print(std::filesystem::path(file).stem().string(), text::build(text::read_file(file)).solid);
  };
  for_each(report_scales);
  fmt::print("\nshare of rays flagged, scene of size 1/100 on a ground\n{:12} {:10} {:>10} {:>10} {:>10}\n", "scene",
             "ground", "from above", "low", "from afar");
  for_each(report_on_ground);
}

}  // namespace
}  // namespace csgcast::bench

int main(int argc, char** argv) {
  try {
    csgcast::bench::report(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const csgcast::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
