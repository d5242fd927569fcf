// SPDX-License-Identifier: MIT
#include "tests/bench/accuracy/measure.h"

#include <algorithm>

#include "tests/bench/accuracy/error.h"
#include "tests/bench/accuracy/stopwatch.h"
#include "tests/bench/accuracy/ways.h"

namespace csgcast::bench {
namespace {

constexpr std::size_t passes = 5;

enum class Query : std::uint8_t { lists, first };

std::size_t count_rays(std::span<const Sample> samples) {
  std::size_t count = 0;
  for (const Sample& sample : samples) count += sample.rays.size();
  return count;
}

double seconds(Caster& caster, const std::vector<Ray>& rays, Query query, IntervalList& list) {
  const Stopwatch watch;
  for (const Ray& ray : rays) {
    caster.begin(ray);
    if (query == Query::lists) {
      caster.intervals(list);
    } else {
      caster.first_hit();
    }
  }
  return watch.seconds();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// Seconds for all samples, way by way: the median of several passes, in which the ways take turns scene by scene.
std::vector<double> time_ways(std::span<const Sample> samples, Query query) {
  std::vector<std::vector<double>> totals(ways().size(), std::vector<double>(passes));
  IntervalList list;
  for (std::size_t pass = 0; pass < passes; ++pass) {
    for (const Sample& sample : samples) {
      for (std::size_t way = 0; way < ways().size(); ++way) {
        Caster caster(*sample.scene, ways()[way].predicates);
        seconds(caster, {sample.rays.front()}, query, list);  // its memory grows
        totals[way][pass] += seconds(caster, sample.rays, query, list);
      }
    }
  }
  std::vector<double> result;
  for (const std::vector<double>& total : totals) result.push_back(median(total));
  return result;
}

Measurement judge_lists(std::span<const Sample> samples, const Predicates& predicates) {
  Measurement result;
  Errors errors;
  IntervalList list;
  for (const Sample& sample : samples) {
    Caster caster(*sample.scene, predicates);
    for (std::size_t i = 0; i < sample.rays.size(); ++i) {
      caster.begin(sample.rays[i]);
      caster.intervals(list);
      ++result.rays;
      if (!has_structure(list, sample.lists[i])) {
        ++result.wrong;
        continue;
      }
      for (std::size_t n = 0; n < list.size(); ++n) {
        const auto add = [&](const Crossing& end, const Crossing& exact) {
          if (exact.surface.valid()) errors.add(ulps_off(end.t, exact.t, sample.size_along(sample.rays[i])));
        };
        add(list[n].entry, sample.lists[i][n].entry);
        add(list[n].exit, sample.lists[i][n].exit);
      }
    }
  }
  result.query = "lists";
  result.ulps_99 = errors.percentile_99();
  result.ulps_most = errors.greatest();
  return result;
}

FirstHits ask_first_hits(std::span<const Sample> samples, const Predicates& predicates) {
  FirstHits answer;
  for (const Sample& sample : samples) {
    Caster caster(*sample.scene, predicates);
    for (const Ray& ray : sample.rays) {
      caster.begin(ray);
      const std::optional<Hit> hit = caster.first_hit();
      answer.t.push_back(hit ? std::optional(hit->crossing.t) : std::nullopt);
    }
  }
  return answer;
}

}  // namespace

std::vector<Measurement> measure_ways(const std::string& family, std::span<const Sample> samples) {
  std::vector<Measurement> results;
  const double rays = static_cast<double>(count_rays(samples));
  const std::vector<double> list_seconds = time_ways(samples, Query::lists);
  const std::vector<double> first_seconds = time_ways(samples, Query::first);
  for (std::size_t i = 0; i < ways().size(); ++i) {
    const Way& way = ways()[i];
    Measurement lists = judge_lists(samples, way.predicates);
    lists.family = family;
    lists.way = way.name;
    lists.nanoseconds = list_seconds[i] / rays * 1e9;
    results.push_back(lists);
    FirstHits first = ask_first_hits(samples, way.predicates);
    first.nanoseconds = first_seconds[i] / rays * 1e9;
    results.push_back(judge(family, way.name, samples, first));
  }
  return results;
}

std::vector<Measurement> measure_exact(const std::string& family, std::span<const Sample> samples) {
  FirstHits first;
  double list_seconds = 0;
  double first_seconds = 0;
  for (const Sample& sample : samples) {
    for (const FirstHit& hit : sample.first_hits) first.t.push_back(hit.t);
    list_seconds += sample.exact_list_seconds;
    first_seconds += sample.exact_first_seconds;
  }
  const std::size_t rays = count_rays(samples);
  first.nanoseconds = first_seconds / static_cast<double>(rays) * 1e9;
  Measurement lists;
  lists.family = family;
  lists.way = "exact";
  lists.query = "lists";
  lists.rays = rays;
  lists.nanoseconds = list_seconds / static_cast<double>(rays) * 1e9;
  return {lists, judge(family, lists.way, samples, first)};
}

Measurement judge(const std::string& family, const std::string& program, std::span<const Sample> samples,
                  const FirstHits& answer) {
  Measurement result;
  result.family = family;
  result.way = program;
  result.query = "first";
  result.nanoseconds = answer.nanoseconds;
  std::uint64_t clear = 0;
  std::uint64_t wrong_clear = 0;
  Errors errors;
  auto next = answer.t.begin();
  for (const Sample& sample : samples) {
    for (std::size_t i = 0; i < sample.rays.size(); ++i) {
      const std::optional<double>& t = *next++;
      const FirstHit& exact = sample.first_hits[i];
      if (!exact.is_compared) continue;
      const double reach = sample.size_along(sample.rays[i]);
      const bool right = is_same_hit(t, exact.t, reach);
      ++result.rays;
      result.wrong += right ? 0 : 1;
      clear += exact.is_clear ? 1 : 0;
      wrong_clear += exact.is_clear && !right ? 1 : 0;
      if (right && t) errors.add(ulps_off(*t, *exact.t, reach));
    }
  }
  result.clear_rays = clear;
  result.wrong_clear = wrong_clear;
  result.ulps_99 = errors.percentile_99();
  result.ulps_most = errors.greatest();
  return result;
}

}  // namespace csgcast::bench
