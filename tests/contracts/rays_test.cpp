// SPDX-License-Identifier: MIT
#include "raycast/packets/ray_arrays.h"

#include <functional>
#include <string>
#include <vector>

#include "csg/solid/primitives.h"
#include "measure/thickness.h"
#include "raycast/packets/packet_caster.h"
#include "tests/support/catch.h"
#include "tests/support/death.h"
#include "tests/support/ray_batch.h"

namespace {

using namespace csgcast;

/// Room for the answers to `count` rays.
struct Room {
  explicit Room(std::size_t count) : numbers(7 * count), ids(3 * count), bytes(4 * count), n(count) {}

  HitArrays hits() {
    return {.state = byte(0), .t = number(0), .surface = id(0), .root = byte(1), .is_inside = byte(2)};
  }
  FaceArrays faces() {
    FaceArrays faces;
    static_cast<HitArrays&>(faces) = hits();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      faces.point[axis] = number(1 + axis);
      faces.normal[axis] = number(4 + axis);
    }
    faces.look = id(1);
    faces.leaf = id(2);
    faces.comes_positive = byte(3);
    return faces;
  }

  std::span<double> number(std::size_t i) { return std::span(numbers).subspan(i * n, n); }
  std::span<std::uint32_t> id(std::size_t i) { return std::span(ids).subspan(i * n, n); }
  std::span<std::uint8_t> byte(std::size_t i) { return std::span(bytes).subspan(i * n, n); }

  std::vector<double> numbers;
  std::vector<std::uint32_t> ids;
  std::vector<std::uint8_t> bytes;
  std::size_t n;
};

/// A function that takes rays as arrays. It answers what a ball of radius 1 does to them.
struct Taker {
  std::string name;
  std::function<std::vector<double>(const RayArrays&, std::size_t room)> ask;
};

std::vector<Taker> takers(const Cells& cells) {
  return {
      {"first_hits",
       [&](const RayArrays& rays, std::size_t count) {
         Room room(count);
         PacketCaster(cells).first_hits(rays, room.hits());
         return std::vector<double>(room.number(0).begin(), room.number(0).end());
       }},
      {"any_hits",
       [&](const RayArrays& rays, std::size_t count) {
         Room room(count);
         PacketCaster(cells).any_hits(rays, room.byte(0));
         return std::vector<double>(room.byte(0).begin(), room.byte(0).end());
       }},
      {"intervals",
       [&](const RayArrays& rays, std::size_t) {
         IntervalBatch batch;
         PacketCaster(cells).intervals(rays, batch);
         std::vector<double> entries;
         for (const Interval& interval : batch.intervals) entries.push_back(interval.entry.t);
         return entries;
       }},
      {"first_faces",
       [&](const RayArrays& rays, std::size_t count) {
         Room room(count);
         PacketCaster(cells).first_faces(rays, room.faces());
         return std::vector<double>(room.number(4).begin(), room.number(4).end());
       }},
      {"ThicknessProbe::first_faces",
       [&](const RayArrays& rays, std::size_t count) {
         std::vector<double> thickness(count);
         ThicknessProbe(cells).first_faces(rays, thickness);
         return thickness;
       }},
      {"ThicknessProbe::all_faces",
       [&](const RayArrays& rays, std::size_t) {
         ThicknessProbe probe(cells);
         probe.all_faces(rays);
         return std::vector<double>{probe.thinnest()->thickness};
       }},
  };
}

}  // namespace

TEST_CASE("every function that takes rays as arrays checks their lengths where preconditions are checked") {
  const Scene scene = compile(sphere(1));
  const Cells cells(scene);
  const test::RayBatch batch({Ray({-3, 0, 0}, {1, 0, 0}), Ray({-5, 0, 0}, {1, 0, 0}), Ray({-2, 0, 0}, {1, 0, 0})});
  const std::vector<std::vector<double>> expected{{2, 4, 1}, {1, 1, 1}, {2, 4, 1}, {-1, -1, -1}, {2, 2, 2}, {2}};
  const std::vector<double> ends(2, 9);
  const std::vector<std::uint32_t> surfaces(3, 0);
  const std::vector<Taker> all = takers(cells);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Taker& taker = all[i];
    INFO(taker.name);
    CHECK(taker.ask(batch.arrays(), batch.size()) == expected[i]);
#if defined(CSGCAST_CHECK_PRECONDITIONS)
    const auto aborts = [&](const std::function<void(RayArrays&)>& spoil, std::size_t room = 3) {
      RayArrays rays = batch.arrays();
      spoil(rays);
      return test::ending_of([&] { taker.ask(rays, room); }).aborted;
    };
    CHECK(aborts([](RayArrays& rays) { rays.origin[1] = rays.origin[1].first(2); }));
    CHECK(aborts([](RayArrays& rays) { rays.direction[2] = rays.direction[2].first(2); }));
    CHECK(aborts([&](RayArrays& rays) { rays.end = ends; }));
    CHECK(aborts([&](RayArrays& rays) { rays.departure = surfaces; }));
    const bool has_room = taker.name == "intervals" || taker.name == "ThicknessProbe::all_faces";
    CHECK(aborts([](RayArrays&) {}, 2) != has_room);
#endif
  }
}
