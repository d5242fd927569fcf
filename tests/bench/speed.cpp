// SPDX-License-Identifier: MIT
// Millions of rays per second on one thread, by query and by engine: the scalar caster without cells, one ray in lanes
// at a time, and packets; what a ray costs packets, in counts that do not drift; what making a scene ready takes.
// 512 x 512 rays of each scene's camera. Engines take turns; medians of processor time. Tables in Markdown.
// Usage: bench_speed SCENE.csg ..
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "csg/base/error.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "raycast/packets/packet_caster.h"
#include "raycast/ray/caster.h"
#include "shade/film/view.h"
#include "tests/bench/camera_rays.h"
#include "tests/bench/packet_query.h"
#include "tests/bench/timed_work.h"

namespace csgcast::bench {
namespace {

constexpr int rays_per_side = 512;
constexpr int passes = 7;
constexpr double most_seconds = 0.3;  // of a pass
constexpr RayQuery queries[] = {RayQuery::first_hit, RayQuery::any_hit, RayQuery::lists};

/// Asks about the block of rays that begins at a place.
using Engine = std::function<void(std::size_t begin)>;

struct QueryCosts {
  std::vector<double> rates;  // millions of rays per second of each engine
  WorkPerRay work;
};

struct SceneCosts {
  std::string name;
  std::size_t leaves = 0;
  double compile_seconds = 0;
  double cells_seconds = 0;
  std::size_t cells_bytes = 0;
  QueryCosts queries[std::size(bench::queries)];
};

Engine scalar_engine(Caster& caster, RayQuery query, const CameraRays& rays, IntervalList& list) {
  const auto each = [&rays, &caster](const auto& ask) {
    return [&rays, &caster, ask](std::size_t begin) {
      for (std::size_t i = begin; i < begin + CameraRays::block; ++i) {
        caster.begin(rays.list()[i]);
        ask();
      }
    };
  };
  switch (query) {
    case RayQuery::first_hit:
      return each([&caster] { caster.first_hit(Span{}, Rounding::close); });
    case RayQuery::any_hit:
      return each([&caster] { caster.any_hit(); });
    case RayQuery::lists:
      break;
  }
  return each([&caster, &list] { caster.intervals(list); });
}

Engine lane_engine(PacketCaster& caster, RayQuery query, Rounding rounding, const CameraRays& rays,
                   BlockAnswers& answers) {
  return [&caster, query, rounding, &rays, &answers](std::size_t begin) {
    ask(caster, query, rounding, rays.block_at(begin), answers);
  };
}

/// Every stride-th block of the rays.
void ask_blocks(const Engine& engine, const CameraRays& rays, std::size_t stride) {
  for (std::size_t begin = 0; begin < rays.size(); begin += stride * CameraRays::block) engine(begin);
}

/// Such that a pass takes no longer than it may; odd, so that the blocks do not stand in a column.
std::size_t stride_of(const Engine& engine, const CameraRays& rays) {
  constexpr std::size_t thin = 61;  // a small part of the rays tells
  const ProcessWatch watch;
  ask_blocks(engine, rays, thin);
  return static_cast<std::size_t>(std::ceil(watch.seconds() * thin / most_seconds)) | 1U;
}

/// Millions of rays per second of each engine.
std::vector<double> rates(const std::vector<Engine>& engines, const CameraRays& rays) {
  std::vector<TimedWork> works;
  std::vector<std::size_t> asked;
  for (const Engine& engine : engines) {
    const std::size_t stride = stride_of(engine, rays);
    const std::size_t step = stride * CameraRays::block;
    asked.push_back((rays.size() + step - 1) / step * CameraRays::block);
    works.emplace_back([&engine, &rays, stride] { ask_blocks(engine, rays, stride); });
  }
  for (int pass = 0; pass < passes; ++pass) {
    for (TimedWork& work : works) work.pass();
  }
  std::vector<double> result;
  for (std::size_t i = 0; i < works.size(); ++i)
    result.push_back(1e-6 * static_cast<double>(asked[i]) / works[i].seconds());
  return result;
}

QueryCosts measure(const Cells& cells, RayQuery query, const CameraRays& rays) {
  Caster caster(cells.scene());
  PacketCaster single(cells, PacketCaster::Width::single);
  PacketCaster packets(cells);
  IntervalList list;
  BlockAnswers answers;
  std::vector<Engine> engines{scalar_engine(caster, query, rays, list),
                              lane_engine(single, query, Rounding::close, rays, answers),
                              lane_engine(packets, query, Rounding::close, rays, answers)};
  if (query == RayQuery::lists) engines.push_back(lane_engine(packets, query, Rounding::nearest, rays, answers));
  return {rates(engines, rays), work_per_ray(cells, query, rays)};
}

/// Seconds of making something: the median of some times, or of one if that is long.
double seconds_to_make(const std::function<void()>& make) {
  const ProcessWatch watch;
  make();
  if (const double once = watch.seconds(); once > most_seconds) return once;
  TimedWork work(make);
  for (int pass = 0; pass < passes; ++pass) work.pass();
  return work.seconds();
}

SceneCosts measure(const std::string& file) {
  const SceneDescription description = text::build(text::read_file(file));
  const Scene scene = compile(description.solid, Welding::derived());
  const Cells cells(scene);
  const CameraRays rays(make_view(description, scene, 1).camera, rays_per_side);
  SceneCosts costs;
  costs.name = std::filesystem::path(file).stem().string();
  costs.leaves = scene.leaves().size();
  costs.compile_seconds = seconds_to_make([&description] { compile(description.solid, Welding::derived()); });
  costs.cells_seconds = seconds_to_make([&scene] { const Cells again(scene); });
  costs.cells_bytes = cells.counts().bytes;
  for (const RayQuery query : queries) costs.queries[static_cast<std::size_t>(query)] = measure(cells, query, rays);
  return costs;
}

std::string three_digits(double value) {
  return value >= 100 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

void print_row(const std::string& name, const std::vector<std::string>& numbers) {
  fmt::print("| {} |", name);
  for (const std::string& number : numbers) fmt::print(" {} |", number);
  fmt::print("\n");
}

void print_head(const std::string& title, const std::vector<std::string>& columns) {
  fmt::print("\n{}:\n\n", title);
  print_row("scene", columns);
  fmt::print("|---|");
  for (std::size_t i = 0; i < columns.size(); ++i) fmt::print("---:|");
  fmt::print("\n");
}

void print_rates(const char* title, RayQuery query, const std::vector<SceneCosts>& scenes) {
  std::vector<std::string> columns{"caster", "one lane", "packets"};
  if (query == RayQuery::lists) columns.emplace_back("packets, nearest");
  columns.insert(columns.end(), {"nodes a ray", "cells a ray", "surface tests a ray", "left to caster"});
  if (query == RayQuery::lists) columns.emplace_back("intervals a ray");
  print_head(title, columns);
  for (const SceneCosts& scene : scenes) {
    const QueryCosts& costs = scene.queries[static_cast<std::size_t>(query)];
    std::vector<std::string> numbers;
    for (const double rate : costs.rates) numbers.push_back(three_digits(rate));
    for (const double count : {costs.work.nodes, costs.work.cells, costs.work.surface_tests})
      numbers.push_back(three_digits(count));
    numbers.push_back(fmt::format("{:.2g} %", 100 * costs.work.left_to_caster));
    if (query == RayQuery::lists) numbers.push_back(three_digits(costs.work.intervals));
    print_row(scene.name, numbers);
  }
}

void print_build(const std::vector<SceneCosts>& scenes) {
  print_head("Build", {"leaves", "compile, ms", "cells, ms", "cells, bytes"});
  for (const SceneCosts& scene : scenes) {
    print_row(scene.name, {fmt::format("{}", scene.leaves), three_digits(1e3 * scene.compile_seconds),
                           three_digits(1e3 * scene.cells_seconds), fmt::format("{}", scene.cells_bytes)});
  }
}

void run(const std::vector<std::string>& files) {
  std::vector<SceneCosts> scenes;
  for (const std::string& file : files) {
    scenes.push_back(measure(file));
    fmt::print(stderr, "{} is measured\n", scenes.back().name);
  }
  fmt::print("Millions of rays per second, one thread, lanes of {}; t is not rounded (Rounding::close)\n",
             PacketCaster::instruction_sets().front());
  print_rates("First hit", RayQuery::first_hit, scenes);
  print_rates("Any hit", RayQuery::any_hit, scenes);
  print_rates("Lists", RayQuery::lists, scenes);
  print_build(scenes);
}

}  // namespace
}  // namespace csgcast::bench

int main(int argc, char** argv) {
  try {
    csgcast::bench::run({argv + 1, argv + argc});
  } catch (const csgcast::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
