// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <stdexcept>

namespace csgcast {

/// How far a call is.
struct Progress {
  double share = 0;  ///< of the work that is done, in [0, 1]; it never falls within a call
  /// What a volume's error is at present, as a share of the volume: of calls that measure. Infinite: nothing is known.
  std::optional<double> relative_error{};
};

/// Whom a call that takes long tells how far it is. The rules are the same for all calls that take one:
///
/// - It is called now and then, and with the share 1 at the end of a call that was not cancelled.
/// - Any thread of the call may call it, but never two at once. It may itself call csgcast.
/// - If it returns false the call is cancelled: it ends as soon as its threads notice, and throws Cancelled. There is
///   no result then, and the callback is not called again. If it throws, the call ends likewise and throws the same.
/// - An empty callback is allowed: nobody is told.
///
/// Who wants the result as far as it is, rather than none, says so by an option: MeasureOptions::is_enough.
using ProgressCallback = std::function<bool(const Progress&)>;

/// A call was cancelled by its ProgressCallback. That is neither bad input nor a failure, so it is no Error.
class Cancelled : public std::runtime_error {
 public:
  Cancelled();
};

/// Tells a callback by the rules above: what the calls that take one are made with. Any number of threads may use it.
class ProgressTeller {
 public:
  /// The callback must outlive it. `steps`: of how many equal ones the work consists, if step() is used.
  explicit ProgressTeller(const ProgressCallback& callback, std::uint64_t steps = 1);
  ProgressTeller(const ProgressTeller&) = delete;
  ProgressTeller& operator=(const ProgressTeller&) = delete;

  /// Tells that this is done, unless another thread is telling at the moment. A share below one that was told counts as
  /// that one. Throws what the rules say, on every thread that comes here after the end.
  void tell(const Progress& progress);
  /// One more step is done. Throws as tell() does.
  void step();
  /// All is done: tells the share 1 unless it was told. For the thread that made it, when no other is at work.
  void finish();

 private:
  void call(Progress progress);

  const ProgressCallback& callback_;
  const std::uint64_t steps_;
  std::atomic<std::uint64_t> done_ = 0;
  std::atomic<bool> is_telling_ = false;  // whoever sets it may use what follows
  double told_ = -1;
  std::exception_ptr end_;             // what every thread is to throw
  std::atomic<bool> is_over_ = false;  // set after end_, which does not change then
};

}  // namespace csgcast
