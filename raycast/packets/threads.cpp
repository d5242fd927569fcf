// SPDX-License-Identifier: MIT
#include "raycast/packets/threads.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>

#include "csg/base/precondition.h"

namespace csgcast {
namespace {

constexpr int most_threads = 1024;

}  // namespace

void on_threads(int threads, const std::function<void()>& work) {
  CSGCAST_PRECONDITION(threads >= 0);
  if (threads == 0) return work();
  const int count = std::min(threads, most_threads);
  // More threads than cores need permission from oneTBB. For fewer, the arena's own limit is enough.
  std::optional<tbb::global_control> more;
  if (count > tbb::info::default_concurrency())
    more.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
  tbb::task_arena arena(count);
  arena.execute(work);
}

int thread_count() { return tbb::this_task_arena::max_concurrency(); }

}  // namespace csgcast
