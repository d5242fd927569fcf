// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/output/format.h"
#include "raycast/line/ray.h"
#include "raycast/ray/hit.h"
#include "raycast/ray/part_overlaps.h"
#include "raycast/scene/scene.h"

namespace csgcast::cli {

/// An interval with what is at its ends; an end that no surface makes (cut off, or infinite) has no face.
struct FacedInterval {
  Interval interval;
  std::optional<EndFace> entry;
  std::optional<EndFace> exit;
  PartId part;  ///< not valid outside every part
};

/// What one ray meets.
struct RayAnswer {
  std::vector<FacedInterval> intervals;
  std::vector<PartOverlap> overlaps;  ///< of which at most IntervalReport::most_overlaps are listed
  std::uint64_t overlap_count = 0;
};

/// Writes the intervals of rays in one format: head, rays in their order, tail.
class IntervalReport {
 public:
  /// The scene must outlive the report; `first` is the number of the first ray.
  IntervalReport(const Scene& scene, Format format, std::uint64_t first = 0)
      : scene_(scene), format_(format), first_(first) {}

  /// What one ray shows of them: of a scene of thousands of parts in one place there are millions.
  static constexpr std::size_t most_overlaps = 1000;

  /// Whether the format tells them, and the scene may have some.
  bool shows_overlaps() const { return format_ != Format::csv && scene_.parts().size() > 1; }
  std::string head() const;
  /// Appends what one ray meets. Safe to call from many threads.
  void append(std::string& out, std::uint64_t index, const Ray& ray, const RayAnswer& answer) const;
  std::string tail() const;

 private:
  void append_csv(std::string& out, std::uint64_t index, const FacedInterval& interval) const;
  void append_json(std::string& out, std::uint64_t index, const Ray& ray, const RayAnswer& answer) const;
  void append_table(std::string& out, std::uint64_t index, const Ray& ray, const RayAnswer& answer) const;
  void append_overlaps(std::string& out, const Ray& ray, const RayAnswer& answer) const;
  std::string solid_place(const std::optional<EndFace>& face) const;
  const std::string* part_name(PartId part) const;

  const Scene& scene_;
  Format format_;
  std::uint64_t first_;
};

}  // namespace csgcast::cli
