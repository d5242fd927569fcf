// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace csgcast {

/// One rule about threads holds for every call of the libraries that shares its work among threads. The call works on
/// the threads of the oneTBB arena in which it is called, by default one for each core that the process may use. Its
/// results do not depend on their number. To use another number, call it through on_threads(), or in a tbb::task_arena.
/// An option `threads` has the same meaning as for on_threads().

/// Calls `work` in an arena of that many threads, at most 1024. If the number is 0, it uses the present arena. There
/// may be more threads than cores. Throws what `work` throws.
void on_threads(int threads, const std::function<void()>& work);

/// The number of threads of the present arena.
int thread_count();

}  // namespace csgcast
