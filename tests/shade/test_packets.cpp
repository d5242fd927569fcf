// SPDX-License-Identifier: MIT
#include "shade/render.h"
#include "tests/support/catch.h"
#include "tests/support/examples.h"

using namespace csgcast;

namespace {

Film picture(const SceneDescription& description, const Scene& scene, Engine engine, int samples, int threads,
             RenderReport* report = nullptr) {
  RenderOptions options;
  options.width = 121;
  options.height = 83;
  options.samples = samples;
  options.engine = engine;
  options.threads = threads;
  return render(scene, make_view(description, scene, 121.0 / 83), options, report);
}

}  // namespace

TEST_CASE("packets make the same picture as rays one by one, bit for bit, on any number of threads") {
  for (const std::string& name : test::example_names()) {
    INFO(name);
    const SceneDescription description = test::example(name);
    const Scene scene = compile(description.solid, Welding::derived());
    for (const int threads : {1, 2, 8}) {
      const int samples = threads == 2 ? 9 : 1;
      RenderReport one_by_one;
      const Film expected = picture(description, scene, Engine::scalar, samples, 1, &one_by_one);
      RenderReport report;
      CHECK(picture(description, scene, Engine::packets, samples, threads, &report).values() == expected.values());
      CHECK(report.rays.primary + report.skipped.primary_beyond_bounds == one_by_one.rays.primary);
      CHECK(report.rays.shadow == one_by_one.rays.shadow);
      CHECK(report.rays.reflection == one_by_one.rays.reflection);
      CHECK(report.skipped.shadow_facing_away == one_by_one.skipped.shadow_facing_away);
      CHECK(report.skipped.shadow_without_effect == one_by_one.skipped.shadow_without_effect);
    }
  }
}
