// SPDX-License-Identifier: MIT
#include "csg/base/progress.h"

#include <algorithm>

#include "csg/base/precondition.h"

namespace csgcast {

Cancelled::Cancelled() : std::runtime_error("cancelled by the progress callback") {}

ProgressTeller::ProgressTeller(const ProgressCallback& callback, std::uint64_t steps)
    : callback_(callback), steps_(steps) {}

void ProgressTeller::tell(const Progress& progress) {
  if (!callback_) return;
  if (is_over_.load(std::memory_order_acquire)) std::rethrow_exception(end_);
  // There is no mutex, because a callback that works on several threads may be given another piece of this call's work
  // meanwhile.
  if (is_telling_.exchange(true, std::memory_order_acquire)) return;
  call(progress);
  is_telling_.store(false, std::memory_order_release);
  if (is_over_.load(std::memory_order_acquire)) std::rethrow_exception(end_);
}

void ProgressTeller::call(Progress progress) {
  if (is_over_.load(std::memory_order_relaxed)) return;
  progress.share = std::clamp(progress.share, std::max(told_, 0.0), 1.0);
  told_ = progress.share;
  try {
    if (callback_(progress)) return;
    end_ = std::make_exception_ptr(Cancelled());
  } catch (...) {
    end_ = std::current_exception();
  }
  is_over_.store(true, std::memory_order_release);
}

void ProgressTeller::step() {
  const std::uint64_t done = ++done_;
  CSGCAST_PRECONDITION(done <= steps_);
  tell({static_cast<double>(done) / static_cast<double>(steps_), {}});
}

void ProgressTeller::finish() {
  if (told_ < 1) tell({1, {}});
}

}  // namespace csgcast
