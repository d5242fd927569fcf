// SPDX-License-Identifier: MIT
#pragma once

namespace csgcast::cli {

/// From now on the process removes its unfinished files (WholeFile), and erases the progress bar, when it dies of
/// Ctrl-C, SIGTERM or SIGHUP. A signal that the parent had ignored, as nohup does, stays ignored.
void remove_files_if_interrupted();

}  // namespace csgcast::cli
