// SPDX-License-Identifier: MIT
// Millions of rays per second, first hits and whole lists, of csgcast and of other programs where their libraries were
// found when this was built: the camera rays of each scene, bare loops on one thread, engines in turn.
// ./dev bench peers writes the standard scenes and calls this.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <iterator>
#include <string>
#include <vector>

#include "tests/bench/peers/engines.h"
#include "tests/bench/peers/peer_scene.h"
#include "tests/bench/peers/rates.h"
#include "tests/bench/peers/report.h"

namespace csgcast::bench {
namespace {

void say_what_is_missing() {
#ifndef CSGCAST_BENCH_EMBREE
  fmt::print(stderr, "Embree was not found when this was built: its rows are left out\n");
#endif
#ifndef CSGCAST_BENCH_VECGEOM
  fmt::print(stderr, "VecGeom was not found when this was built: its rows are left out\n");
#endif
}

void append(Engines& engines, [[maybe_unused]] Engines more) {
  std::move(more.begin(), more.end(), std::back_inserter(engines));
}

Engines all_engines(const PeerScene& scene) {
  Engines engines = csgcast_engines(scene);
#ifdef CSGCAST_BENCH_EMBREE
  append(engines, embree_engines(scene));
#endif
#ifdef CSGCAST_BENCH_VECGEOM
  append(engines, vecgeom_engines(scene));
#endif
  return engines;
}

int run(int argc, char** argv) {
  CLI::App app{"Rates of intersection beside other programs"};
  std::vector<std::string> files;
  std::string csv;
  int side = 512;
  Effort effort;
  app.add_option("scenes", files, "Scene texts")->required();
  app.add_option("--side", side, "side x side rays a scene, rounded up to tiles")->capture_default_str();
  app.add_option("--passes", effort.passes, "Passes, of which the median counts")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seconds", effort.seconds, "An engine that takes longer for a pass gets fewer rays")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--csv", csv, "Write the results to this file, too");
  CLI11_PARSE(app, argc, argv);
  say_what_is_missing();
  std::vector<Rate> rates;
  for (const std::string& file : files) {
    const PeerScene scene = read_peer_scene(file, side);
    fmt::print(stderr, "{}: {} parts\n", scene.name, scene.tree.parts.size());
    const std::vector<Rate> more = measure(scene, all_engines(scene), effort);
    rates.insert(rates.end(), more.begin(), more.end());
    if (!csv.empty()) write_csv(rates, csv);
  }
  fmt::print("{}\n", markdown(rates));
  return 0;
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
