// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "tests/stress/trial_run.h"

// Compares the engines with exact arithmetic on the families of hard rays, by name and seed. Exits 1 if they differ, 2
// if the command line makes no sense.

namespace {

using namespace csgcast;
using Clock = std::chrono::steady_clock;

struct Request {
  std::vector<std::string> names;
  bool only_list = false;
  std::uint64_t seed = 1;
  std::uint64_t rays = 20'000;
};

/// The families whose name is one of these words, or holds one if no name is.
std::vector<const stress::Family*> chosen(const std::vector<std::string>& words) {
  std::vector<const stress::Family*> found;
  for (const stress::Family& family : stress::families()) {
    bool wanted = words.empty();
    for (const std::string& word : words) wanted = wanted || family.name.find(word) != std::string::npos;
    if (wanted) found.push_back(&family);
  }
  for (const stress::Family& family : stress::families()) {
    if (words.size() == 1 && family.name == words.front()) return {&family};
  }
  return found;
}

void print_line(const std::string& line) {
  std::puts(line.c_str());
  static_cast<void>(std::fflush(stdout));  // a long run is watched
}

int run(const Request& request) {
  const std::vector<const stress::Family*> families = chosen(request.names);
  if (families.empty()) {
    fmt::print(stderr, "stress: error: no family is called so; --list shows them\n");
    return 2;
  }
  if (!request.only_list)
    print_line(fmt::format("{:40} {:>9} {:>10} {:>9} {:>9} {:>12} {:>6} {:>8}", "family", "rays", "intervals",
                           "flagged", "not lanes", "by exact", "wrong", "seconds"));
  std::uint64_t wrong = 0;
  for (const stress::Family* family : families) {
    if (request.only_list) {
      print_line(family->name);
      continue;
    }
    const auto start = Clock::now();
    const stress::FamilyOutcome outcome = stress::run_family(*family, request.seed, request.rays);
    const verify::Tally& tally = outcome.tally;
    print_line(fmt::format("{:40} {:9} {:10} {:9} {:9} {:12} {:6} {:8.1f}", family->name, tally.rays, tally.intervals,
                           tally.flagged, outcome.left_to_caster, tally.exact_decisions, tally.wrong,
                           std::chrono::duration<double>(Clock::now() - start).count()));
    for (const std::string& difference : outcome.differences) print_line("  " + difference);
    wrong += tally.wrong;
  }
  return wrong > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  Request request;
  CLI::App program("Compares the engines with exact arithmetic on families of hard rays.", "stress");
  program.add_option("family", request.names, "Families: a name, or a part of some (default: all)");
  program.add_flag("--list", request.only_list, "Only list their names");
  program.add_option("--seed", request.seed, "The first trial's seed; each trial takes the next")
      ->capture_default_str();
  program.add_option("--rays", request.rays, "Rays a family, at least; 1 is one trial")->capture_default_str();
  try {
    program.parse(argc, argv);
    return run(request);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "stress: error: {}\n", error.what());
    return 1;
  }
}
