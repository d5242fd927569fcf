// SPDX-License-Identifier: MIT
#include "tests/contracts/calls.h"

#include <fmt/format.h>

#include <memory>

#include "csg/solid/primitives.h"
#include "measure/check.h"
#include "measure/measure.h"
#include "measure/section.h"
#include "measure/thickness.h"
#include "model/model.h"
#include "shade/trace/render.h"
#include "tests/support/random_solid.h"
#include "verify/verification.h"

namespace csgcast::test {
namespace {

/// Two parts that overlap, and something in neither.
Solid parts() {
  const Solid bored = box({2, 2, 2}, Centering::centered) - cylinder(3, 0.4, 0.5, Centering::centered);
  const Solid ball = transformed(sphere(1), translation({1.5, 0.2, 0.1}));
  return named(bored, {"bored", 2}) + named(ball, {"ball", 1}) + transformed(sphere(0.5), translation({0, 3, 0}));
}

/// The model and what it is asked about.
struct Subject {
  Subject() : model(parts()) {
    RandomSolids random(7);
    for (int i = 0; i < 20000; ++i) {
      const Point o = random.point(3);
      const Vector d = random.direction();
      for (std::size_t axis = 0; axis < 3; ++axis) {
        origins.push_back(o[axis]);
        directions.push_back(d[axis]);
      }
    }
  }

  Rays rays() const { return {origins, directions}; }

  Model model;
  std::vector<double> origins, directions;
};

template <class Numbers>
void append(std::string& text, const Numbers& numbers) {
  for (const auto number : numbers) text += fmt::format("{:a} ", static_cast<double>(number));
  text += '\n';
}

std::string text_of(const Measures& m) {
  return fmt::format("{:a} {:a} {:a} {:a} {:a} {:a} {}\n", m.volume.value, m.volume.error, m.area.value, m.area.error,
                     m.centroid.x, m.inertia[3], m.pieces);
}

std::string text_of(const Film& film) {
  std::string text;
  append(text, film.values());
  return text;
}

Film picture(const Subject& subject, Mode mode, Engine engine, Sampling sampling, int threads,
             const ProgressCallback& progress) {
  RenderOptions options;
  options.width = 100;
  options.height = 70;
  options.samples = 4;
  options.mode = mode;
  options.engine = engine;
  options.sampling = sampling;
  options.threads = threads;
  options.progress = progress;
  SceneDescription description;
  description.camera = CameraDescription{{4, -6, 3}, {0.5, 0.5, 0}, {0, 0, 1}, 40, std::nullopt};
  return render(subject.model.scene(), make_view(description, subject.model.scene(), 100.0 / 70), options);
}

std::string verified(const Subject& subject, int threads, const ProgressCallback& progress) {
  verify::VerificationOptions options;
  options.rays = 100;
  options.threads = threads;
  options.progress = progress;
  std::string text;
  for (const verify::Tally& tally : verify::verify_scene(subject.model.scene(), options).totals())
    text += fmt::format("{} {} {} {}\n", tally.rays, tally.intervals, tally.flagged, tally.wrong);
  return text;
}

QueryOptions query(const ProgressCallback& progress) {
  QueryOptions options;
  options.faces = options.normals = true;
  options.progress = progress;
  return options;
}

}  // namespace

std::vector<LongCall> long_calls() {
  const auto subject = std::make_shared<const Subject>();
  const auto shows = [subject](Mode mode, Engine engine, Sampling sampling) {
    return [=](const ProgressCallback& progress) {
      return text_of(picture(*subject, mode, engine, sampling, 0, progress));
    };
  };
  return {
      {"Model::intervals",
       [subject](const ProgressCallback& progress) {
         const IntervalTable table = subject->model.intervals(subject->rays(), query(progress));
         std::string text;
         append(text, table.offsets);
         append(text, table.t);
         append(text, table.leaves);
         append(text, table.normals);
         return text;
       }},
      {"Model::first_hits",
       [subject](const ProgressCallback& progress) {
         std::string text;
         append(text, subject->model.first_hits(subject->rays(), query(progress)).t);
         return text;
       }},
      {"Model::any_hits",
       [subject](const ProgressCallback& progress) {
         std::string text;
         append(text, subject->model.any_hits(subject->rays(), query(progress)));
         return text;
       }},
      {"Model::locate",
       [subject](const ProgressCallback& progress) {
         std::string text;
         append(text, subject->model.locate(subject->origins, query(progress)));
         return text;
       }},
      {"Model::measure",
       [subject](const ProgressCallback& progress) {
         MeasureOptions options;
         options.progress = progress;
         const SceneMeasures found = subject->model.measure(options);
         std::string text = text_of(found.whole);
         for (const Measures& part : found.parts) text += text_of(part);
         return text;
       }},
      {"measure, of a node",
       [subject](const ProgressCallback& progress) {
         MeasureOptions options;
         options.progress = progress;
         const Scene& scene = subject->model.scene();
         return text_of(measure(scene, scene.parts().front().node, 3, options));
       }},
      {"Model::section",
       [subject](const ProgressCallback& progress) {
         SectionOptions options;
         options.progress = progress;
         const Section found = subject->model.section({{0.1, 0.2, 1}, 0.1}, options);
         return fmt::format("{:a} {:a} {}\n", found.area.value, found.perimeter.value, found.loops.size());
       }},
      {"Model::check",
       [subject](const ProgressCallback& progress) {
         CheckOptions options;
         options.progress = progress;
         const CheckReport found = subject->model.check(options);
         return fmt::format("{} {:a} {}\n", found.overlaps.size(), found.overlaps.at(0).volume.value,
                            found.redundant.size());
       }},
      {"find_thinnest",
       [subject](const ProgressCallback& progress) {
         const auto found = find_thinnest(subject->model.cells(), 40, progress);
         return fmt::format("{:a} {:a}\n", found.value().thickness, found.value().place.x);
       }},
      {"Model::thinnest",
       [subject](const ProgressCallback& progress) {
         return fmt::format("{:a}\n", subject->model.thinnest(40, progress).value().thickness);
       }},
      {"Model::render",
       [subject](const ProgressCallback& progress) {
         RenderOptions options;
         options.width = 100;
         options.height = 70;
         options.progress = progress;
         return text_of(subject->model.render(options));
       }},
      {"render, light", shows(Mode::shaded, Engine::packets, Sampling::regular)},
      {"render, adaptive", shows(Mode::shaded, Engine::packets, Sampling::adaptive)},
      {"render, ray by ray", shows(Mode::shaded, Engine::scalar, Sampling::regular)},
      {"render, lengths", shows(Mode::xray, Engine::packets, Sampling::regular)},
      {"verify_scene", [subject](const ProgressCallback& progress) { return verified(*subject, 0, progress); }},
  };
}

std::vector<CallOnThreads> calls_with_threads() {
  const auto subject = std::make_shared<const Subject>();
  return {{"render",
           [subject](int threads, const ProgressCallback& progress) {
             return text_of(picture(*subject, Mode::shaded, Engine::packets, Sampling::regular, threads, progress));
           }},
          {"verify_scene",
           [subject](int threads, const ProgressCallback& progress) { return verified(*subject, threads, progress); }}};
}

}  // namespace csgcast::test
