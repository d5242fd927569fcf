// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace csgcast {

/// Threads. One rule holds for every call of the libraries that shares its work among threads: it works on the threads
/// of the oneTBB arena that it is called in, by default one for each core that the process may use. What it returns
/// does not depend on their number. Whoever wants another number calls it by on_threads(), or in a tbb::task_arena; an
/// option `threads` means the same as on_threads().

/// Calls `work` in an arena of that many threads, at most 1024; 0: in the present one. More threads than cores are
/// possible. Throws what `work` throws.
void on_threads(int threads, const std::function<void()>& work);

/// How many threads the present arena has.
int thread_count();

}  // namespace csgcast
