// SPDX-License-Identifier: MIT
#pragma once

namespace csgcast::cli {

/// From now on the process takes its unfinished files along (WholeFile) when it dies of Ctrl-C, SIGTERM or SIGHUP. What
/// the parent had ignored, as nohup does, stays ignored.
void remove_files_if_interrupted();

}  // namespace csgcast::cli
