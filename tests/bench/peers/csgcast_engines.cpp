// SPDX-License-Identifier: MIT
#include <limits>

#include "raycast/caster.h"
#include "tests/bench/peers/engines.h"

namespace csgcast::bench {
namespace {

class ScalarEngine : public Engine {
 public:
  explicit ScalarEngine(const Scene& scene) : caster_(scene) {}

  std::string name() const override { return "csgcast, single rays"; }

  void first_hits(std::span<const Ray> rays, std::span<double> t) override {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      caster_.begin(rays[i]);
      const std::optional<Hit> hit = caster_.first_hit(Span{}, Rounding::close);
      t[i] = hit ? hit->crossing.t : std::numeric_limits<double>::infinity();
    }
  }

  void intervals(std::span<const Ray> rays, IntervalTable& table) override {
    for (const Ray& ray : rays) {
      caster_.begin(ray);
      caster_.intervals(list_);
      for (const Interval& interval : list_) {
        table.ends.push_back(interval.entry.t);
        table.ends.push_back(interval.exit.t);
      }
      table.end_ray();
    }
  }

 private:
  Caster caster_;
  IntervalList list_;
};

}  // namespace

Engines csgcast_engines(const PeerScene& scene) {
  Engines engines;
  engines.push_back(std::make_unique<ScalarEngine>(scene.compiled));
  // Another engine of csgcast is one more class above and one more line here.
  return engines;
}

}  // namespace csgcast::bench
