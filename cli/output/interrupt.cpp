// SPDX-License-Identifier: MIT
#include "cli/output/interrupt.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>

namespace csgcast::cli {
namespace {

// A signal handler has nothing but globals; it reads the path only while `armed` is set, and the path changes only
// while it is not.
std::array<char, 4096> unfinished;
std::atomic<bool> armed = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void remove_and_die(int signal_number) {
  if (armed.load()) ::unlink(unfinished.data());
  static_cast<void>(std::signal(signal_number, SIG_DFL));
  static_cast<void>(std::raise(signal_number));
}

void handle(int signal_number) {
  // What the parent had ignored, as nohup does, stays ignored.
  if (std::signal(signal_number, remove_and_die) == SIG_IGN) static_cast<void>(std::signal(signal_number, SIG_IGN));
}

}  // namespace

void remove_if_interrupted(const std::string& path) {
  if (path.size() >= unfinished.size()) return;
  armed.store(false);
  *std::copy(path.begin(), path.end(), unfinished.begin()) = '\0';
  armed.store(true);
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) handle(signal_number);
}

void keep_if_interrupted() { armed.store(false); }

}  // namespace csgcast::cli
