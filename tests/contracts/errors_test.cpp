// SPDX-License-Identifier: MIT
#include "csg/base/error.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "csg/file/whole_file.h"
#include "csg/solid/primitives.h"
#include "csg/text/statement/builder.h"
#include "csg/text/syntax/reader.h"
#include "measure/measure.h"
#include "measure/section.h"
#include "measure/section_polylines.h"
#include "measure/section_svg.h"
#include "model/model.h"
#include "model/section_file.h"
#include "raycast/packets/packet_caster.h"
#include "shade/picture/image_file.h"
#include "shade/trace/render.h"
#include "tests/support/catch.h"

namespace {

using namespace csgcast;

/// A call with bad input.
struct BadCall {
  std::string name;
  ErrorCode code;
  std::function<void()> call;
  Place place{};
};

/// To standard output and standard error.
long bytes_printed_by(const std::function<void()>& work) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
  REQUIRE(file);
  static_cast<void>(std::fflush(nullptr));
  const int out = ::dup(STDOUT_FILENO);
  const int err = ::dup(STDERR_FILENO);
  ::dup2(::fileno(file.get()), STDOUT_FILENO);
  ::dup2(::fileno(file.get()), STDERR_FILENO);
  work();
  static_cast<void>(std::fflush(nullptr));
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  ::close(out);
  ::close(err);
  return static_cast<long>(::lseek(::fileno(file.get()), 0, SEEK_END));
}

const Model& model() {
  static const Model ball(sphere(1));
  return ball;
}

void read(const char* text) { text::build(text::read(text, "bad.csg")); }

void draw(const std::function<void(RenderOptions&)>& spoil) {
  RenderOptions options;
  options.width = options.height = 4;
  spoil(options);
  render(model().scene(), make_view({}, model().scene(), 1), options);
}

void ask(std::vector<double> origins, std::vector<double> directions, Span span = {}) {
  QueryOptions options;
  options.span = span;
  model().intervals({origins, directions}, options);
}

void measure_to(double error, double density) {
  MeasureOptions options;
  options.relative_error = error;
  measure(model().scene(), model().scene().root(), density, options);
}

/// One for each function of the libraries that takes what may be bad.
std::vector<BadCall> bad_calls() {
  using enum ErrorCode;
  const double none = NAN;
  return {
      {"a text that breaks off", syntax, [] { read("cube(1"); }, {"bad.csg", 1, 5}},
      {"an unknown statement", unknown_name, [] { read("\n  cuba(1);"); }, {"bad.csg", 2, 3}},
      {"a size that is text", wrong_type, [] { read("cube(\"a\");"); }, {"bad.csg", 1, 6}},
      {"a file that is not there", input_output, [] { text::read_file("no/such.csg"); }, {"no/such.csg", 0, 0}},
      {"a radius that is none", bad_value, [=] { sphere(none); }},
      {"a normal of zero", bad_value,
       [] {
         halfspace({0, 0, 0}, 1);
       }},
      {"a ray without direction", bad_value,
       [] {
         ask({0, 0, 0}, {0, 0, 0});
       }},
      {"a ray that is not finite", bad_value,
       [=] {
         ask({0, none, 0}, {0, 0, 1});
       }},
      {"a ray out of range", limit,
       [] {
         ask({1e200, 0, 0}, {0, 0, 1});
       }},
      {"too few directions", usage,
       [] {
         ask({0, 0, 0}, {});
       }},
      {"half a ray", usage,
       [] {
         ask({0, 0}, {0, 0});
       }},
      {"a span backwards", usage,
       [] {
         ask({0, 0, 0}, {0, 0, 1}, {2, 1});
       }},
      {"a point that is none", bad_value,
       [=] {
         model().locate(std::vector<double>{0, none, 0});
       }},
      {"a density below zero", bad_value, [] { measure_to(1e-3, -1); }},
      {"an error of zero", bad_value, [] { measure_to(0, 1); }},
      {"a section along no plane", bad_value,
       [] {
         section(model().scene(), {{0, 0, 0}, 1});
       }},
      {"a part without a name", bad_value,
       [] {
         named(sphere(1), {"", 1});
       }},
      {"a density that is none", bad_value,
       [=] {
         named(sphere(1), {"a", none});
       }},
      {"a material out of range", bad_value,
       [] {
         Material material;
         material.ior = 0;
         with_look(sphere(1), {material, {}});
       }},
      {"chords of no tolerance", bad_value,
       [] {
         section_polylines(model().section({{0, 0, 1}, 0}), 0);
       }},
      {"a drawing of an unbounded section", usage,
       [] {
         section_svg(section(compile(halfspace({0, 0, 1}, 0)), {{1, 0, 0}, 0}), 1);
       }},
      {"walls by no rays", usage, [] { model().thinnest(0); }},
      {"a leaf that there is not", usage, [] { model().leaf_name(LeafId(7)); }},
      {"a light below zero", bad_value,
       [] {
         LightDescription light;
         light.position = Point{};
         light.intensity = -1;
         model().view(1, {.lights = std::vector{light}});
       }},
      {"an unknown file of a section",
       usage,
       [] {
         write_section(model().scene(), {{0, 0, 1}, 0}, model().section({{0, 0, 1}, 0}), "a.dxf");
       },
       {"a.dxf", 0, 0}},
      {"unknown instructions", usage, [] { PacketCaster::check_instructions("abacus"); }},
      {"a picture without pixels", limit, [] { draw([](RenderOptions& options) { options.width = 0; }); }},
      {"too many samples", limit, [] { draw([](RenderOptions& options) { options.samples = 1'000'000; }); }},
      {"adaptive depths", usage,
       [] {
         draw([](RenderOptions& options) {
           options.sampling = Sampling::adaptive;
           options.mode = Mode::depth;
         });
       }},
      {"an unknown picture", usage, [] { check_image_path("a.stl"); }, {"a.stl", 0, 0}},
      {"a folder that is not there", input_output, [] { WholeFile("no/such/file"); }, {"no/such/file", 0, 0}},
      {"a full disk",
       machine,
       [] {
         WholeFile file("/dev/full");
         file.write(std::string("x"));
       },
       {"/dev/full", 0, 0}},
  };
}

}  // namespace

TEST_CASE("bad input is an Error with its code, place and sentence, and the libraries print nothing") {
  for (const BadCall& bad : bad_calls()) {
    INFO(bad.name);
    bool is_thrown = false;
    try {
      bad.call();
    } catch (const Error& error) {
      is_thrown = true;
      CHECK(error.code() == bad.code);
      CHECK(error.place() == bad.place);
      const std::string text = error.what();
      INFO(text);
      const std::string place = to_string(bad.place);
      CHECK(text.starts_with((place.empty() ? "csgcast" : place) + ": error: "));
      CHECK(text.find('\n') == std::string::npos);
      CHECK(text.find("; ") != std::string::npos);  // what to do
    }
    CHECK(is_thrown);
    CHECK(bytes_printed_by([&] { CHECK_THROWS_AS(bad.call(), Error); }) == 0);
  }
}
