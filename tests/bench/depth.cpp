// SPDX-License-Identifier: MIT
// What nesting costs: chains of 60 overlapping balls, each joined to all before it by a union, a difference or an
// intersection in turn, beside flat solids that show as much. One is the same solid, written flat: every ball that is
// joined, within all that intersect it later and less all that are subtracted later. The others are a union of balls
// and a ball less balls: of all their numbers and sizes those that cover as large a share of the picture and have as
// many edges in it. Millions of rays per second of packets on one thread, 512 x 512 rays of one camera, all solids of a
// chain in turn, medians; what a ray costs, in counts that do not drift. Last the medians over all chains, as ratios.
// Usage: bench_depth [CHAINS]
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "csg/base/error.h"
#include "csg/base/length.h"
#include "raycast/packets/packet_caster.h"
#include "raycast/scene/scene.h"
#include "tests/bench/camera_rays.h"
#include "tests/bench/packet_query.h"
#include "tests/bench/random_balls.h"
#include "tests/bench/timed_work.h"
#include "tests/support/chain.h"

namespace csgcast::bench {
namespace {

using test::Link;

constexpr std::size_t operations = 60;
constexpr int side = 512;
constexpr int passes = 9;
constexpr RayQuery queries[] = {RayQuery::first_hit, RayQuery::lists};

CameraDescription view() {
  CameraDescription camera;
  camera.eye = {4, -5, 3.5};
  camera.fov = 30;
  return camera;
}

std::vector<Link> chain(std::uint64_t seed) {
  RandomNumbers random(seed);
  std::vector<Link> links;
  for (std::size_t i = 0; i <= operations; ++i) {
    const Link::Op op = i == 0 ? Link::Op::unite : static_cast<Link::Op>((i - 1) % 3);
    // What intersects is large, or nothing else would be left.
    const bool is_large = op == Link::Op::intersect;
    const Vector center = random.in_cube(is_large ? 0.12 : 0.6);
    links.push_back({op, ball(center, is_large ? 1 : random.between(0.3, 0.5))});
  }
  return links;
}

/// `count` balls about the middle, of a size.
Solid united_balls(std::size_t count, double size) {
  RandomNumbers random(count);
  std::vector<Solid> balls;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector center = size * random.in_cube(0.6);
    balls.push_back(ball(center, size * random.between(0.3, 0.5)));
  }
  return unite(std::move(balls));
}

/// A ball of a size less `count` balls at its surface.
Solid pierced_ball(std::size_t count, double size) {
  RandomNumbers random(count);
  std::vector<Solid> balls{sphere(size)};
  for (std::size_t i = 0; i < count; ++i) {
    const Vector center = size * normalised(random.in_cube(1));
    balls.push_back(ball(center, size * random.between(0.1, 0.3)));
  }
  return subtract(std::move(balls));
}

/// As many balls less as many others farther out.
Solid carved_balls(std::size_t count, double size) {
  RandomNumbers random(count + 1000);  // not those that placed the balls
  std::vector<Solid> balls{united_balls(count, size)};
  for (std::size_t i = 0; i < count; ++i) {
    const Vector center = size * random.in_cube(0.9);
    balls.push_back(ball(center, size * random.between(0.25, 0.4)));
  }
  return subtract(std::move(balls));
}

/// What a solid shows: shares of the rays, and of the neighbours that see two different faces or one and nothing.
struct Sight {
  double covered = 0;
  double edges = 0;
  std::size_t faces = 0;
};

class Subject {
 public:
  Subject(std::string name, Solid solid)
      : name_(std::move(name)), scene_(compile(std::move(solid), Welding::derived())), cells_(scene_) {}

  const std::string& name() const { return name_; }
  const Cells& cells() const { return cells_; }

  Sight sight() const {
    const Camera camera(view(), side, side);
    std::vector<Ray> rays;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) rays.push_back(camera.ray(x + 0.5, y + 0.5));
    }
    std::vector<std::optional<Hit>> hits(rays.size());
    PacketCaster(cells_).first_hits(rays, hits, Rounding::close);
    const auto seen = [&hits](std::size_t i) { return hits[i] ? hits[i]->crossing.surface : SurfaceId(); };
    std::unordered_set<std::uint32_t> faces;
    std::size_t covered = 0, edges = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      covered += hits[i] ? 1 : 0;
      if (hits[i]) faces.insert(seen(i).index());
      edges += i % side + 1 < side && seen(i) != seen(i + 1) ? 1 : 0;
    }
    const auto share = [&hits](std::size_t n) { return static_cast<double>(n) / static_cast<double>(hits.size()); };
    return {share(covered), share(edges), faces.size()};
  }

 private:
  std::string name_;
  Scene scene_;
  Cells cells_;
};

using Family = Solid (*)(std::size_t count, double size);

/// Of a family the solid that covers as much of the picture as is wanted, and has the most similar number of edges.
std::unique_ptr<Subject> like(const Sight& wanted, Family family, const std::string& name) {
  std::unique_ptr<Subject> best;
  double least_off = HUGE_VAL;
  for (std::size_t count = 4; count <= 64; count += 2) {
    std::unique_ptr<Subject> subject;
    double low = 0.2, high = 3;
    for (int step = 0; step < 10; ++step) {
      const double size = 0.5 * (low + high);
      subject = std::make_unique<Subject>(fmt::format("{} {}", name, count), family(count, size));
      (subject->sight().covered < wanted.covered ? low : high) = size;
    }
    const double off = std::fabs(subject->sight().edges - wanted.edges);
    if (off < least_off) best = std::move(subject);
    least_off = std::min(off, least_off);
  }
  return best;
}

/// Millions of rays per second of each subject, taking turns.
std::vector<double> rates(const std::vector<std::unique_ptr<Subject>>& subjects, RayQuery query,
                          const CameraRays& rays) {
  std::vector<std::unique_ptr<PacketCaster>> casters;
  std::vector<TimedWork> works;
  BlockAnswers answers;
  for (const auto& subject : subjects) {
    casters.push_back(std::make_unique<PacketCaster>(subject->cells()));
    works.emplace_back([&caster = *casters.back(), query, &rays, &answers] {
      for (std::size_t begin = 0; begin < rays.size(); begin += CameraRays::block)
        ask(caster, query, Rounding::close, rays.block_at(begin), answers);
    });
  }
  for (int pass = 0; pass < passes; ++pass) {
    for (TimedWork& work : works) work.pass();
  }
  std::vector<double> result;
  for (const TimedWork& work : works) result.push_back(1e-6 * static_cast<double>(rays.size()) / work.seconds());
  return result;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void print_head() {
  fmt::print("{:22} {:>8} {:>8} {:>6} {:>8} {:>7} {:>7} {:>7} {:>8} {:>7} {:>7} {:>7} {:>9}\n", "solid", "covered",
             "edges", "faces", "first", "nodes", "cells", "tests", "lists", "nodes", "cells", "tests", "intervals");
}

void run(std::size_t chains) {
  const CameraRays rays(view(), side);
  std::vector<double> ratios[4][std::size(queries)];  // by rival and query
  print_head();
  for (std::size_t seed = 1; seed <= chains; ++seed) {
    const std::vector<Link> links = chain(seed);
    std::vector<std::unique_ptr<Subject>> subjects;
    subjects.push_back(std::make_unique<Subject>(fmt::format("chain {}", seed), nested(links)));
    const Sight wanted = subjects.front()->sight();
    subjects.push_back(std::make_unique<Subject>("the same, flat", flat(links)));
    subjects.push_back(like(wanted, united_balls, "union of"));
    subjects.push_back(like(wanted, pierced_ball, "ball less"));
    subjects.push_back(like(wanted, carved_balls, "balls less"));
    const std::vector<double> found[] = {rates(subjects, queries[0], rays), rates(subjects, queries[1], rays)};
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      const Sight sight = subjects[i]->sight();
      fmt::print("{:22} {:8.3f} {:8.4f} {:6}", subjects[i]->name(), sight.covered, sight.edges, sight.faces);
      for (std::size_t q = 0; q < std::size(queries); ++q) {
        const WorkPerRay work = work_per_ray(subjects[i]->cells(), queries[q], rays);
        fmt::print(" {:8.1f} {:7.3f} {:7.3f} {:7.3f}", found[q][i], work.nodes, work.cells, work.surface_tests);
        if (queries[q] == RayQuery::lists) fmt::print(" {:9.3f}\n", work.intervals);
        if (i > 0) ratios[i - 1][q].push_back(found[q][0] / found[q][i]);
      }
    }
  }
  fmt::print("\nrays per second of a chain / of a flat solid, medians: first hits, lists\n");
  const char* const names[] = {"the same solid", "union of balls", "ball less balls", "balls less balls"};
  for (std::size_t i = 0; i < std::size(names); ++i)
    fmt::print("{:22} {:8.2f} {:8.2f}\n", names[i], median(ratios[i][0]), median(ratios[i][1]));
}

}  // namespace
}  // namespace csgcast::bench

int main(int argc, char** argv) {
  CLI::App app("What nesting costs.");
  std::size_t chains = 5;
  app.add_option("CHAINS", chains, "how many chains, each beside its flat rivals")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  try {
    csgcast::bench::run(chains);
  } catch (const csgcast::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
