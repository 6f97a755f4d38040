// SPDX-License-Identifier: Apache-2.0
// The main of every program of tests. WELKIN_FP_TRAPS in the environment turns traps of arithmetic on.
#define CATCH_CONFIG_RUNNER
#define CATCH_CONFIG_NO_POSIX_SIGNALS  // Catch would take SIGFPE
#include <catch2/catch.hpp>
#include <cstdlib>

#include "fp_traps.h"

int main(int argc, char** argv) {
  Catch::Session session;
  if (std::getenv("WELKIN_FP_TRAPS") != nullptr) welkin::tests::trapFloatingPointFaults();
  return session.run(argc, argv);
}
