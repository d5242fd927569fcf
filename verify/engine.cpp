// SPDX-License-Identifier: MIT
#include "verify/engine.h"

#include <array>

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

constexpr std::array table{
    EngineKind{"scalar", [](const Scene& scene) { return scalar_engine(scene, certified_predicates()); }},
};

}  // namespace

std::span<const EngineKind> engines() { return table; }

std::unique_ptr<Engine> scalar_engine(const Scene& scene, const Predicates& predicates) {
  return std::make_unique<ScalarEngine>(scene, predicates);
}

}  // namespace csgcast::verify
