// SPDX-License-Identifier: MIT
#include "cli/output/render_stats.h"

#include "cli/output/json.h"
#include "cli/output/scene_summary.h"
#include "raycast/packets/threads.h"

namespace csgcast::cli {

std::string render_stats(const Scene& scene, const RenderOptions& options, const RenderReport& report,
                         const StageSeconds& seconds) {
  std::string out;
  Json json(out);
  json.begin_object();
  json.member("width", std::uint64_t(options.width)).member("height", std::uint64_t(options.height));
  json.member("threads", std::uint64_t(thread_count()));
  json.key("quadrics_by_kind").begin_object(Json::Layout::compact);
  for (const auto& [kind, count] : quadric_kinds(scene)) json.member(kind, count);
  json.end_object();
  json.key("rays").begin_object().member("primary", report.rays.primary).member("shadow", report.rays.shadow);
  json.member("reflection", report.rays.reflection).member("transmission", report.rays.transmission).end_object();
  json.member("refined_pixels", report.refined_pixels);
  json.member("total_reflections", report.total_reflections);
  json.key("packets").begin_object().member("rays", report.packets.rays).member("packets", report.packets.packets);
  json.member("nodes", report.packets.nodes).member("cells", report.packets.cells);
  json.member("surface_tests", report.packets.surface_tests)
      .member("left_to_caster", report.packets.flagged)
      .end_object();
  json.member("surface_tests", report.casts.surface_tests).member("box_tests", report.casts.box_tests);
  json.member("leaf_tests", report.casts.leaf_tests).member("twofold_calls", report.casts.twofold_calls);
  json.member("exact_calls", report.casts.exact_calls).member("rays_flagged", report.casts.rays_flagged);
  json.key("skipped").begin_object();
  json.member("primary_beyond_bounds", report.skipped.primary_beyond_bounds);
  json.member("primary_like_neighbours", report.skipped.primary_like_neighbours);
  json.member("shadow_facing_away", report.skipped.shadow_facing_away);
  json.member("shadow_without_effect", report.skipped.shadow_without_effect);
  json.member("shadow_leading_away", report.skipped.shadow_leading_away);
  json.member("reflection_leading_away", report.skipped.reflection_leading_away);
  json.member("transmission_leading_away", report.skipped.transmission_leading_away);
  json.member("reflection_below_cutoff", report.skipped.reflection_below_cutoff);
  json.member("transmission_below_cutoff", report.skipped.transmission_below_cutoff);
  json.member("depth_limit", report.skipped.depth_limit).end_object();
  json.key("seconds").begin_object().member("read", seconds.read).member("compile", seconds.compile);
  json.member("cells", seconds.cells)
      .member("trace", seconds.trace)
      .member("trace_cpu", report.cpu_seconds)
      .member("write", seconds.write)
      .end_object();
  json.end_object();
  return out + '\n';
}

}  // namespace csgcast::cli
