// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <sstream>

#include "tests/cli/program.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

namespace {

using namespace csgcast::test;

constexpr const char* scene = "difference() { cube(2, center = true); sphere(r = 1.25); cylinder(h = 3, r = 0.5); }\n";

std::vector<std::string> lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string line; std::getline(stream, line);) result.push_back(line);
  return result;
}

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST_CASE("verify shoots as many rays as were asked for, random and adversarial, and finds nothing wrong") {
  const TemporaryFolder folder;
  folder.write("scene.csg", scene);
  const Outcome outcome = run(folder, {"verify", "scene.csg", "--rays", "300"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  const std::vector<std::string> table = lines(outcome.out);
  REQUIRE(table.size() > 5);
  CHECK(words(table[0]) == std::vector<std::string>{"kind", "of", "rays", "engine", "rays", "intervals", "flagged",
                                                    "exact", "decisions", "wrong"});
  const std::vector<std::string> random = words(table[1]);
  CHECK(random[0] == "random");
  CHECK(random[2] == "300");
  const std::vector<std::string> all = words(table.back());
  CHECK(all[0] == "all");
  CHECK(all[2] == "600");
  CHECK(std::stoi(all[4]) > 100);  // flagged
  CHECK(all.back() == "0");
}

TEST_CASE("verify answers the same on any number of threads, and otherwise for another seed") {
  const TemporaryFolder folder;
  folder.write("scene.csg", scene);
  const auto json = [&](const char* seed, const char* threads) {
    return run(folder,
               {"verify", "scene.csg", "--rays", "200", "--format", "json", "--seed", seed, "--threads", threads})
        .out;
  };
  const std::string first = json("5", "1");
  CHECK(first == json("5", "3"));
  CHECK(first != json("6", "1"));
  CHECK(first.substr(0, 13) == "{\n  \"seed\": 5");
  CHECK(first.find("{\"kind\": \"random\", \"engine\": \"scalar\", \"rays\": 200, \"intervals\": ") !=
        std::string::npos);
  CHECK(first.find("\"mismatches\": []") != std::string::npos);
}

TEST_CASE("verify works on scenes without bounds, without solids, and of any size") {
  const TemporaryFolder folder;
  folder.write("half.csg", "halfspace(n = [1, 2, 3], d = 1e9);");
  folder.write("empty.csg", "");
  folder.write("tiny.csg", "scale(1e-100) { cube(1); sphere(r = 1); }");
  folder.write("huge.csg", "scale(1e100) { cube(1); sphere(r = 1); }");
  for (const char* name : {"half.csg", "empty.csg", "tiny.csg", "huge.csg"}) {
    INFO(name);
    const Outcome outcome = run(folder, {"verify", name, "--rays", "100", "--quiet"});
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    CHECK(words(lines(outcome.out).back()).back() == "0");
  }
}

TEST_CASE("verify shoots fewer rays by itself where a ray takes long") {
  if (is_sanitized) return;  // it works as long as a user may wait, ten times over
  const TemporaryFolder folder;
  std::string text = "union() {\n";
  for (int i = 0; i < 2000; ++i)
    text += "halfspace(n = [1, " + std::to_string(i) + ", 1], d = -" + std::to_string(i) + ");\n";
  folder.write("many.csg", text + "}\n");
  const Outcome outcome = run(folder, {"verify", "many.csg"});
  CHECK(outcome.exit_code == 0);
  CHECK(std::stoi(words(lines(outcome.out).back())[2]) < 4'000);
}

TEST_CASE("verify writes to a file, and says what is wrong with its options") {
  const TemporaryFolder folder;
  folder.write("scene.csg", scene);
  const Outcome written = run(folder, {"verify", "scene.csg", "--rays", "60", "-o", "report.txt"});
  CHECK(written.exit_code == 0);
  CHECK(written.out.empty());
  CHECK(words(lines(folder.read("report.txt")).back())[0] == "all");
  const auto error = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"verify", "scene.csg"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run(folder, arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    return outcome.err;
  };
  CHECK(error({"--rays", "0"}) ==
        "csgcast: error: --rays: '0' is out of range (1 to 1000000000); see csgcast verify --help\n");
  CHECK(error({"--rays", "many"}) == "csgcast: error: --rays: 'many' is no whole number; see csgcast verify --help\n");
  CHECK(error({"--seed", "-1"}) ==
        "csgcast: error: --seed: '-1' is out of range (0 to 2147483647); see csgcast verify --help\n");
  CHECK(error({"--format", "csv"}) ==
        "csgcast: error: --format 'csv' is unknown (known are table|json); see csgcast verify --help\n");
  CHECK(error({"-o", "scene.csg"}).find("scene") != std::string::npos);
  CHECK(run(folder, {"verify", "missing.csg"}).exit_code == 2);
}

}  // namespace
