// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

#include "csg/base/progress.h"

namespace csgcast::cli {

/// A progress bar on standard error: drawn only if that is a terminal, and only once the job has taken a second; wiped
/// out at the end.
class ProgressBar {
 public:
  enum class Show { if_terminal, never };

  ProgressBar(std::string what, Show show);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// The share done, in [0, 1]. Cheap: draws ten times a second at most. One thread at a time.
  void update(double done);
  /// What a call of the libraries tells the share to. The bar must outlive it.
  ProgressCallback callback();

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  bool shown_;
  bool drawn_ = false;
  Clock::time_point next_;
};

}  // namespace csgcast::cli
