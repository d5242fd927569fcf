// SPDX-License-Identifier: MIT
#include "raycast/simd/instruction_set.h"

#include <hwy/targets.h>

#include <catch2/catch.hpp>

#include "raycast/packets/packet_caster.h"

using csgcast::InstructionSet;
using csgcast::PacketCaster;

// Highway's own look at the processor.
TEST_CASE("The machine's instruction sets are those that Highway finds") {
  const auto found = hwy::SupportedTargets();
  CHECK(has(InstructionSet::sse4) == ((found & HWY_SSE4) != 0));
  CHECK(has(InstructionSet::avx2) == ((found & HWY_AVX2) != 0));
  CHECK(has(InstructionSet::avx512) == ((found & HWY_AVX3) != 0));
}

TEST_CASE("The best instruction set that the machine has comes first") {
  const auto sets = PacketCaster::instruction_sets();
  REQUIRE_FALSE(sets.empty());
  CHECK(sets.back() == "baseline");
  CHECK((sets.front() == "AVX-512") == has(InstructionSet::avx512));
}
