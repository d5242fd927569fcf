// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/oracle/subject.h"
#include "tests/support/random_solid.h"

namespace csgcast::oracle {

/// What was compared in one family, and what was found.
struct Tally {
  std::uint64_t models = 0;
  std::uint64_t points = 0;
  std::array<std::uint64_t, 3> located{};  ///< by Location, as the oracle says
  std::uint64_t mesh_verdicts = 0;         ///< points on which Side_of_triangle_mesh had a say
  std::uint64_t rays = 0;
  std::uint64_t intervals = 0;
  std::uint64_t ends = 0;         ///< made by a surface: its id, and that t is the nearest double
  std::uint64_t exact_calls = 0;  ///< decisions for which the product needed exact arithmetic
  std::uint64_t wrong = 0;
  std::vector<std::string> complaints;  ///< the first few

  void complain(std::string text);
};

/// How much of one family to check.
struct Workload {
  std::uint64_t points;
  std::uint64_t rays;
};

/// The workload asked for: 1,000,000 points and 100,000 rays a family if the environment has CSGCAST_LONG=1, else 3/100
/// of that.
Workload workload();

/// Makes one random model.
using ModelMaker = std::function<Model(test::RandomSolids&)>;

/// Compares models of the family until the workload is done: compiled planes, points against exact signs and
/// Side_of_triangle_mesh, rays against exact rational lists, over the ray, the whole line and spans that begin or end
/// near (often exactly at) a crossing.
Tally check_family(const ModelMaker& make, std::uint64_t seed, Workload work);

/// One line of counts.
std::string summary(const std::string& family, const Tally& tally);

}  // namespace csgcast::oracle
