// SPDX-License-Identifier: MIT
// No unit of length is special: every example scene, scaled as a whole.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "csg/base/length.h"
#include "raycast/ray/caster.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/examples.h"
#include "tests/support/rounded_leaves.h"
#include "tests/support/scene_rays.h"
#include "tests/support/twins.h"

using namespace csgcast;
using test::scaled;
using test::SceneRays;
using test::Twins;

namespace {

bool same_but_for_t(const Crossing& a, const Crossing& b) { return a.surface == b.surface && a.root == b.root; }

// The ends of all leaves along a ray.
class Events {
 public:
  explicit Events(const Scene& scene) : caster_(scene) {}

  // The least distance of two that different surfaces make, or different crossings of one.
  double least_distance(const Ray& ray) {
    caster_.begin(ray);
    ends_.clear();
    for (std::uint32_t id = 0; id < caster_.scene().nodes().size(); ++id) {
      if (caster_.scene().nodes()[id].op != Node::Op::leaf) continue;
      caster_.intervals(NodeId(id), list_, Span::line());
      for (const Interval& interval : list_) ends_.insert(ends_.end(), {interval.entry, interval.exit});
    }
    std::sort(ends_.begin(), ends_.end(), [](const Crossing& a, const Crossing& b) {
      return std::tie(a.t, a.surface, a.root) < std::tie(b.t, b.surface, b.root);
    });
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < ends_.size(); ++i) {
      if (same_but_for_t(ends_[i - 1], ends_[i])) continue;
      least = std::min(least, ends_[i].t - ends_[i - 1].t);
    }
    return least * length(ray.direction());
  }

 private:
  Caster caster_;
  IntervalList list_;
  std::vector<Crossing> ends_;
};

// A ray's list as what is compared between scenes whose numbers are rounded differently: the leaves whose faces bound
// it, and by which crossings.
class Structure {
 public:
  explicit Structure(const Scene& scene) : caster_(scene) {}

  struct End {
    LeafId leaf;
    std::uint8_t root;
    friend bool operator==(const End&, const End&) = default;
  };
  const std::vector<End>& operator()(const Ray& ray) {
    caster_.begin(ray);
    caster_.intervals(list_, Span::line());
    ends_.clear();
    for (const Interval& interval : list_) {
      add(interval.entry, Passage::entry);
      add(interval.exit, Passage::exit);
    }
    return ends_;
  }

 private:
  void add(const Crossing& end, Passage passage) {
    const LeafId leaf = end.surface.valid() ? caster_.attribute({end, passage}).leaf : LeafId();
    ends_.push_back({leaf, end.root});
  }

  Caster caster_;
  IntervalList list_;
  std::vector<End> ends_;
};

struct Comparison {
  int rays = 0;
  int left_out = 0;  // two of their events are within 1e-12 of the scene
  int met = 0;       // rays that meet the scene
  int wrong = 0;
};

// Rays of a scene against the same rays, rounded, of the scene that is larger by `factor`.
Comparison compare(const Scene& scene, const Scene& large, double factor, std::uint64_t seed, int rays) {
  SceneRays source(scene, seed);
  Events events(scene);
  Structure plain(scene);
  Structure of_large(large);
  const double closest = 1e-12 * length(scene.bounded_leaves().size());
  Comparison result;
  for (; result.rays < rays; ++result.rays) {
    const Ray ray = result.rays % 2 == 0 ? source.through_anywhere() : source.along_an_axis();
    if (!(events.least_distance(ray) > closest)) {
      ++result.left_out;
      continue;
    }
    const auto& expected = plain(ray);
    result.met += !expected.empty();
    result.wrong += expected != of_large(Ray(scaled(ray.origin(), factor), ray.direction()));
  }
  return result;
}

// Next to no random ray passes so close to an edge.
constexpr double most_left_out = 1e-3;

}  // namespace

TEST_CASE("a scene 2^k times as large gives the same lists, faces and places, every t exactly 2^k times as large") {
  const int rays = test::long_run() ? 2000 : test::times(300);
  for (const std::string& name : test::example_names()) {
    const Solid solid = test::example(name).solid;
    const Scene scene = compile(solid);
    const int step = test::long_run() ? 1 : 20;
    for (int k = -60; k <= 60; k += step) {
      const double factor = std::exp2(k);
      const Scene large = compile(scaled(solid, factor));
      REQUIRE(large.surfaces().size() == scene.surfaces().size());
      Twins twins(scene, large, factor);
      SceneRays source(scene, static_cast<std::uint64_t>(k + 1000));
      int wrong = 0;
      for (int i = 0; i < rays; ++i) {
        const Ray ray = source.next();
        wrong += !twins.agree(ray, i % 2 == 0);
        wrong += !twins.agree(source.anywhere()) + !twins.agree(source.corner()) + !twins.agree(ray.at(i % 4));
      }
      CAPTURE(name, k);
      CHECK(wrong == 0);
      CHECK(twins.worked_alike());
    }
  }
}

TEST_CASE("a scene 1/1000, 1,000 and 1,000,000 times as large gives lists of the same structure") {
  const int rays = test::long_run() ? 100'000 : test::times(1000);
  for (const std::string& name : test::example_names()) {
    const Solid solid = test::example(name).solid;
    for (const Welding& welding : {Welding{}, Welding::derived()}) {
      const Scene scene = compile(solid, welding);
      for (const double factor : {1e-3, 1e3, 1e6}) {
        const Comparison result = compare(scene, compile(scaled(solid, factor), welding), factor, 21, rays);
        CAPTURE(name, factor, result.left_out);
        CHECK(result.wrong == 0);
        CHECK(result.met > rays / 5);
        // Unwelded, faces that coincide but for rounding are two events.
        const double share = welding.mode == Welding::Mode::off ? 0.1 : most_left_out;
        CHECK(result.left_out <= share * rays);
      }
    }
  }
}

TEST_CASE("a scene whose leaves were scaled one by one, each with rounding, welds to lists of the same structure") {
  const int rays = test::long_run() ? 100'000 : test::times(1000);
  for (const std::string name : {"flush", "sponge", "angel", "die", "flange"}) {
    const Solid solid = test::example(name).solid;
    const Scene scene = compile(solid, Welding::derived());
    for (const double factor : {1e-3, 1e3, 1e6}) {
      const Solid large = test::with_rounded_leaves(solid, scaling({factor, factor, factor}));
      const Comparison result = compare(scene, compile(large, Welding::derived()), factor, 22, rays);
      CAPTURE(name, factor, result.left_out);
      CHECK(result.wrong == 0);
      CHECK(result.met > rays / 5);
      CHECK(result.left_out <= most_left_out * rays);
    }
  }
}
