// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace csgcast::cli {

/// `count` numbers separated by commas, as `--ray 0,0,9,0,0,-1` gives them. Throws UsageError, naming the option, for
/// another count, and for what is no number or not finite.
std::vector<double> parse_numbers(const std::string& option, const std::string& text, std::size_t count);
/// The same for any count.
std::vector<double> parse_numbers(const std::string& option, const std::string& text);

/// One number, maybe infinite. Throws UsageError.
double parse_parameter(const std::string& option, const std::string& text);

/// A whole number in [low, high]. Throws UsageError.
int parse_count(const std::string& option, const std::string& text, int low, int high);

/// Two whole numbers in [low, high] with a mark between them: `800x600`. Throws UsageError.
std::pair<int, int> parse_pair(const std::string& option, const std::string& text, char mark, int low, int high);

}  // namespace csgcast::cli
