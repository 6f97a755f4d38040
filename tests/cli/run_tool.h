// SPDX-License-Identifier: Apache-2.0
// Runs the welkin program and reports how it ended.
#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/folder.h"

namespace welkin::tests {

/// The result of a run.
struct Run {
  int status = 0;  ///< exit status; minus the signal that ended it; kHung when it was still running at the deadline
  std::string out, err;
  double seconds = 0.0;

  bool said(const std::string& part) const { return err.find(part) != std::string::npos; }
};
inline constexpr int kHung = -1000;

struct Setting {
  std::vector<std::pair<std::string, std::string>> environment;  ///< added to this process's
  std::string out_path, err_path;                                ///< instead of the files that Run reads
  long largest_file = 0;                                         ///< RLIMIT_FSIZE, bytes; 0: no limit
  double deadline_s = 120.0;
};

/// The program while it runs.
class Tool {
 public:
  explicit Tool(const std::vector<std::string>& arguments, const Setting& setting = {});
  Tool(const Tool&) = delete;
  Tool& operator=(const Tool&) = delete;
  ~Tool();

  /// Whether the program ended within the time.
  bool endsWithin(double seconds);
  void send(int signal) const;
  /// Waits for its end, at most until the deadline.
  Run wait();

 private:
  Folder folder_;
  Setting setting_;
  pid_t pid_ = -1;
  bool ended_ = false;
  int wait_status_ = 0;
  double start_s_;
};

inline Run runTool(const std::vector<std::string>& arguments, const Setting& setting = {}) {
  return Tool(arguments, setting).wait();
}

}  // namespace welkin::tests
