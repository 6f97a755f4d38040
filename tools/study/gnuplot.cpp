// SPDX-License-Identifier: Apache-2.0
#include "study/gnuplot.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "sky/base/error.h"

extern char** environ;

namespace welkin::study {
namespace {

[[noreturn]] void fail(const std::string& why) {
  throw base::Error(base::ExitStatus::file, fmt::format("gnuplot: {}", why));
}

/// A file without a name: no pipe, so that neither process waits for the other to read.
class TemporaryFile {
 public:
  TemporaryFile() : file_(std::tmpfile(), &std::fclose) {
    if (!file_) fail(fmt::format("no temporary file: {}", std::strerror(errno)));
  }

  int descriptor() const { return ::fileno(file_.get()); }

  void write(const std::string& text) {
    const bool whole = std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size();
    if (!whole || std::fflush(file_.get()) != 0)
      fail(fmt::format("the script cannot be written to a temporary file: {}", std::strerror(errno)));
    std::rewind(file_.get());
  }

  std::string read() {
    std::rewind(file_.get());
    std::string text;
    std::array<char, 65536> part;
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), file_.get()))
      text.append(part.data(), count);
    return text;
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

/// Starts gnuplot; 0 when there is none on PATH.
pid_t start(const TemporaryFile& in, const TemporaryFile& out, const TemporaryFile& messages) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, messages.descriptor(), STDERR_FILENO);
  // A group of its own: Ctrl-C asks the study to stop, which then waits for the picture.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  std::string name = "gnuplot";
  std::string defaults = "-d";
  const std::array<char*, 3> arguments = {name.data(), defaults.data(), nullptr};
  pid_t process = 0;
  const int error = ::posix_spawnp(&process, name.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) return 0;
  if (error != 0) fail(fmt::format("cannot be started: {}", std::strerror(error)));
  return process;
}

/// The first line that says something; gnuplot repeats the line of the script and points into it.
std::string firstLine(const std::string& messages) {
  std::size_t from = 0;
  while (from < messages.size()) {
    const std::size_t end = std::min(messages.find('\n', from), messages.size());
    const std::string line = messages.substr(from, end - from);
    const std::size_t word = line.find_first_not_of(" \t^");
    if (word != std::string::npos && !line.starts_with("gnuplot>")) return line.substr(word);
    from = end + 1;
  }
  return "it says nothing";
}

}  // namespace

std::optional<std::string> runGnuplot(const std::string& script) {
  TemporaryFile in;
  TemporaryFile out;
  TemporaryFile messages;
  in.write(script);
  const pid_t process = start(in, out, messages);
  if (process == 0) return std::nullopt;
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) fail(std::strerror(errno));
  if (WIFSIGNALED(status)) fail(fmt::format("ended by signal {}", WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0) fail(fmt::format("status {}: {}", WEXITSTATUS(status), firstLine(messages.read())));
  return out.read();
}

}  // namespace welkin::study
