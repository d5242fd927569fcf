// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "shade/trace/render.h"

namespace csgcast::cli {

struct StageSeconds {
  double read = 0;
  double compile = 0;
  double cells = 0;
  double trace = 0;
  double write = 0;
};

/// What `render --stats` writes, as JSON. Called where the picture was made: it tells how many threads there are.
std::string render_stats(const Scene& scene, const RenderOptions& options, const RenderReport& report,
                         const StageSeconds& seconds);

}  // namespace csgcast::cli
