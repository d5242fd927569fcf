// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/peers/rates.h"

namespace csgcast::bench {

/// Markdown: one table for each query, a row for each engine, a column for each scene.
std::string markdown(const std::vector<Rate>& rates);

/// The same and more, a line for each rate. Throws std::runtime_error if it cannot be written.
void write_csv(const std::vector<Rate>& rates, const std::filesystem::path& path);

}  // namespace csgcast::bench
