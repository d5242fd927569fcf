// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verify/engine.h"

namespace csgcast::verify {

/// Counts of one engine over some rays.
struct Tally {
  std::uint64_t rays = 0;
  std::uint64_t intervals = 0;        ///< intervals on the rays' whole lines, by exact arithmetic
  std::uint64_t flagged = 0;          ///< rays with a decision that plain double left open
  std::uint64_t exact_decisions = 0;  ///< decisions that took exact numbers, over all questions
  std::uint64_t wrong = 0;            ///< rays with an answer that differs from the exact stage's
  Tally& operator+=(const Tally& other);
  friend bool operator==(const Tally&, const Tally&) = default;
};

enum class Question : std::uint8_t { any_hit, first_hit, ray, line, reversed };
/// "whole line", "first hit", ..
std::string_view name(Question question);

/// A ray that an engine answered wrongly, with the first question that shows it.
struct Mismatch {
  Ray ray;
  std::string_view engine;
  Question question;
  std::string difference;  ///< what was found, and what was expected
};

/// The options of `csgcast intervals SCENE ..` that show a mismatch. The numbers read back to the same doubles.
std::string interval_options(const Mismatch& mismatch);

/// Compares engines on one scene with the exact stage. Lists over [0, infinity) and over the whole line are compared
/// bit by bit: the number of intervals, the surfaces and each t (the two zeros are equal). The list of the reversed
/// ray, first_hit and any_hit are compared, too. Roots are not compared, because an engine numbers only those that
/// matter to the scene.
///
/// The exact stage computes two lists. The other answers follow from these by definition. Working memory for one
/// thread.
class Comparison {
 public:
  /// The scene must outlive the comparison.
  explicit Comparison(const Scene& scene, std::span<const EngineKind> kinds = engines());

  /// Adds to the tallies, one for each engine, and appends mismatches while there are fewer than `most`.
  void compare(std::span<const Ray> rays, std::span<Tally> tallies, std::vector<Mismatch>& mismatches,
               std::size_t most);

 private:
  void ask_exact(const Ray& ray);
  void judge(std::size_t engine, const Ray& ray, const Answers& found, Tally& tally, std::vector<Mismatch>& mismatches,
             std::size_t most) const;

  Subject subject_;
  Caster exact_;
  std::vector<std::string_view> names_;
  std::vector<std::unique_ptr<Engine>> engines_;
  std::vector<std::vector<Answers>> answers_;  // for each engine, for each ray of a packet
  Answers expected_;
};

}  // namespace csgcast::verify
