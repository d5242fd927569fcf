// SPDX-License-Identifier: MIT
#include "raycast/surface/line_crossings.h"

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "tests/support/catch.h"

using namespace csgcast;

TEST_CASE("numbers kept of one line stay as they are until the line is another one") {
  LineMemory memory;
  std::vector<std::span<double>> rooms;
  for (std::size_t count = 3; count <= 600; count += 3) {  // more than a block holds, too
    rooms.push_back(memory.room_for(count));
    REQUIRE(rooms.back().size() == count);
    std::iota(rooms.back().begin(), rooms.back().end(), static_cast<double>(1000 * count));
  }
  for (const std::span<double> room : rooms) {
    for (std::size_t i = 0; i < room.size(); ++i) REQUIRE(room[i] == static_cast<double>(1000 * room.size() + i));
  }
}

TEST_CASE("the memory of one line serves the next one") {
  LineMemory memory;
  const double* const first = memory.room_for(5).data();
  CHECK(memory.room_for(5).data() != first);
  memory.forget();
  CHECK(memory.room_for(5).data() == first);
}

TEST_CASE("the places of up to two crossings are told, and of more") {
  LineMemory memory;
  LineCrossings found;
  found.count = 2;
  found.few = {-1, 4};
  CHECK(found.tau(0) == -1);
  CHECK(found.tau(1) == 4);

  const std::span<double> three = memory.room_for(3);
  three[0] = -2;
  three[1] = 0.5;
  three[2] = 7;
  found.count = 3;
  found.many = three;
  const CrossingView last{SurfaceId(0), nullptr, &found, 2};
  CHECK(found.tau(0) == -2);
  CHECK(found.tau(1) == 0.5);
  CHECK(last.tau() == 7);
  CHECK(found.positive_after(3) != found.positive_before);
}
