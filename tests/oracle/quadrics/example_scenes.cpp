// SPDX-License-Identifier: MIT
#include "tests/oracle/quadrics/example_scenes.h"

#include <algorithm>
#include <filesystem>

#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "raycast/scene/scene.h"
#include "verify/adversarial_rays.h"
#include "verify/random.h"

namespace csgcast::oracle::quadrics {
namespace {

stress::Trial trial_of(const Solid& solid, test::RandomSolids& random, int rays) {
  stress::Trial trial{solid, {}};
  const Scene scene = compile(solid);
  verify::AdversarialRays source(scene);
  verify::Random numbers(random.index(1u << 30));
  const std::size_t kinds = verify::AdversarialRays::kinds().size();
  const std::size_t of_a_kind = std::max<std::size_t>(1, static_cast<std::size_t>(rays) / kinds);
  for (std::size_t kind = 0; kind < kinds; ++kind) source.make(kind, numbers, of_a_kind, trial.rays);
  return trial;
}

}  // namespace

std::vector<stress::Family> example_scenes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(CSGCAST_SOURCE_DIR "/examples")) {
    if (entry.path().extension() == ".csg") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<stress::Family> families;
  for (const auto& file : files) {
    const Solid solid = text::build(text::read_file(file.string())).solid;
    families.push_back({file.filename().string(),
                        [solid](test::RandomSolids& random, int rays) { return trial_of(solid, random, rays); }});
  }
  return families;
}

}  // namespace csgcast::oracle::quadrics
