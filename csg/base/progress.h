// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <stdexcept>

namespace csgcast {

/// The progress of a call.
struct Progress {
  double share = 0;  ///< the share of the work that is done, in [0, 1]; it never falls within a call
  /// For calls that measure: the present error of a volume, as a share of the volume. Infinite if nothing is known yet.
  std::optional<double> relative_error{};
};

/// A callback that a long call tells its progress. The rules are the same for all calls that take one:
///
/// - It is called now and then, and with the share 1 at the end of a call that was not cancelled.
/// - Any thread of the call may call it, but two threads never do so at the same time. It may itself call csgcast.
/// - If it returns false the call is cancelled: it ends as soon as its threads notice, and throws Cancelled. There is
///   no result then, and the callback is not called again. If it throws, the call ends likewise and throws the same.
/// - An empty callback is allowed: nobody is told.
///
/// To get the result as far as it is known, and not none, use an option: MeasureOptions::is_enough.
using ProgressCallback = std::function<bool(const Progress&)>;

/// A call was cancelled by its ProgressCallback. This is neither bad input nor a failure, so it is not an Error.
class Cancelled : public std::runtime_error {
 public:
  Cancelled();
};

/// Calls a callback by the rules above. All calls that take one use this class. Any number of threads may use it.
class ProgressTeller {
 public:
  /// The callback must outlive it. `steps` is the number of equal steps of the work, if step() is used.
  explicit ProgressTeller(const ProgressCallback& callback, std::uint64_t steps = 1);
  ProgressTeller(const ProgressTeller&) = delete;
  ProgressTeller& operator=(const ProgressTeller&) = delete;

  /// Reports progress, unless another thread is doing so at the moment. A share below one that was reported counts as
  /// that one. Throws what the rules say, on every thread that comes here after the end.
  void tell(const Progress& progress);
  /// Reports that one more step is done. Throws as tell() does.
  void step();
  /// Reports the share 1, unless that was done. Call it from the thread that made this object, when no other is at
  /// work.
  void finish();

 private:
  void call(Progress progress);

  const ProgressCallback& callback_;
  const std::uint64_t steps_;
  std::atomic<std::uint64_t> done_ = 0;
  std::atomic<bool> is_telling_ = false;  // the thread that sets it may use the following members
  double told_ = -1;
  std::exception_ptr end_;             // the exception that every thread is to throw
  std::atomic<bool> is_over_ = false;  // set after end_, which does not change then
};

}  // namespace csgcast
