// SPDX-License-Identifier: MIT
#include "cli/output/interrupt.h"

#include <csignal>

#include "cli/output/progress_bar.h"
#include "csg/file/whole_file.h"

namespace csgcast::cli {
namespace {

extern "C" void remove_and_die(int signal_number) {
  ProgressBar::erase_drawn();
  remove_unfinished_files();
  static_cast<void>(std::signal(signal_number, SIG_DFL));
  static_cast<void>(std::raise(signal_number));
}

}  // namespace

void remove_files_if_interrupted() {
  for (const int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    if (std::signal(signal_number, remove_and_die) == SIG_IGN) static_cast<void>(std::signal(signal_number, SIG_IGN));
  }
}

}  // namespace csgcast::cli
