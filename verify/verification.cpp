// SPDX-License-Identifier: MIT
#include "verify/verification.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>

#include "raycast/packets/threads.h"
#include "verify/adversarial_rays.h"

namespace csgcast::verify {
namespace {

constexpr int most_rounds = 8;

std::size_t adversarial_kinds() { return AdversarialRays::kinds().size() - 1; }

/// The objects that one thread needs.
struct Worker {
  Worker(const Scene& scene, std::span<const EngineKind> kinds) : rays(scene), comparison(scene, kinds) {}
  AdversarialRays rays;
  Comparison comparison;
  std::vector<Ray> made;
  std::vector<Mismatch> mismatches;
};

/// Rays are made and compared in blocks. Each block has random numbers of its own. The first blocks are random rays.
class Job {
 public:
  Job(const Scene& scene, const VerificationOptions& options, std::span<const EngineKind> kinds)
      : options_(options),
        rays_a_kind_(std::clamp<std::uint64_t>(options.rays / adversarial_kinds(), 1, 4)),
        rays_a_block_(rays_a_kind_ * adversarial_kinds()),
        blocks_a_sort_((options.rays + rays_a_block_ - 1) / rays_a_block_),
        progress_(options.progress, 2 * blocks_a_sort_),
        workers_([&scene, kinds] { return Worker(scene, kinds); }) {
    for (const EngineKind& kind : kinds) report_.engines.push_back(kind.name);
    for (const std::string_view kind : AdversarialRays::kinds())
      report_.kinds.push_back({kind, std::vector<Tally>(kinds.size())});
  }

  VerificationReport run() {
    on_threads(options_.threads, [&] {
      tbb::parallel_for(std::uint64_t{0}, 2 * blocks_a_sort_, [&](std::uint64_t block) { do_block(block); });
    });
    progress_.finish();
    std::erase_if(report_.kinds, [](const KindReport& kind) { return kind.tallies.front().rays == 0; });
    for (auto& [order, found] : found_) report_.mismatches.push_back(std::move(found));
    return std::move(report_);
  }

 private:
  void do_block(std::uint64_t block) {
    Worker& worker = workers_.local();
    Random random(options_.seed, block);
    const std::uint64_t index = block % blocks_a_sort_;
    const std::size_t wanted =
        static_cast<std::size_t>(std::min<std::uint64_t>(rays_a_block_, options_.rays - index * rays_a_block_));
    std::size_t left = wanted;
    if (block < blocks_a_sort_) {
      for (int round = 0; round < most_rounds && left > 0; ++round) left -= do_rays(worker, block, 0, random, left);
    } else {
      const std::size_t kinds = adversarial_kinds();
      // Each block that is cut short begins with a different kind.
      for (std::size_t i = 0; i < most_rounds * kinds && left > 0; ++i)
        left -= do_rays(worker, block, 1 + (index + i) % kinds, random, std::min(left, rays_a_kind_));
    }
    progress_.step();
  }

  /// Makes and compares rays of a kind, and returns their number.
  std::size_t do_rays(Worker& worker, std::uint64_t block, std::size_t kind, Random& random, std::size_t most) {
    worker.made.clear();
    worker.mismatches.clear();
    worker.rays.make(kind, random, most, worker.made);
    std::vector<Tally> tallies(report_.engines.size());
    worker.comparison.compare(worker.made, tallies, worker.mismatches, options_.most_mismatches);
    const std::lock_guard lock(mutex_);
    for (std::size_t e = 0; e < tallies.size(); ++e) report_.kinds[kind].tallies[e] += tallies[e];
    for (Mismatch& mismatch : worker.mismatches) keep(block, {report_.kinds[kind].kind, std::move(mismatch)});
    return worker.made.size();
  }

  /// Mismatches of one block come in order.
  void keep(std::uint64_t block, FoundMismatch mismatch) {
    const auto after = std::find_if(found_.begin(), found_.end(), [&](const auto& f) { return f.first > block; });
    found_.insert(after, {block, std::move(mismatch)});
    if (found_.size() > options_.most_mismatches) found_.pop_back();
  }

  const VerificationOptions& options_;
  std::size_t rays_a_kind_;  // the number of rays of each kind in a round of all kinds
  std::size_t rays_a_block_;
  std::uint64_t blocks_a_sort_;
  ProgressTeller progress_;
  tbb::enumerable_thread_specific<Worker> workers_;
  std::mutex mutex_;  // guards the following members
  VerificationReport report_;
  std::vector<std::pair<std::uint64_t, FoundMismatch>> found_;  // ascending in the block
};

}  // namespace

std::vector<Tally> VerificationReport::totals() const {
  std::vector<Tally> sums(engines.size());
  for (const KindReport& kind : kinds) {
    for (std::size_t e = 0; e < sums.size(); ++e) sums[e] += kind.tallies[e];
  }
  return sums;
}

VerificationReport verify_scene(const Scene& scene, const VerificationOptions& options,
                                std::span<const EngineKind> kinds) {
  return Job(scene, options, kinds).run();
}

std::uint64_t moderate_ray_count(const Scene& scene) {
  constexpr std::uint64_t most = 10'000;
  constexpr std::uint64_t least = 20;
  constexpr std::uint64_t budget = 1'500'000;  // the work for each sort of rays, as counted below
  constexpr std::uint64_t enough = 200'000;    // the work after which the cost is known
  constexpr int rounds = 4;
  AdversarialRays source(scene);
  Caster exact(scene, exact_predicates());
  Random random(1);
  IntervalList list;
  std::vector<Ray> rays;
  std::uint64_t shot = 0;
  std::uint64_t work = 0;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t kind = 0; kind < AdversarialRays::kinds().size() && work < enough; ++kind) {
      rays.clear();
      source.make(kind, random, 1, rays);
      for (const Ray& ray : rays) {
        exact.begin(ray);
        exact.intervals(list, Span::line());
        ++shot;
      }
      // An exact decision takes some microseconds, a leaf's list a fraction of one, a box less.
      const CasterCounts counts = exact.counts();
      work = counts.exact_calls + counts.leaf_tests / 4 + counts.box_tests / 16;
    }
  }
  return work == 0 ? most : std::clamp(budget * shot / work, least, most);
}

}  // namespace csgcast::verify
