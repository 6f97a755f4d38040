// SPDX-License-Identifier: Apache-2.0
// Draws skies from the whole domain, bakes and opens them, and checks the invariants of tests/sky/always.h. It stops at
// a limit or at a fault, which it prints with the command that repeats it.
//   stress [--count N] [--seconds S] [--seed K] [--instants N] [--index I]
//   --count     stops after this many evaluations, 1,000,000 by default; --seconds: stops after this time
//   --instants  instants of a sky, 10 by default; 100 directions are evaluated at each
//   --index     checks the sky of this index alone and prints its text
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string_view>

#include "look.h"

namespace welkin::stress {
namespace {

struct Options {
  std::string program;
  std::uint64_t count = 1000000;
  double seconds = std::numeric_limits<double>::infinity();
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  Effort effort;
  bool one = false;
};

std::optional<Options> read(int count, char** arguments) {
  Options options;
  options.program = arguments[0];
  for (int i = 1; i < count; i += 2) {
    const std::string_view name = arguments[i];
    if (i + 1 == count) return std::nullopt;
    const char* value = arguments[i + 1];
    if (name == "--count") {
      options.count = std::strtoull(value, nullptr, 10);
    } else if (name == "--seconds") {
      options.seconds = std::strtod(value, nullptr);
      options.count = std::numeric_limits<std::uint64_t>::max();
    } else if (name == "--seed") {
      options.seed = std::strtoull(value, nullptr, 10);
    } else if (name == "--instants") {
      options.effort.instants = std::atoi(value);
    } else if (name == "--index") {
      options.first = std::strtoull(value, nullptr, 10);
      options.one = true;
    } else {
      return std::nullopt;
    }
  }
  return options;
}

/// Totals and largest errors of all skies.
struct Sum {
  std::uint64_t skies = 0, refused = 0, evaluations = 0, steps = 0;
  double bake_error = 0.0, dome_error = 0.0;
  std::uint64_t worst_bake = 0;

  void add(const Outcome& o, std::uint64_t index) {
    ++skies;
    refused += o.refused ? 1 : 0;
    evaluations += o.evaluations;
    steps += o.step_measured ? 1 : 0;
    dome_error = std::max(dome_error, o.dome_error);
    if (o.bake_error > bake_error) worst_bake = index;
    bake_error = std::max(bake_error, o.bake_error);
  }
  void print(double seconds) const {
    fmt::print(
        "{} evaluations of {} skies ({} refused), {} searched for steps, {:.0f} s; largest error of a key {:.2e} of c0 "
        "(index {}), of the runtime's dome {:.2f} of what is allowed\n",
        evaluations, skies, refused, steps, seconds, bake_error, worst_bake, dome_error);
    std::fflush(stdout);
  }
};

int run(const Options& options) {
  using Clock = std::chrono::steady_clock;
  constexpr double kReport_s = 60.0;
  const tests::Folder folder;
  folder.write("stars.ppm", "P3 2 2 255  0 0 0  255 255 255  9 99 9  1 2 3");
  if (options.one) fmt::print("{}", skyFileOf(options.seed, options.first));
  const auto start = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  double reported = 0.0;
  Sum sum;
  for (std::uint64_t index = options.first;; ++index) {
    const Outcome outcome = lookAt(options.seed, index, options.effort, folder);
    sum.add(outcome, index);
    if (options.one) fmt::print("{}", outcome.gradients);
    if (!outcome.fault.empty()) {
      fmt::print(stderr, "{}\nrepeat with: {} --seed {} --instants {} --index {}\n", outcome.fault, options.program,
                 options.seed, options.effort.instants, index);
      return 1;
    }
    if (options.one || sum.evaluations >= options.count || elapsed() >= options.seconds) break;
    if (elapsed() - reported < kReport_s) continue;
    reported = elapsed();
    sum.print(reported);
  }
  sum.print(elapsed());
  return 0;
}

}  // namespace
}  // namespace welkin::stress

int main(int count, char** arguments) {
  const auto options = welkin::stress::read(count, arguments);
  if (!options) {
    fmt::print(stderr, "stress [--count N] [--seconds S] [--seed K] [--instants N] [--index I]\n");
    return 2;
  }
  return welkin::stress::run(*options);
}
