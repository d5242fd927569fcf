// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"
#include "tests/support/effort.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace csgcast::test {
namespace {

constexpr unsigned patience_seconds = is_sanitized ? 240 : 60;

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

struct Pipe {
  std::array<int, 2> ends{-1, -1};
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int reads() const { return ends[0]; }
  int writes() const { return ends[1]; }
  void close_end(std::size_t end) {
    if (ends[end] >= 0) ::close(ends[end]);
    ends[end] = -1;
  }
};

/// In the child: becomes the program.
[[noreturn]] void become_program(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                                 const RunOptions& options, const std::array<int, 3>& files) {
  for (int i = 0; i < 3; ++i) ::dup2(files[static_cast<std::size_t>(i)], i);
  if (!options.standard_output.empty()) ::dup2(::open(options.standard_output.c_str(), O_WRONLY), STDOUT_FILENO);
  if (options.largest_file) {
    const rlimit limit{*options.largest_file, *options.largest_file};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ::alarm(patience_seconds);
  if (::chdir(folder.root().c_str()) != 0) ::_exit(127);
  const std::string& program = options.program.empty() ? std::string(CSGCAST_PROGRAM) : options.program;
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  ::execv(program.c_str(), argv.data());
  ::_exit(127);
}

/// Waits until there is an unfinished file in the folder, for ten seconds at most.
void signal_when_writing(const TemporaryFolder& folder, pid_t child, int signal_number) {
  const auto unfinished = [](const std::string& name) { return name.starts_with(".csgcast-"); };
  for (int i = 0; i < 1000; ++i) {
    const std::vector<std::string> names = folder.names();
    if (std::any_of(names.begin(), names.end(), unfinished)) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ::kill(child, signal_number);
}

/// Feeds standard input and collects what comes out until both outputs end.
void converse(Pipe& input, Pipe& output, Pipe& errors, const RunOptions& options, Outcome& outcome) {
  std::string_view to_write = options.input;
  if (to_write.empty() && !options.signal_while_writing) input.close_end(1);
  const auto collect = [](Pipe& pipe, std::string& text) {
    std::array<char, 1 << 16> buffer{};
    const ssize_t got = ::read(pipe.reads(), buffer.data(), buffer.size());
    if (got > 0) text.append(buffer.data(), static_cast<std::size_t>(got));
    if (got <= 0) pipe.close_end(0);
  };
  while (output.reads() >= 0 || errors.reads() >= 0) {
    std::array<pollfd, 3> files{{{output.reads(), POLLIN, 0},
                                 {errors.reads(), POLLIN, 0},
                                 {to_write.empty() ? -1 : input.writes(), POLLOUT, 0}}};
    ::poll(files.data(), files.size(), -1);
    if (files[0].revents != 0) collect(output, outcome.out);
    if (files[1].revents != 0) collect(errors, outcome.err);
    if (options.reader_goes_away && !outcome.out.empty()) output.close_end(0);
    if (files[2].revents == 0 || to_write.empty()) continue;
    const ssize_t written = ::write(input.writes(), to_write.data(), to_write.size());
    if (written > 0) to_write.remove_prefix(static_cast<std::size_t>(written));
    if (written < 0 || (to_write.empty() && !options.signal_while_writing)) input.close_end(1);
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "csgcast-test-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void TemporaryFolder::write(const std::string& name, std::string_view content) const {
  std::ofstream(path(name), std::ios::binary) << content;
}

std::string TemporaryFolder::read(const std::string& name) const {
  std::ifstream stream(path(name), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

Outcome run(const TemporaryFolder& folder, const std::vector<std::string>& arguments, const RunOptions& options) {
  std::signal(SIGPIPE, SIG_IGN);  // a program that does not read its input is no reason for the test to end
  Pipe input;
  Pipe output;
  Pipe errors;
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process");
  if (child == 0) become_program(folder, arguments, options, {input.reads(), output.writes(), errors.writes()});
  input.close_end(0);
  output.close_end(1);
  errors.close_end(1);
  if (options.signal_while_writing) signal_when_writing(folder, child, *options.signal_while_writing);
  Outcome outcome;
  converse(input, output, errors, options, outcome);
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.seconds = std::min(wall, seconds(usage.ru_utime) + seconds(usage.ru_stime));
  return outcome;
}

}  // namespace csgcast::test
