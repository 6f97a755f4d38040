// SPDX-License-Identifier: Apache-2.0
// The one exception of the offline code: a message for the user and the exit status that goes with it.
#pragma once

#include <stdexcept>
#include <string>

namespace welkin::base {

/// Exit statuses of the command line.
enum class ExitStatus {
  done = 0,
  usage = 1,         ///< the command line
  file = 2,          ///< the system or a device refused: missing, unwritable, full; a retry may help
  content = 3,       ///< a file's content is wrong: cut, damaged, foreign, out of its domain
  internal = 4,      ///< a fault of this program
  interrupted = 130  ///< Ctrl-C
};

class Error : public std::runtime_error {
 public:
  Error(ExitStatus status, const std::string& message) : std::runtime_error(message), status_(status) {}
  ExitStatus status() const { return status_; }

 private:
  ExitStatus status_;
};

}  // namespace welkin::base
