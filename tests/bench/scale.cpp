// SPDX-License-Identifier: MIT
// What a scene costs as it grows: unions of N random balls, and a cube less N, for N = 10, 100 .. 1,000,000, built in
// code. For each, in a process of its own: the seconds that building the solid and compiling it took, with what
// rounding explains welded; microseconds of compiling a leaf; the process's peak of memory; the bytes a leaf that the
// peak and the finished scene come to. Usage: bench_scale [N ..]
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

#include "csg/primitives.h"
#include "raycast/scene.h"

namespace csgcast::bench {
namespace {

constexpr std::size_t most_balls = 1'000'000;

/// Balls in the cube [-1, 1], their sizes such that they overlap now and then whatever their number.
std::vector<Solid> random_balls(std::size_t count) {
  std::mt19937_64 random(7);
  // Six decimals, as files have them.
  const auto number = [&random](double from, double to) {
    const double share = static_cast<double>(random() >> 11) * 0x1p-53;
    return std::round((from + (to - from) * share) * 1e6) / 1e6;
  };
  const double greatest = 0.9 / std::cbrt(static_cast<double>(count));
  std::vector<Solid> balls;
  balls.reserve(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = number(-1, 1), y = number(-1, 1), z = number(-1, 1);
    balls.push_back(transformed(sphere(number(0.3 * greatest, greatest)), translation({x, y, z})));
  }
  return balls;
}

Solid united(std::size_t count) { return unite(random_balls(count)); }

Solid pierced(std::size_t count) {
  std::vector<Solid> solids = random_balls(count);
  solids.insert(solids.begin(), box({2, 2, 2}, Centering::centered));
  return subtract(std::move(solids));
}

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

double bytes_in_use() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}

double peak_bytes() {
  struct rusage usage {};
  getrusage(RUSAGE_SELF, &usage);
  return 1024 * static_cast<double>(usage.ru_maxrss);
}

void report(const char* name, std::size_t count, Solid (*make)(std::size_t)) {
  const double bytes_before = bytes_in_use();
  const double peak_before = peak_bytes();
  const Stopwatch build_watch;
  Solid solid = make(count);
  const double build_seconds = build_watch.seconds();
  const Stopwatch compile_watch;
  const Scene scene = compile(std::move(solid), Welding::derived());
  const double compile_seconds = compile_watch.seconds();
  const auto leaves = static_cast<double>(scene.leaves().size());
  fmt::print("{:12} {:9} {:9.4f} {:9.4f} {:9.3f} {:11.1f} {:11.0f} {:11.0f}\n", name, scene.leaves().size(),
             build_seconds, compile_seconds, 1e6 * compile_seconds / leaves, peak_bytes() / (1 << 20),
             (peak_bytes() - peak_before) / leaves, (bytes_in_use() - bytes_before) / leaves);
}

/// In a process of its own, whose peak no other scene has raised. False if it failed.
bool report_alone(const char* name, std::size_t count, Solid (*make)(std::size_t)) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) return false;
  if (child == 0) {
    report(name, count, make);
    std::fflush(stdout);
    _exit(0);
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && status == 0;
}

int run(const std::vector<std::size_t>& counts) {
  fmt::print("{:12} {:>9} {:>9} {:>9} {:>9} {:>11} {:>11} {:>11}\n", "scene", "leaves", "build s", "compile s",
             "us a leaf", "peak MiB", "peak B/leaf", "scene B/leaf");
  bool good = true;
  for (const std::size_t count : counts) {
    good = report_alone("union", count, united) && good;
    good = report_alone("difference", count, pierced) && good;
  }
  return good ? 0 : 1;
}

}  // namespace
}  // namespace csgcast::bench

int main(int argc, char** argv) {
  std::vector<std::size_t> counts;
  for (int i = 1; i < argc; ++i) counts.push_back(std::strtoul(argv[i], nullptr, 10));
  if (counts.empty()) {
    for (std::size_t n = 10; n <= csgcast::bench::most_balls; n *= 10) counts.push_back(n);
  }
  return csgcast::bench::run(counts);
}
