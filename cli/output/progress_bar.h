// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace csgcast::cli {

/// A progress bar on standard error: drawn only if that is a terminal, and only once the job has taken a second; wiped
/// out at the end.
class Progress {
 public:
  enum class Show { if_terminal, never };

  Progress(std::string what, Show show);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The share done, in [0, 1]. Cheap: draws ten times a second at most. One thread at a time.
  void update(double done);

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  bool shown_;
  bool drawn_ = false;
  Clock::time_point next_;
};

}  // namespace csgcast::cli
