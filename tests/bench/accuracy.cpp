// SPDX-License-Identifier: MIT
// Run time against error, family by family: ways of computing in the same caster, and first hits of POV-Ray and
// (where it was found when this was built) Embree. Writes CSV; run.py makes tables and plots of it.
// Usage: bench_accuracy OUTPUT.csv FOLDER RAYS_PER_FAMILY [FAMILY ..]      files for POV-Ray are written to FOLDER
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/bench/accuracy/ball_families.h"
#include "tests/bench/accuracy/measure.h"
#include "tests/bench/accuracy/povray.h"
#include "tests/bench/accuracy/sample.h"
#ifdef CSGCAST_BENCH_EMBREE
#include "tests/bench/accuracy/embree_balls.h"
#endif

namespace csgcast::bench {
namespace {

constexpr int rays_per_scene = 100;

// Those of the names, or all.
std::vector<stress::Family> families(const std::vector<std::string>& names) {
  std::vector<stress::Family> list(stress::families().begin(), stress::families().end());
  list.insert(list.end(), ball_families().begin(), ball_families().end());
  if (!names.empty()) {
    std::erase_if(list, [&names](const stress::Family& family) {
      return std::find(names.begin(), names.end(), family.name) == names.end();
    });
  }
  return list;
}

void write(std::ofstream& file, const Measurement& m) {
  const auto optional = [](const auto& number) { return number ? std::to_string(*number) : std::string(); };
  file << fmt::format("\"{}\",{},{},{},{},{},{},{:.3g},{:.3g},{:.1f}\n", m.family, m.way, m.query, m.rays, m.wrong,
                      optional(m.clear_rays), optional(m.wrong_clear), m.ulps_99, m.ulps_most, m.nanoseconds)
       << std::flush;
}

void run(const std::filesystem::path& output, const std::filesystem::path& folder, int rays,
         const std::vector<std::string>& names) {
  std::ofstream file(output);
  if (!file) throw std::runtime_error("cannot write " + output.string());
  file << "family,way,query,rays,wrong,clear_rays,wrong_clear,ulps_99,ulps_most,nanoseconds\n";
  for (const stress::Family& family : families(names)) {
    fmt::print(stderr, "{}\n", family.name);
    const std::vector<Sample> samples = make_samples(family, rays, rays_per_scene);
    for (const Measurement& m : measure_ways(family.name, samples)) write(file, m);
    for (const Measurement& m : measure_exact(family.name, samples)) write(file, m);
    if (const auto hits = ask_povray(samples, folder)) write(file, judge(family.name, "POV-Ray", samples, *hits));
#ifdef CSGCAST_BENCH_EMBREE
    if (const auto hits = ask_embree(samples)) write(file, judge(family.name, "Embree", samples, *hits));
#endif
  }
}

}  // namespace
}  // namespace csgcast::bench

int main(int argc, char** argv) {
  if (argc < 4) {
    fmt::print(stderr, "usage: bench_accuracy OUTPUT.csv FOLDER RAYS_PER_FAMILY [FAMILY ..]\n");
    return 2;
  }
  try {
    csgcast::bench::run(argv[1], argv[2], std::stoi(argv[3]), {argv + 4, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
