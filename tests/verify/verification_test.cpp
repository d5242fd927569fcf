// SPDX-License-Identifier: MIT
#include "verify/verification.h"

#include <array>
#include <cmath>
#include <numeric>

#include "tests/support/catch.h"
#include "tests/verify/models.h"

using namespace csgcast;
using verify::Answers;
using verify::EngineKind;
using verify::Question;
using verify::VerificationReport;

namespace {

VerificationReport report_of(const Scene& scene, std::uint64_t rays, int threads = 2,
                             std::span<const EngineKind> kinds = verify::engines()) {
  verify::VerificationOptions options;
  options.rays = rays;
  options.threads = threads;
  return verify::verify_scene(scene, options, kinds);
}

const EngineKind uncertified{
    "uncertified", [](verify::Subject& s) { return verify::scalar_engine(s.scene(), uncertified_predicates()); }};

// The right engine, but for one answer.
template <Question question>
class Liar final : public verify::Engine {
 public:
  explicit Liar(const Scene& scene) : honest_(verify::scalar_engine(scene, certified_predicates())) {}

  void answer(std::span<const Ray> rays, std::span<Answers> answers) override {
    honest_->answer(rays, answers);
    for (Answers& a : answers) lie(a);
  }

 private:
  static void lie(Answers& a) {
    if (question == Question::any_hit) a.any_hit = !a.any_hit;
    if (question == Question::first_hit && a.first_hit)
      a.first_hit->crossing.t = std::nextafter(a.first_hit->crossing.t, 9);
    if (question == Question::ray && !a.ray.empty()) a.ray.pop_back();
    if (question == Question::line && !a.line.empty()) a.line[0].exit.t = std::nextafter(a.line[0].exit.t, 1e9);
    if (question == Question::reversed && !a.reversed.empty()) a.reversed[0].entry.surface = SurfaceId(7777);
  }

  std::unique_ptr<verify::Engine> honest_;
};

template <Question question>
void check_caught(const Scene& scene) {
  const EngineKind kind{"liar", [](verify::Subject& s) { return std::make_unique<Liar<question>>(s.scene()); }};
  const VerificationReport report = report_of(scene, 60, 1, std::span(&kind, 1));
  CHECK(report.totals()[0].wrong > 20);
  REQUIRE(report.mismatches.size() == 10);
  for (const verify::FoundMismatch& found : report.mismatches) CHECK(found.mismatch.question == question);
}

}  // namespace

TEST_CASE("verification finds no fault with the engines of the product, on scenes with ties, curves and slivers") {
  for (const char* name : {"flush", "angel"}) {
    INFO(name);
    const VerificationReport report = report_of(test::example(name), 400);
    for (const verify::Tally& tally : report.totals()) {
      CHECK(tally.wrong == 0);
      CHECK(tally.rays == 800);
      CHECK(tally.intervals > 200);
      CHECK(tally.flagged > 100);
    }
    CHECK(report.mismatches.empty());
    CHECK(report.kinds.front().kind == "random");
    CHECK(report.kinds.front().tallies.front().rays == 400);
  }
}

TEST_CASE("verification finds no fault on scenes at the limits") {
  for (const test::Model& model : test::hostile_models()) {
    INFO(model.name);
    const VerificationReport report = report_of(compile(model.solid), 60);
    for (const verify::Tally& tally : report.totals()) {
      CHECK(tally.wrong == 0);
      CHECK(tally.rays >= 90);
    }
  }
}

TEST_CASE("plain floating point is caught, and each mismatch comes with a ray that shows it") {
  for (const char* name : {"flush", "angel"}) {
    INFO(name);
    const Scene scene = test::example(name);
    const VerificationReport report = report_of(scene, 400, 2, std::span(&uncertified, 1));
    CHECK(report.totals()[0].wrong > 50);
    REQUIRE(report.mismatches.size() == 10);
    verify::Comparison again(scene, std::span(&uncertified, 1));
    for (const verify::FoundMismatch& found : report.mismatches) {
      verify::Tally tally;
      std::vector<verify::Mismatch> mismatches;
      again.compare(std::span(&found.mismatch.ray, 1), std::span(&tally, 1), mismatches, 1);
      REQUIRE(mismatches.size() == 1);
      CHECK(mismatches[0].difference == found.mismatch.difference);
    }
  }
}

TEST_CASE("a lie about any one of the questions is caught") {
  const Scene scene = compile(test::varied_solid(1));
  check_caught<Question::any_hit>(scene);
  check_caught<Question::first_hit>(scene);
  check_caught<Question::ray>(scene);
  check_caught<Question::line>(scene);
  check_caught<Question::reversed>(scene);
}

TEST_CASE("engines are tallied one by one") {
  const std::array kinds{verify::engines().front(), uncertified};
  const VerificationReport report = report_of(test::example("flush"), 200, 2, kinds);
  CHECK(report.engines == std::vector<std::string_view>{verify::engines().front().name, "uncertified"});
  const std::vector<verify::Tally> totals = report.totals();
  CHECK(totals[0].wrong == 0);
  CHECK(totals[0].flagged > 0);
  CHECK(totals[1].wrong > 0);
  CHECK(totals[1].flagged == 0);
  for (const verify::FoundMismatch& found : report.mismatches) CHECK(found.mismatch.engine == "uncertified");
}

TEST_CASE("the report is the same on any number of threads") {
  const Scene scene = test::example("angel");
  const std::array kinds{verify::engines().front(), uncertified};
  const VerificationReport one = report_of(scene, 300, 1, kinds);
  const VerificationReport four = report_of(scene, 300, 4, kinds);
  REQUIRE(one.kinds.size() == four.kinds.size());
  for (std::size_t i = 0; i < one.kinds.size(); ++i) {
    CHECK(one.kinds[i].kind == four.kinds[i].kind);
    CHECK(one.kinds[i].tallies == four.kinds[i].tallies);
  }
  REQUIRE(one.mismatches.size() == four.mismatches.size());
  for (std::size_t i = 0; i < one.mismatches.size(); ++i) {
    CHECK(one.mismatches[i].mismatch.difference == four.mismatches[i].mismatch.difference);
    CHECK(interval_options(one.mismatches[i].mismatch) == interval_options(four.mismatches[i].mismatch));
  }
}

TEST_CASE("a mismatch is shown by options with numbers that read back to the same ray") {
  const Ray ray({0.1, -1e-300, 1.0 / 3}, {-2.5, 0, 0x1p-400});
  const auto options = [&](Question question) { return verify::interval_options({ray, "scalar", question, ""}); };
  CHECK(options(Question::first_hit) == "--ray=0.1,-1e-300,0.3333333333333333,-2.5,0,3.8725919148493183e-121");
  CHECK(options(Question::line) == "--line --ray=0.1,-1e-300,0.3333333333333333,-2.5,0,3.8725919148493183e-121");
  CHECK(options(Question::reversed) == "--line --ray=0.1,-1e-300,0.3333333333333333,2.5,0,-3.8725919148493183e-121");
}

TEST_CASE("fewer rays are moderate where a ray meets very many surfaces") {
  CHECK(verify::moderate_ray_count(test::example("angel")) == 10'000);
  CHECK(verify::moderate_ray_count(compile({})) == 10'000);
  std::vector<Solid> many;
  for (int i = 0; i < 3000; ++i) many.push_back(halfspace({1, 1e-3 * i, 0}, i));
  const std::uint64_t few = verify::moderate_ray_count(compile(intersect(many)));
  CHECK(few >= 20);
  CHECK(few < 2'000);
}
