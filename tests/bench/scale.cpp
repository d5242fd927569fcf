// SPDX-License-Identifier: MIT
// What a scene costs as it grows: unions of N random balls, and a cube less N, for N = 10, 100 .. 1,000,000, built in
// code, each in a process of its own. First what making it ready costs: the processor seconds that building the solid,
// compiling it, with what rounding explains welded, and cutting it into cells took; microseconds a leaf; the bytes a
// leaf of the compiled scene and of its cells; the process's peak of memory, without the cells and with them. Then what
// a ray costs packets, first hits and lists (Rounding::close): nanoseconds, and counts that do not drift. The rays are
// those of one camera, whatever N. Last, how much dearer rays are at 1,000,000 balls than at 1,000.
// Usage: bench_scale [N ..] [--csv FILE]; tests/bench/scale_plot.py draws the file.
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "csg/solid/primitives.h"
#include "raycast/packets/packet_caster.h"
#include "raycast/scene/scene.h"
#include "tests/bench/camera_rays.h"
#include "tests/bench/packet_query.h"
#include "tests/bench/random_balls.h"
#include "tests/bench/timed_work.h"

namespace csgcast::bench {
namespace {

constexpr std::size_t most_balls = 1'000'000;
constexpr int rays_per_side = 1024;
constexpr std::size_t lists_stride = 7;  // of blocks, odd: not all in one column; lists of all would take minutes
constexpr int passes = 5;

/// Balls in the cube [-1, 1], their sizes such that they overlap now and then whatever their number.
std::vector<Solid> random_balls(std::size_t count) {
  RandomNumbers random(7);
  const double greatest = 0.9 / std::cbrt(static_cast<double>(count));
  std::vector<Solid> balls;
  balls.reserve(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const Vector center = random.in_cube(1);
    balls.push_back(ball(center, random.between(0.3 * greatest, greatest)));
  }
  return balls;
}

Solid united(std::size_t count) { return unite(random_balls(count)); }

Solid pierced(std::size_t count) {
  std::vector<Solid> solids = random_balls(count);
  solids.insert(solids.begin(), box({2, 2, 2}, Centering::centered));
  return subtract(std::move(solids));
}

double bytes_in_use() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}

double peak_bytes() {
  struct rusage usage {};
  getrusage(RUSAGE_SELF, &usage);
  return 1024 * static_cast<double>(usage.ru_maxrss);
}

struct RayCosts {
  double nanoseconds = 0;
  WorkPerRay work;
};

/// What a child process measures and its parent tells.
struct Costs {
  double leaves = 0;
  double build_seconds = 0;
  double compile_seconds = 0;
  double cells_seconds = 0;
  double scene_bytes = 0;
  double cells_bytes = 0;
  double compile_peak = 0;  // bytes
  double peak = 0;
  RayCosts first_hit;
  RayCosts lists;
};

CameraRays view_of_the_cube() {
  CameraDescription camera;
  camera.eye = {4, -5, 3.5};
  camera.fov = 30;
  return {camera, rays_per_side};
}

void measure_rays(const Cells& cells, Costs& costs) {
  const CameraRays rays = view_of_the_cube();
  PacketCaster caster(cells);
  BlockAnswers answers;
  const auto work = [&](RayQuery query, std::size_t stride) {
    return TimedWork([&rays, &caster, &answers, query, stride] {
      for (std::size_t begin = 0; begin < rays.size(); begin += stride * CameraRays::block)
        ask(caster, query, Rounding::close, rays.block_at(begin), answers);
    });
  };
  TimedWork first_hits = work(RayQuery::first_hit, 1), lists = work(RayQuery::lists, lists_stride);
  for (int pass = 0; pass < passes; ++pass) {
    first_hits.pass();
    lists.pass();
  }
  const double nanoseconds = 1e9 / static_cast<double>(rays.size());
  costs.first_hit = {nanoseconds * first_hits.seconds(), work_per_ray(cells, RayQuery::first_hit, rays)};
  costs.lists = {nanoseconds * lists_stride * lists.seconds(), work_per_ray(cells, RayQuery::lists, rays)};
}

Costs measure(std::size_t count, Solid (*make)(std::size_t)) {
  Costs costs;
  const double bytes_before = bytes_in_use();
  const ProcessWatch build_watch;
  Solid solid = make(count);
  costs.build_seconds = build_watch.seconds();
  const ProcessWatch compile_watch;
  const Scene scene = compile(std::move(solid), Welding::derived());
  costs.compile_seconds = compile_watch.seconds();
  costs.leaves = static_cast<double>(scene.leaves().size());
  costs.scene_bytes = bytes_in_use() - bytes_before;
  costs.compile_peak = peak_bytes();
  const ProcessWatch cells_watch;
  const Cells cells(scene);
  costs.cells_seconds = cells_watch.seconds();
  costs.cells_bytes = static_cast<double>(cells.counts().bytes);
  costs.peak = peak_bytes();
  measure_rays(cells, costs);
  return costs;
}

/// In a process of its own, whose peak no other scene has raised. None if it failed.
std::optional<Costs> measure_alone(std::size_t count, Solid (*make)(std::size_t)) {
  static_cast<void>(std::fflush(stdout));  // or the child would print it again
  int ends[2];
  if (pipe(ends) != 0) return std::nullopt;
  const pid_t child = fork();
  if (child == 0) {
    const Costs costs = measure(count, make);
    _exit(write(ends[1], &costs, sizeof costs) == sizeof costs ? 0 : 1);
  }
  close(ends[1]);
  Costs costs;
  const bool is_read = child > 0 && read(ends[0], &costs, sizeof costs) == sizeof costs;
  close(ends[0]);
  int status = 0;
  if (child > 0) waitpid(child, &status, 0);
  return is_read && status == 0 ? std::optional(costs) : std::nullopt;
}

struct Row {
  std::string scene;
  std::size_t balls = 0;
  Costs costs;
};

void print_build_head() {
  fmt::print("{:10} {:>8} {:>8} {:>9} {:>8} {:>8} {:>8} {:>12} {:>12} {:>11} {:>8}\n", "scene", "leaves", "build s",
             "compile s", "us/leaf", "cells s", "us/leaf", "scene B/leaf", "cells B/leaf", "compile MiB", "peak MiB");
}

void print_build(const Row& row) {
  const Costs& c = row.costs;
  fmt::print("{:10} {:8.0f} {:8.4f} {:9.4f} {:8.3f} {:8.4f} {:8.3f} {:12.0f} {:12.0f} {:11.1f} {:8.1f}\n", row.scene,
             c.leaves, c.build_seconds, c.compile_seconds, 1e6 * c.compile_seconds / c.leaves, c.cells_seconds,
             1e6 * c.cells_seconds / c.leaves, c.scene_bytes / c.leaves, c.cells_bytes / c.leaves,
             c.compile_peak / (1 << 20), c.peak / (1 << 20));
}

void print_rays(const std::vector<Row>& rows) {
  fmt::print("\n{}x{} rays, lanes of {}; nodes, cells, surface tests, intervals a ray\n", rays_per_side, rays_per_side,
             PacketCaster::instruction_sets().front());
  fmt::print("{:10} {:>8} {:>9} {:>7} {:>7} {:>7} {:>7} {:>9} {:>7} {:>7} {:>7} {:>9} {:>7}\n", "scene", "leaves",
             "first ns", "nodes", "cells", "tests", "left %", "lists ns", "nodes", "cells", "tests", "intervals",
             "left %");
  for (const Row& row : rows) {
    const WorkPerRay& first = row.costs.first_hit.work;
    const WorkPerRay& lists = row.costs.lists.work;
    fmt::print(
        "{:10} {:8.0f} {:9.1f} {:7.3f} {:7.3f} {:7.3f} {:7.4f} {:9.1f} {:7.3f} {:7.3f} {:7.3f} {:9.3f} {:7.4f}\n",
        row.scene, row.costs.leaves, row.costs.first_hit.nanoseconds, first.nodes, first.cells, first.surface_tests,
        100 * first.left_to_caster, row.costs.lists.nanoseconds, lists.nodes, lists.cells, lists.surface_tests,
        lists.intervals, 100 * lists.left_to_caster);
  }
}

/// How much dearer a ray is among 1,000,000 balls than among 1,000, if both were measured.
void print_growth(const std::vector<Row>& rows, const std::string& scene, double most) {
  const auto find = [&](std::size_t balls) {
    return std::find_if(rows.begin(), rows.end(),
                        [&](const Row& row) { return row.scene == scene && row.balls == balls; });
  };
  const auto few = find(1'000), many = find(1'000'000);
  if (few == rows.end() || many == rows.end()) return;
  const RayCosts &first_few = few->costs.first_hit, &first_many = many->costs.first_hit;
  const RayCosts &lists_few = few->costs.lists, &lists_many = many->costs.lists;
  fmt::print("{}: a ray from 1,000 to 1,000,000: first hit x {:.2f} (at most x {} is wanted), ", scene,
             first_many.nanoseconds / first_few.nanoseconds, most);
  fmt::print("lists x {:.2f}, and the intervals in them x {:.2f}\n", lists_many.nanoseconds / lists_few.nanoseconds,
             lists_many.work.intervals / lists_few.work.intervals);
}

void write_csv(const std::vector<Row>& rows, std::ostream& file) {
  const auto ray_names = [](const char* query) {
    return fmt::format(",{0}_ns,{0}_nodes,{0}_cells,{0}_surface_tests,{0}_left,{0}_intervals", query);
  };
  const auto ray_numbers = [](const RayCosts& c) {
    return fmt::format(",{},{},{},{},{},{}", c.nanoseconds, c.work.nodes, c.work.cells, c.work.surface_tests,
                       c.work.left_to_caster, c.work.intervals);
  };
  file << "scene,balls,leaves,build_s,compile_s,cells_s,scene_bytes,cells_bytes,compile_peak_bytes,peak_bytes"
       << ray_names("first") << ray_names("lists") << "\n";
  for (const Row& row : rows) {
    const Costs& c = row.costs;
    file << fmt::format("{},{},{},{},{},{},{},{},{},{}", row.scene, row.balls, c.leaves, c.build_seconds,
                        c.compile_seconds, c.cells_seconds, c.scene_bytes, c.cells_bytes, c.compile_peak, c.peak)
         << ray_numbers(c.first_hit) << ray_numbers(c.lists) << "\n";
  }
}

int measure_all(const std::vector<std::size_t>& counts, const std::string& csv) {
  const std::pair<const char*, Solid (*)(std::size_t)> kinds[] = {{"union", united}, {"difference", pierced}};
  std::ofstream file(csv);
  if (!csv.empty() && !file) throw std::runtime_error("cannot write " + csv);
  std::vector<Row> rows;
  bool good = true;
  print_build_head();
  for (const std::size_t count : counts) {
    for (const auto& [scene, make] : kinds) {
      const std::optional<Costs> costs = measure_alone(count, make);
      if (!costs) fmt::print(stderr, "{} of {}: failed\n", scene, count);
      good = good && costs;
      if (costs) print_build(rows.emplace_back(Row{scene, count, *costs}));
    }
  }
  print_rays(rows);
  fmt::print("\n");
  print_growth(rows, "union", 8);
  print_growth(rows, "difference", 4);
  if (!csv.empty()) write_csv(rows, file);
  if (!csv.empty() && !file.flush()) throw std::runtime_error("cannot write " + csv);
  return good ? 0 : 1;
}

int run(int argc, char** argv) {
  CLI::App app("What a scene costs as it grows.");
  std::vector<std::size_t> counts;
  std::string csv;
  app.add_option("N", counts, "numbers of balls; 10, 100 .. 1,000,000 unless given")->check(CLI::PositiveNumber);
  app.add_option("--csv", csv, "writes all that was measured to this file");
  CLI11_PARSE(app, argc, argv);
  if (counts.empty()) {
    for (std::size_t n = 10; n <= most_balls; n *= 10) counts.push_back(n);
  }
  return measure_all(counts, csv);
}

}  // namespace
}  // namespace csgcast::bench

int main(int argc, char** argv) {
  try {
    return csgcast::bench::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
