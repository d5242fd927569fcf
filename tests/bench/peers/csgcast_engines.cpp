// SPDX-License-Identifier: MIT
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "raycast/packets/packet_caster.h"
#include "raycast/ray/caster.h"
#include "tests/bench/peers/engines.h"

namespace csgcast::bench {
namespace {

class ScalarEngine : public Engine {
 public:
  explicit ScalarEngine(const Scene& scene) : caster_(scene) {}

  std::string name() const override { return "csgcast, single rays"; }

  void first_hits(const RayBatch& rays, std::span<double> t) override {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      caster_.begin(rays.list()[i]);
      const std::optional<Hit> hit = caster_.first_hit(Span{}, Rounding::close);
      t[i] = hit ? hit->crossing.t : std::numeric_limits<double>::infinity();
    }
  }

  void intervals(const RayBatch& rays, IntervalTable& table) override {
    for (const Ray& ray : rays.list()) {
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

class LaneEngine : public Engine {
 public:
  LaneEngine(std::shared_ptr<const Cells> cells, PacketCaster::Width width)
      : name_(width == PacketCaster::Width::packet ? "csgcast, packets" : "csgcast, single rays in cells"),
        cells_(std::move(cells)),
        caster_(*cells_, width) {}

  std::string name() const override { return name_; }

  void first_hits(const RayBatch& rays, std::span<double> t) override {
    state_.resize(rays.size());
    surface_.resize(rays.size());
    caster_.first_hits(rays.arrays(), {state_, t, surface_}, Rounding::close);
  }

  void restate(std::span<double> t) override {
    for (std::size_t i = 0; i < t.size(); ++i) {
      if (state_[i] == HitArrays::none) t[i] = std::numeric_limits<double>::infinity();
    }
  }

  void intervals(const RayBatch& rays, IntervalTable&) override {
    caster_.intervals(rays.arrays(), batch_, Rounding::close);
  }

  void restate(IntervalTable& table) override {
    for (std::size_t i = 0; i + 1 < batch_.offsets.size(); ++i) {
      for (const Interval& interval : batch_.of(i)) {
        table.ends.push_back(interval.entry.t);
        table.ends.push_back(interval.exit.t);
      }
      table.end_ray();
    }
  }

 private:
  std::string name_;
  std::shared_ptr<const Cells> cells_;  // shared with the other width
  PacketCaster caster_;
  std::vector<std::uint8_t> state_;
  std::vector<std::uint32_t> surface_;
  IntervalBatch batch_;
};

}  // namespace

Engines csgcast_engines(const PeerScene& scene) {
  Engines engines;
  engines.push_back(std::make_unique<ScalarEngine>(scene.compiled));
  const auto cells = std::make_shared<const Cells>(scene.compiled);
  engines.push_back(std::make_unique<LaneEngine>(cells, PacketCaster::Width::single));
  engines.push_back(std::make_unique<LaneEngine>(cells, PacketCaster::Width::packet));
  return engines;
}

}  // namespace csgcast::bench
