// SPDX-License-Identifier: MIT
// What certification costs: first hits and whole lists of 256 x 256 parallel rays with certified and with uncertified
// predicates, in turn, nine times; the median of the ratios of their times. And how many rays needed more than double:
// on those rays, and on 512 x 512 along the axes. Scenes are welded, as the program does it.
// Then the same of the lanes: packets with certificates beside packets without, first hits, any hits and lists, t as it
// comes.
// Usage: bench_certification SCENE.csg ..
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "csg/base/length.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "raycast/cells/cells.h"
#include "raycast/cells/cells_data.h"
#include "raycast/packets/detail/lanes.h"
#include "raycast/ray/caster.h"
#include "tests/bench/rays_across.h"
#include "tests/bench/uncertified_lanes.h"
#include "tests/support/ray_batch.h"

namespace csgcast::bench {
namespace {

constexpr int side = 256;
constexpr int axis_side = 512;  // a grid of rays meets a symmetric solid's ties on its diagonals: a share of 1 / side
constexpr int passes = 9;

template <class Query>
double seconds(Caster& caster, const std::vector<Ray>& rays, const Query& query) {
  const auto start = std::chrono::steady_clock::now();
  for (const Ray& ray : rays) {
    caster.begin(ray);
    query(caster);
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Time with certificates over time without.
template <class Query>
double cost(const Scene& scene, const std::vector<Ray>& rays, const Query& query) {
  Caster certified(scene);
  Caster uncertified(scene, uncertified_predicates());
  seconds(certified, rays, query);
  std::vector<double> ratios;
  for (int pass = 0; pass < passes; ++pass) {
    const double with = seconds(certified, rays, query);
    ratios.push_back(with / seconds(uncertified, rays, query));
  }
  std::nth_element(ratios.begin(), ratios.begin() + passes / 2, ratios.end());
  return ratios[passes / 2];
}

double share_flagged(const Scene& scene, const std::vector<Ray>& rays) {
  Caster caster(scene);
  IntervalList list;
  for (const Ray& ray : rays) {
    caster.begin(ray);
    caster.intervals(list);
  }
  return static_cast<double>(caster.counts().rays_flagged) / static_cast<double>(rays.size());
}

void report(const std::string& file) {
  const Scene scene = compile(text::build(text::read_file(file)).solid, Welding::derived());
  const Box& box = scene.bounded_leaves();
  const std::vector<Ray> rays = rays_across(box, normalised({-0.61, 0.37, -0.29}), side);
  IntervalList list;
  const double first = cost(scene, rays, [](Caster& caster) { caster.first_hit({}, Rounding::close); });
  const double all = cost(scene, rays, [&list](Caster& caster) { caster.intervals(list); });
  fmt::print("{:24} {:10.3f} {:10.3f} {:10.1e} {:8.1e} {:8.1e} {:8.1e}\n", std::filesystem::path(file).stem().string(),
             first, all, share_flagged(scene, rays), share_flagged(scene, rays_across(box, {-1, 0, 0}, axis_side)),
             share_flagged(scene, rays_across(box, {0, 1, 0}, axis_side)),
             share_flagged(scene, rays_across(box, {0, 0, -1}, axis_side)));
}

// What lanes find of some rays, and how long they take for it.
class LaneRun {
 public:
  LaneRun(const Cells& cells, const test::RayBatch& rays)
      : cells_(cells),
        rays_(detail::pointers_of(rays.arrays())),
        state_(rays.size()),
        t_(rays.size()),
        surface_(rays.size()),
        ends_(rays.size()) {}

  double first_hits(const detail::LaneCode& code) {
    return seconds([&] { code.packet.first_hits(cells_.scene(), cells_.data(), rays_, hits(), counts_); });
  }
  double any_hits(const detail::LaneCode& code) {
    return seconds([&] { code.packet.any_hits(cells_.scene(), cells_.data(), rays_, hits(), counts_); });
  }
  double lists(const detail::LaneCode& code) {
    return seconds([&] {
      intervals_.clear();
      code.packet.lists(cells_.scene(), cells_.data(), rays_,
                        {.intervals = &intervals_, .ends = ends_.data(), .left = &left_}, counts_);
    });
  }

 private:
  template <class Call>
  double seconds(const Call& call) {
    left_.clear();
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  detail::LaneHits hits() {
    detail::LaneHits hits;
    hits.faces.state = state_.data();
    hits.faces.t = t_.data();
    hits.faces.surface = surface_.data();
    hits.left = &left_;
    return hits;
  }

  const Cells& cells_;
  detail::RayPointers rays_;
  std::vector<std::uint8_t> state_;
  std::vector<double> t_;
  std::vector<std::uint32_t> surface_;
  std::vector<std::size_t> ends_;
  std::vector<std::uint32_t> left_;
  IntervalList intervals_;
  PacketCounts counts_;
};

double cost_in_lanes(LaneRun& run, double (LaneRun::*query)(const detail::LaneCode&)) {
  constexpr int lane_passes = 41;
  const detail::LaneCode& certified = detail::lane_codes().front();
  std::vector<double> ratios;
  for (int pass = 0; pass < lane_passes; ++pass) {
    // Whoever goes first finds the cache colder: they take turns in that, too.
    const bool certified_first = pass % 2 == 0;
    const double one = (run.*query)(certified_first ? certified : uncertified_lanes());
    const double other = (run.*query)(certified_first ? uncertified_lanes() : certified);
    ratios.push_back(certified_first ? one / other : other / one);
  }
  std::nth_element(ratios.begin(), ratios.begin() + lane_passes / 2, ratios.end());
  return ratios[lane_passes / 2];
}

void report_lanes(const std::string& file) {
  const Scene scene = compile(text::build(text::read_file(file)).solid, Welding::derived());
  const Cells cells(scene);
  const test::RayBatch rays(rays_across(scene.bounded_leaves(), normalised({-0.61, 0.37, -0.29}), side));
  LaneRun run(cells, rays);
  fmt::print("{:24} {:10.3f} {:10.3f} {:10.3f}\n", std::filesystem::path(file).stem().string(),
             cost_in_lanes(run, &LaneRun::first_hits), cost_in_lanes(run, &LaneRun::any_hits),
             cost_in_lanes(run, &LaneRun::lists));
}

}  // namespace
}  // namespace csgcast::bench

int main(int argc, char** argv) {
  try {
    fmt::print("time certified / uncertified (lists: t rounded to nearest / as it comes), and share of rays flagged\n");
    fmt::print("{:24} {:>10} {:>10} {:>10} {:>8} {:>8} {:>8}\n", "scene", "first hit", "lists", "oblique", "-x", "+y",
               "-z");
    for (int i = 1; i < argc; ++i) csgcast::bench::report(argv[i]);
    fmt::print("\nthe same of packets\n{:24} {:>10} {:>10} {:>10}\n", "scene", "first hit", "any hit", "lists");
    for (int i = 1; i < argc; ++i) csgcast::bench::report_lanes(argv[i]);
  } catch (const csgcast::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
