// SPDX-License-Identifier: MIT
#include "cli/output/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace csgcast::cli {
namespace {

constexpr auto patience = std::chrono::seconds(1);
constexpr auto pause = std::chrono::milliseconds(100);
constexpr int bar_width = 40;

}  // namespace

ProgressBar::ProgressBar(std::string what, Show show)
    : what_(std::move(what)),
      shown_(show == Show::if_terminal && ::isatty(STDERR_FILENO) == 1),
      next_(Clock::now() + patience) {}

void ProgressBar::update(double done) {
  if (!shown_ || Clock::now() < next_) return;
  next_ = Clock::now() + pause;
  drawn_ = true;
  const double share = std::clamp(done, 0.0, 1.0);
  const int filled = static_cast<int>(share * bar_width);
  fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {:3.0f} %", what_, "", filled, "", bar_width - filled, 100 * share);
  static_cast<void>(std::fflush(stderr));
}

ProgressCallback ProgressBar::callback() {
  if (!shown_) return {};
  return [this](const Progress& progress) {
    update(progress.share);
    return true;
  };
}

ProgressBar::~ProgressBar() {
  if (!drawn_) return;
  fmt::print(stderr, "\r\033[K");
  static_cast<void>(std::fflush(stderr));
}

}  // namespace csgcast::cli
