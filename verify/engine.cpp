// SPDX-License-Identifier: MIT
#include "verify/engine.h"

#include <deque>
#include <string>
#include <vector>

#include "raycast/packets/packet_caster.h"

namespace csgcast::verify {
namespace {

class ScalarEngine final : public Engine {
 public:
  ScalarEngine(const Scene& scene, const Predicates& predicates) : caster_(scene, predicates) {}

  void answer(std::span<const Ray> rays, std::span<Answers> answers) override {
    for (std::size_t i = 0; i < rays.size(); ++i) answer(rays[i], answers[i]);
  }

 private:
  void answer(const Ray& ray, Answers& answers) {
    const CasterCounts before = caster_.counts();
    caster_.begin(ray);
    answers.any_hit = caster_.any_hit();
    caster_.begin(ray);
    answers.first_hit = caster_.first_hit();
    caster_.begin(ray);
    caster_.intervals(answers.ray);
    caster_.begin(ray);
    caster_.intervals(answers.line, Span::line());
    caster_.begin(Ray(ray.origin(), -ray.direction()));
    caster_.intervals(answers.reversed, Span::line());
    const CasterCounts after = caster_.counts();
    answers.flagged = after.rays_flagged > before.rays_flagged;
    answers.exact_decisions = after.exact_calls - before.exact_calls;
  }

  Caster caster_;
};

// The engine of packets, with one instruction set.
class PacketEngine final : public Engine {
 public:
  PacketEngine(const Cells& cells, PacketCaster::Width width, std::string_view instructions)
      : caster_(cells, width, instructions) {}

  void answer(std::span<const Ray> rays, std::span<Answers> answers) override {
    any_.resize(rays.size());
    first_.resize(rays.size());
    reversed_.clear();
    for (const Ray& ray : rays) reversed_.emplace_back(ray.origin(), -ray.direction());
    const std::uint64_t exact = caster_.caster_counts().exact_calls;
    caster_.any_hits(rays, any_);
    caster_.first_hits(rays, first_);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      answers[i].any_hit = any_[i] != 0;
      answers[i].first_hit = first_[i];
      answers[i].flagged = false;
    }
    ask(rays, {}, answers, &Answers::ray);
    ask(rays, Span::line(), answers, &Answers::line);
    ask(reversed_, Span::line(), answers, &Answers::reversed);
    // The work left to the caster is known only for all rays together.
    const std::uint64_t spent = caster_.caster_counts().exact_calls - exact;
    for (Answers& answer : answers.first(rays.size())) answer.exact_decisions = 0;
    if (!rays.empty()) answers.front().exact_decisions = spent;
  }

 private:
  void ask(std::span<const Ray> rays, Span span, std::span<Answers> answers, IntervalList Answers::*which) {
    caster_.intervals(rays, batch_, span);
    for (const std::uint32_t i : caster_.left_to_caster()) answers[i].flagged = true;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto list = batch_.of(i);
      (answers[i].*which).assign(list.begin(), list.end());
    }
  }

  PacketCaster caster_;
  std::vector<std::uint8_t> any_;
  std::vector<std::optional<Hit>> first_;
  std::vector<Ray> reversed_;
  IntervalBatch batch_;
};

std::vector<EngineKind> make_table() {
  std::vector<EngineKind> table;
  table.push_back({"scalar", [](Subject& s) { return scalar_engine(s.scene(), certified_predicates()); }});
  static std::deque<std::string> names;  // the table's names must stay valid
  const auto add = [&](PacketCaster::Width width, std::string_view set) {
    names.push_back((width == PacketCaster::Width::packet ? "packets/" : "single/") + std::string(set));
    table.push_back({names.back(), [=](Subject& s) { return std::make_unique<PacketEngine>(s.cells(), width, set); }});
  };
  const std::vector<std::string_view> sets = PacketCaster::instruction_sets();
  for (const std::string_view set : sets) add(PacketCaster::Width::packet, set);
  for (const std::string_view set : sets) add(PacketCaster::Width::single, set);
  return table;
}

}  // namespace

std::span<const EngineKind> engines() {
  static const std::vector<EngineKind> table = make_table();
  return table;
}

std::unique_ptr<Engine> scalar_engine(const Scene& scene, const Predicates& predicates) {
  return std::make_unique<ScalarEngine>(scene, predicates);
}

}  // namespace csgcast::verify
