// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

#include "csg/base/progress.h"

namespace csgcast::cli {

/// A progress bar on standard error, with the time that is left. It is drawn only if that is a terminal and the job has
/// taken a second, and erased at the end.
class ProgressBar {
 public:
  enum class Show { if_terminal, never };

  ProgressBar(std::string what, Show show);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// The share done, in [0, 1]. Cheap: draws ten times a second at most. One thread at a time.
  void update(double done);
  /// The callback that tells the bar how far a call of the libraries is. The bar must outlive it.
  ProgressCallback callback();

  /// Erases the bar that is drawn, if one is. A signal handler may call it.
  static void erase_drawn();

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  bool shown_;
  Clock::time_point start_;
  Clock::time_point next_;
};

/// `3 s`, `2 min 5 s`, `1 h 20 min`: rounded up to whole seconds, from an hour on to whole minutes.
std::string duration_text(double seconds);

}  // namespace csgcast::cli
