// SPDX-License-Identifier: Apache-2.0
#include "run_tool.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace welkin::tests {
namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Opens a file as the child's descriptor. The child can report a failure only by its exit status.
void redirect(const std::string& path, int flags, int descriptor) {
  const int fd = ::open(path.c_str(), flags, 0600);
  if (fd < 0 || ::dup2(fd, descriptor) < 0) ::_exit(99);
  ::close(fd);
}

}  // namespace

Tool::Tool(const std::vector<std::string>& arguments, const Setting& setting) : setting_(setting), start_s_(now()) {
  std::vector<std::string> words = {WELKIN_TOOL};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const std::string out = setting.out_path.empty() ? folder_ / "out" : setting.out_path;
  const std::string err = setting.err_path.empty() ? folder_ / "err" : setting.err_path;
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("fork failed");
  if (pid_ > 0) return;
  redirect("/dev/null", O_RDONLY, STDIN_FILENO);
  redirect(out, O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
  redirect(err, O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
  for (const auto& [name, value] : setting.environment) ::setenv(name.c_str(), value.c_str(), 1);
  if (setting.largest_file > 0) {
    const auto bytes = static_cast<rlim_t>(setting.largest_file);
    const rlimit limit{bytes, bytes};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(99);
  }
  ::execv(argv[0], argv.data());
  ::_exit(99);
}

Tool::~Tool() {
  if (ended_) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

bool Tool::endsWithin(double seconds) {
  const double end = now() + seconds;
  while (!ended_) {
    if (::waitpid(pid_, &wait_status_, WNOHANG) == pid_) {
      ended_ = true;
      break;
    }
    if (now() > end) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
  return ended_;
}

void Tool::send(int signal) const {
  if (!ended_) ::kill(pid_, signal);
}

Run Tool::wait() {
  Run run;
  if (!endsWithin(setting_.deadline_s))
    run.status = kHung;
  else
    run.status = WIFEXITED(wait_status_) ? WEXITSTATUS(wait_status_) : -WTERMSIG(wait_status_);
  run.seconds = now() - start_s_;
  run.out = readBytes(folder_ / "out");
  run.err = readBytes(folder_ / "err");
  return run;
}

}  // namespace welkin::tests
