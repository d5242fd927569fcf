// SPDX-License-Identifier: MIT
#pragma once

#include <ctime>

namespace csgcast::bench {

/// Processor time of this thread since it was made: what else the machine does costs nothing.
class Stopwatch {
 public:
  double seconds() const { return now() - start_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double start_ = now();
};

}  // namespace csgcast::bench
