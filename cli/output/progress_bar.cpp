// SPDX-License-Identifier: MIT
#include "cli/output/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

namespace csgcast::cli {
namespace {

constexpr auto patience = std::chrono::seconds(1);
constexpr auto pause = std::chrono::milliseconds(100);
constexpr int bar_width = 40;
constexpr double longest = 1e6;  // seconds; who waits longer does not count them

std::atomic<bool> is_drawn = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // a signal handler reads it

}  // namespace

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  const long minutes = (whole + 59) / 60;
  return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

ProgressBar::ProgressBar(std::string what, Show show)
    : what_(std::move(what)),
      shown_(show == Show::if_terminal && ::isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      next_(start_ + patience) {}

void ProgressBar::update(double done) {
  if (!shown_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + pause;
  is_drawn = true;
  const double share = std::clamp(done, 0.0, 1.0);
  const int filled = static_cast<int>(share * bar_width);
  const double left = std::chrono::duration<double>(now - start_).count() * (1 - share) / share;
  fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {:3.0f} %{}\033[K", what_, "", filled, "", bar_width - filled, 100 * share,
             left <= longest ? fmt::format(", {} left", duration_text(left)) : "");
  static_cast<void>(std::fflush(stderr));
}

ProgressCallback ProgressBar::callback() {
  if (!shown_) return {};
  return [this](const Progress& progress) {
    update(progress.share);
    return true;
  };
}

void ProgressBar::erase_drawn() {
  if (!is_drawn.exchange(false)) return;
  constexpr std::string_view erase = "\r\033[K";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, erase.data(), erase.size());
}

ProgressBar::~ProgressBar() { erase_drawn(); }

}  // namespace csgcast::cli
