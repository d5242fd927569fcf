// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "raycast/cells/cells.h"
#include "raycast/ray/caster.h"

namespace csgcast::verify {

/// All answers about one ray.
struct Answers {
  IntervalList ray;       ///< over [0, infinity)
  IntervalList line;      ///< over the whole line
  IntervalList reversed;  ///< over the whole line of (origin, -direction)
  std::optional<Hit> first_hit;
  bool any_hit = false;
  bool flagged = false;               ///< true if plain double left some decision of structure open
  std::uint64_t exact_decisions = 0;  ///< the number of decisions of structure that needed exact numbers
};

/// One way to answer rays. It has working memory of its own, so each thread has one.
class Engine {
 public:
  virtual ~Engine() = default;
  /// Overwrites `answers`, one for each ray. Many rays come at once, to fill the packets of engines that use them.
  virtual void answer(std::span<const Ray> rays, std::span<Answers> answers) = 0;
};

/// The subject of engines: a scene, and its cells, which are made when they are asked for first. For one thread.
class Subject {
 public:
  /// The scene must outlive the subject.
  explicit Subject(const Scene& scene) : scene_(scene) {}
  const Scene& scene() const { return scene_; }
  const Cells& cells() {
    if (!cells_) cells_.emplace(scene_);
    return *cells_;
  }

 private:
  const Scene& scene_;
  std::optional<Cells> cells_;
};

struct EngineKind {
  std::string_view name;
  std::function<std::unique_ptr<Engine>(Subject&)> make;  ///< the subject must outlive the engine
};

/// Every engine that promises the answer of docs/answer.md. A new one is one more row here.
std::span<const EngineKind> engines();

/// The caster, one ray at a time, with the given predicates. No question uses results of an earlier one.
std::unique_ptr<Engine> scalar_engine(const Scene& scene, const Predicates& predicates);

}  // namespace csgcast::verify
