// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <utility>
#include <vector>

namespace csgcast::bench {

/// Processor time of this process, all its threads, since it was made: what else the machine does costs nothing.
class ProcessWatch {
 public:
  double seconds() const { return now() - start_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double start_ = now();
};

/// Work that is timed in passes, so that rivals can take turns. It is called as often in a pass as makes that long
/// enough to be timed.
class TimedWork {
 public:
  explicit TimedWork(std::function<void()> work) : work_(std::move(work)) {
    constexpr double least_seconds = 0.05;
    work_();  // untimed: memory grows
    const ProcessWatch watch;
    work_();
    repeats_ = static_cast<int>(std::ceil(least_seconds / std::max(watch.seconds(), 1e-6)));
  }

  void pass() {
    const ProcessWatch watch;
    for (int i = 0; i < repeats_; ++i) work_();
    seconds_.push_back(watch.seconds() / repeats_);
  }

  /// Seconds of one call: the median of the passes.
  double seconds() const {
    std::vector<double> sorted = seconds_;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }

 private:
  std::function<void()> work_;
  int repeats_ = 1;
  std::vector<double> seconds_;
};

}  // namespace csgcast::bench
