// SPDX-License-Identifier: MIT
#include "tests/bench/peers/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace csgcast::bench {
namespace {

// Without repeats. Not all scenes have all engines: a new one goes right after the one before it.
std::vector<std::string> engine_names(const std::vector<Rate>& rates) {
  std::vector<std::string> names;
  std::ptrdiff_t after = 0;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    if (i > 0 && (rates[i].scene != rates[i - 1].scene || rates[i].query != rates[i - 1].query)) after = 0;
    auto found = std::find(names.begin(), names.end(), rates[i].engine);
    if (found == names.end()) found = names.insert(names.begin() + after, rates[i].engine);
    after = found - names.begin() + 1;
  }
  return names;
}

std::vector<std::string> scene_names(const std::vector<Rate>& rates) {
  std::vector<std::string> names;
  for (const Rate& rate : rates) {
    if (std::find(names.begin(), names.end(), rate.scene) == names.end()) names.push_back(rate.scene);
  }
  return names;
}

// Millions of rays a second, three digits of them, and the share of wrong answers in brackets if there are any.
std::string cell(const Rate& rate) {
  const double millions = rate.rays_per_second * 1e-6;
  const std::string number = millions >= 10 ? fmt::format("{:.1f}", millions) : fmt::format("{:.3g}", millions);
  const std::size_t wrong = rate.wrong_count + rate.wrong_t;
  if (wrong == 0) return number;
  return fmt::format("{} ({:.2g} %)", number, 100 * static_cast<double>(wrong) / static_cast<double>(rate.rays));
}

std::string table(const std::vector<Rate>& rates, Query query) {
  std::string text = "| engine |";
  std::string rule = "\n|---|";
  for (const std::string& scene : scene_names(rates)) {
    text += " " + scene + " |";
    rule += "---:|";
  }
  text += rule + "\n";
  for (const std::string& engine : engine_names(rates)) {
    std::string row = "| " + engine + " |";
    bool empty = true;
    for (const std::string& scene : scene_names(rates)) {
      const auto found = std::find_if(rates.begin(), rates.end(), [&](const Rate& rate) {
        return rate.query == query && rate.engine == engine && rate.scene == scene;
      });
      row += found == rates.end() ? " |" : " " + cell(*found) + " |";
      empty = empty && found == rates.end();
    }
    if (!empty) text += row + "\n";
  }
  return text;
}

}  // namespace

std::string markdown(const std::vector<Rate>& rates) {
  return fmt::format(
      "First hits, millions of rays a second (in brackets: wrong answers):\n\n{}\n"
      "All intervals, millions of rays a second (in brackets: wrong answers):\n\n{}",
      table(rates, Query::first_hit), table(rates, Query::intervals));
}

void write_csv(const std::vector<Rate>& rates, const std::filesystem::path& path) {
  std::ofstream file(path);
  file << "scene,engine,query,rays_per_second,rays,wrong_count,wrong_t\n";
  for (const Rate& rate : rates) {
    file << fmt::format("{},\"{}\",{},{:.6g},{},{},{}\n", rate.scene, rate.engine,
                        rate.query == Query::first_hit ? "first hit" : "intervals", rate.rays_per_second, rate.rays,
                        rate.wrong_count, rate.wrong_t);
  }
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace csgcast::bench
