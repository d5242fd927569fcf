// SPDX-License-Identifier: MIT
// examples/flush.csg has nothing but coincident faces: from no view does a ray show one that is inside the slab, or a
// sliver.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "csg/base/length.h"
#include "raycast/ray/caster.h"
#include "shade/film/camera.h"
#include "tests/shade/flush_truth.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/examples.h"
#include "tests/support/random_solid.h"

using namespace csgcast;
using test::FlushEnd;

namespace {

constexpr int side = 64;
constexpr Point middle{3, 3, 0.5};

// Any camera around the slab, perspective or parallel, near or far.
CameraDescription any_view(test::RandomSolids& random) {
  CameraDescription camera;
  camera.look_at = middle + 2 * random.direction();
  camera.eye = middle + random.number(4, 40) * normalised(random.direction());
  camera.up = random.direction();
  camera.fov = random.number(5, 90);
  if (random.index(2) == 0) camera.height = random.number(1, 12);
  return camera;
}

// One that looks along the slab's faces, its eye in one of them but for at most 1/10, at least 1e-12.
CameraDescription grazing_view(test::RandomSolids& random) {
  CameraDescription camera = any_view(random);
  const double plane = 0.5 * static_cast<double>(random.index(3));
  const auto off = [&] { return (random.index(2) == 0 ? 1 : -1) * std::pow(10.0, -random.number(1, 12)); };
  camera.eye.z = plane + off();
  camera.look_at.z = plane + off();
  camera.up = {0, 0, 1};
  return camera;
}

// A parallel one along an axis of the scene.
CameraDescription axis_view(test::RandomSolids& random) {
  CameraDescription camera;
  camera.look_at = middle + random.direction();
  camera.eye = camera.look_at;
  camera.eye[random.index(3)] += random.index(2) == 0 ? 10 : -10;
  camera.height = random.number(1, 12);
  return camera;
}

CameraDescription view(test::RandomSolids& random) {
  switch (random.index(4)) {
    case 0:
      return axis_view(random);
    case 1:
      return grazing_view(random);
    default:
      return any_view(random);
  }
}

class Comparison {
 public:
  Comparison() : scene_(compile(test::example("flush").solid)), caster_(scene_) {}

  const Scene& scene() const { return scene_; }

  // Whether the list of a ray, the leaves that own its ends, and its first hit are those of the scene's geometry.
  bool agrees(const Ray& ray) {
    caster_.begin(ray);
    caster_.intervals(list_, Span::line());
    const std::vector<FlushEnd> truth = test::flush_truth(ray);
    if (truth.size() != 2 * list_.size()) return false;
    for (std::size_t k = 0; k < truth.size(); ++k) {
      const Interval& interval = list_[k / 2];
      const Hit hit = k % 2 == 0 ? Hit{interval.entry, Passage::entry} : Hit{interval.exit, Passage::exit};
      if (!is(hit, truth[k])) return false;
    }
    return first_hit_is(truth);
  }

 private:
  bool is(const Hit& hit, const FlushEnd& end) {
    if (!hit.crossing.surface.valid()) return hit.crossing.t == end.t;
    const std::size_t leaf = caster_.attribute(hit).leaf.index();
    return std::fabs(hit.crossing.t - end.t) <= 1e-9 * (1 + std::fabs(end.t)) &&
           std::find(end.leaves.begin(), end.leaves.end(), leaf) != end.leaves.end();
  }

  bool first_hit_is(const std::vector<FlushEnd>& truth) {
    const auto hit = caster_.first_hit();
    const auto end = std::find_if(truth.begin(), truth.end(), [](const FlushEnd& e) { return e.t >= 0; });
    if (end == truth.end() || end->leaves.empty()) return !hit;
    return hit && is(*hit, *end) && (hit->passage == Passage::entry) == ((end - truth.begin()) % 2 == 0);
  }

  Scene scene_;
  Caster caster_;
  IntervalList list_;
};

}  // namespace

TEST_CASE("from any view of flush every ray shows the faces that its geometry has, none inside and no sliver") {
  Comparison comparison;
  REQUIRE(comparison.scene().leaves().size() == 79);
  test::RandomSolids random(71);
  const int views = test::long_run() ? 1000 : test::times(40);
  int wrong = 0;
  for (int n = 0; n < views; ++n) {
    const Camera camera(view(random), side, side);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) wrong += !comparison.agrees(camera.ray(x + 0.5, y + 0.5));
  }
  CHECK(wrong == 0);
}
