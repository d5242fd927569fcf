// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "raycast/packets/layer_caster.h"
#include "raycast/ray/caster.h"
#include "shade/film/view.h"
#include "shade/light/phong.h"
#include "shade/trace/ray_tree.h"
#include "shade/trace/report.h"

namespace csgcast {

/// The recursive tracer of one thread: the light that comes along a ray is what its hit shows by itself (Phong, with
/// shadows), plus what is reflected, plus what is transmitted (docs/shading.md). Never allocates once its memory has
/// grown.
///
/// Written as a stack of rays still to trace, each with the share of its light that reaches the pixel: no depth
/// overflows it.
class Tracer {
 public:
  /// The caster's scene, the caster (which others may use between calls) and the view must outlive the tracer.
  /// `layers`: what finds the first change of medium on a ray faster; null: the caster does. The light is the same, bit
  /// for bit.
  Tracer(Caster& caster, const View& view, LayerCaster* layers = nullptr);

  /// The light that comes along a ray of unit direction. Records every ray in *tree, if given.
  Rgb trace(const Ray& ray, RayTree* tree = nullptr);

  /// A reflected ray of a sample, with the share of its light that counts; how many rays led to it, one after the
  /// other, and the light that these brought.
  struct Reflected {
    Ray ray;
    Departure departure;
    int depth;
    Rgb weight;
    Rgb brought;
  };
  /// The sample's light, traced on from there. Only in scenes without transparent media.
  Rgb trace_on(const Reflected& reflected);

  /// What was done so far, without the caster's own counts.
  const RenderReport& report() const { return report_; }

 private:
  /// What a stretch of a ray runs through. Without a region: nothing.
  struct Medium {
    RegionId region;
    LookId look;
  };
  struct Task {
    RayKind kind;
    int depth;
    Ray ray;
    std::optional<Departure> departure;
    Medium medium;
    Rgb weight;
    bool total = false;
  };
  /// Where a ray ends: a change of medium, or an opaque face.
  struct Boundary {
    double t;
    SurfaceId surface;
    Attribution face;
    Medium before;
    Medium after;
    bool into_opaque;
    bool out_of_opaque;  ///< the ray started inside an opaque solid
  };
  /// A boundary with what its shading needs.
  struct Spot {
    const Boundary& boundary;
    const Material& material;
    Point point;
    Vector normal;  ///< unit, on the viewer's side
    Vector to_viewer;
  };

  Rgb run_all(std::uint64_t rays);
  void run(const Task& task);
  void leave(const Task& task, Fate fate);
  std::optional<Boundary> next_boundary(const Task& task);
  std::optional<Boundary> next_interface(const Task& task);
  Boundary boundary(const Interface& change, const Attribution& face, const Task& task);
  Medium medium(RegionId region, Passage passage, const Interface& where, Medium known);
  Rgb local(const Spot& spot, const Task& task);
  Rgb lit(const Spot& spot, std::size_t light, const Task& task);
  bool leads_away(Point from, const Departure& departure, Vector direction) const;
  Rgb passing(const Spot& spot, const Illumination& from);
  Rgb passing_media(const Spot& spot, const Ray& ray, double unit, Span span);
  template <class LookOf>
  Rgb passing_changes(const Spot& spot, double unit, Span span, LookOf&& look_of);
  void spawn(const Spot& spot, const Task& task);
  void push(RayKind kind, const Spot& spot, const Task& parent, Vector direction, double share, bool total);
  double ior(Medium m) const { return m.look.valid() ? scene_.look(m.look).ior : 1; }
  Rgb absorbed(Medium m, double length) const {
    return m.look.valid() ? transmittance(scene_.look(m.look).absorption, length) : Rgb{1, 1, 1};
  }

  const Scene& scene_;
  const View& view_;
  Caster& caster_;
  LayerCaster* layers_;
  std::vector<Task> pending_;
  std::vector<Interface> interfaces_;
  std::vector<LookId> looks_;  // of their faces
  RenderReport report_;
  RayTree* tree_ = nullptr;
  Rgb sum_;
};

}  // namespace csgcast
