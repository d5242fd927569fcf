// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/stress/families.h"
#include "verify/comparison.h"

namespace csgcast::stress {

/// What comparing the engines with the exact stage brought, over trials of one family.
struct FamilyOutcome {
  verify::Tally tally;               ///< of the first engine, the definition; `wrong` of all together
  std::uint64_t left_to_caster = 0;  ///< rays that the widest lanes could not decide
  std::uint64_t trials = 0;
  std::vector<std::string> differences;  ///< one line each, with the trial's seed and the ray in hexadecimal
};

/// Trials with the seeds first_seed, first_seed + 1, .. until at least `rays` rays were shot; at least one.
FamilyOutcome run_family(const Family& family, std::uint64_t first_seed, std::uint64_t rays);

}  // namespace csgcast::stress
