// SPDX-License-Identifier: MIT
#include "tests/bench/peers/rates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/bench/accuracy/stopwatch.h"

namespace csgcast::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The answers of one kind that an engine gave.
struct Answers {
  std::vector<double> t;
  IntervalTable table;
};

double seconds(Engine& engine, Query query, const RayBatch& rays, Answers& answers) {
  answers.t.resize(rays.size());
  answers.table.clear();
  const Stopwatch watch;
  if (query == Query::first_hit) {
    engine.first_hits(rays, answers.t);
  } else {
    engine.intervals(rays, answers.table);
  }
  const double seconds = watch.seconds();
  if (query == Query::first_hit) {
    engine.restate(answers.t);
  } else {
    engine.restate(answers.table);
  }
  return seconds;
}

std::span<const double> answer_to(Query query, const Answers& answers, std::size_t ray) {
  return query == Query::first_hit ? std::span(&answers.t[ray], 1) : answers.table.of(ray);
}

bool same_t(double a, double b, double tolerance) { return a == b || std::fabs(a - b) <= tolerance; }

// Answers to every stride-th tile, compared with right ones to all tiles.
void judge(const Answers& answers, const Answers& right, std::size_t stride, double tolerance, Rate& rate) {
  for (std::size_t i = 0; i < rate.rays; ++i) {
    const std::span<const double> given = answer_to(rate.query, answers, i);
    const std::size_t ray = i / tile_rays * stride * tile_rays + i % tile_rays;
    const std::span<const double> wanted = answer_to(rate.query, right, ray);
    const bool is_hit_both = rate.query == Query::intervals || std::isinf(given[0]) == std::isinf(wanted[0]);
    if (given.size() != wanted.size() || !is_hit_both) {
      ++rate.wrong_count;
    } else if (!std::equal(given.begin(), given.end(), wanted.begin(),
                           [tolerance](double a, double b) { return same_t(a, b, tolerance); })) {
      ++rate.wrong_t;
    }
  }
}

// One engine at work on the rays that it gets.
struct Contest {
  Engine* engine = nullptr;
  std::size_t stride = 1;   // of tiles
  std::size_t repeats = 1;  // in a pass
  RayBatch rays;
  std::vector<double> seconds;
  Answers answers;
};

// Gives an engine its rays: every stride-th tile, such that a pass takes no longer than it may. A small part of the
// rays tells. Strides are odd, so that the tiles do not stand in a column.
void give_rays(Contest& contest, Query query, const PeerScene& scene, double most_seconds) {
  constexpr std::size_t thin = 61;
  const RayBatch few(every_tile(scene.rays, thin));
  const double share = static_cast<double>(few.size()) / static_cast<double>(scene.rays.size());
  const double estimate = seconds(*contest.engine, query, few, contest.answers) / share;
  if (estimate > most_seconds) contest.stride = static_cast<std::size_t>(std::ceil(estimate / most_seconds)) | 1U;
  contest.rays = RayBatch(every_tile(scene.rays, contest.stride));
}

// How often in a pass it answers for them, so that a pass is long enough to be timed. The rays go once through
// unjudged.
void set_repeats(Contest& contest, Query query) {
  constexpr double least_seconds = 0.1;
  const double once = seconds(*contest.engine, query, contest.rays, contest.answers);
  contest.repeats = static_cast<std::size_t>(std::ceil(least_seconds / once));
}

double seconds_of_pass(Contest& contest, Query query) {
  double sum = 0;
  for (std::size_t i = 0; i < contest.repeats; ++i)
    sum += seconds(*contest.engine, query, contest.rays, contest.answers);
  return sum / static_cast<double>(contest.repeats);
}

std::vector<Rate> measure(const PeerScene& scene, const Engines& engines, Query query, const Effort& effort) {
  std::vector<Contest> contests;
  for (const std::unique_ptr<Engine>& engine : engines) {
    if (query == Query::intervals && !engine->knows_intervals()) continue;
    Contest& contest = contests.emplace_back();
    contest.engine = engine.get();
    // What is right must be known for all rays, whatever it takes.
    give_rays(contest, query, scene, contests.size() == 1 ? infinity : effort.seconds);
    set_repeats(contest, query);
  }
  for (int pass = 0; pass < effort.passes; ++pass) {
    for (Contest& contest : contests) contest.seconds.push_back(seconds_of_pass(contest, query));
  }
  std::vector<Rate> rates;
  for (Contest& contest : contests) {
    std::nth_element(contest.seconds.begin(), contest.seconds.begin() + effort.passes / 2, contest.seconds.end());
    Rate rate{scene.name, contest.engine->name(), query, 0, contest.rays.size(), 0, 0};
    rate.rays_per_second = static_cast<double>(rate.rays) / contest.seconds[effort.passes / 2];
    judge(contest.answers, contests[0].answers, contest.stride, t_tolerance * scene.size, rate);
    rates.push_back(rate);
  }
  return rates;
}

}  // namespace

std::vector<Rate> measure(const PeerScene& scene, const Engines& engines, const Effort& effort) {
  std::vector<Rate> all;
  for (const Query query : {Query::first_hit, Query::intervals}) {
    const std::vector<Rate> rates = measure(scene, engines, query, effort);
    all.insert(all.end(), rates.begin(), rates.end());
  }
  return all;
}

}  // namespace csgcast::bench
