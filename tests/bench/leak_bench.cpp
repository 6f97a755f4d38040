// SPDX-License-Identifier: Apache-2.0
// What thin walls let through, without and with cuts, over all shapes and eight places of each, as docs/probes.md has
// it.
//   leak_bench [SHAPE]
#include <fmt/format.h>
#include <tbb/global_control.h>

#include "sky/base/error.h"
#include "tests/probes/leak_levels.h"

namespace {

using namespace welkin;

constexpr std::uint64_t kPlaces = 8;

void printRow(const std::string& shape) {
  tests::Leak all[2];
  std::size_t dark = 0;
  std::size_t cells = 0, bytes = 0;
  for (std::uint64_t seed = 0; seed < kPlaces; ++seed) {
    const tests::LeakLevel level = tests::leakLevel(shape, seed);
    for (const bool cut : {false, true}) {
      const tests::Leak leak = leakOf(level, cut ? placement::Walls::cut : placement::Walls::ignore);
      tests::Leak& sum = all[cut ? 1 : 0];
      sum.mean += leak.mean / double{kPlaces};
      sum.without += leak.without;
      if (leak.worst > sum.worst) {
        sum.worst = leak.worst;
        sum.worst_at = leak.worst_at;
        sum.bytes = seed;
      }
      if (!cut) continue;
      dark += leak.any ? 0 : 1;
      cells = std::max(cells, leak.cut_cells);
      bytes = std::max(bytes, leak.bytes);
    }
  }
  const tests::LeakPoint& at = all[1].worst_at;
  fmt::print("| {} | {:.3f} | {:.3f} | {:.4f} | {:.4f} | {} | {} | {} |\n", shape, all[0].mean, all[0].worst,
             all[1].mean, all[1].worst, dark, cells, bytes);
  if (all[1].worst > 0.0 || all[1].without > 0)
    fmt::print(stderr, "{}: worst at {:.3f} {:.3f} {:.3f}, normal {:.2f} {:.2f} {:.2f}, push {}, seed {}; {} without\n",
               shape, at.position.x, at.position.y, at.position.z, at.normal.x, at.normal.y, at.normal.z, at.push_m,
               all[1].bytes, all[1].without);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
  fmt::print(
      "| place | mean, before | worst, before | mean | worst | dark, of 8 | cut cells, at most | bytes, at most |\n");
  fmt::print("|---|---|---|---|---|---|---|---|\n");
  for (const std::string& shape : welkin::tests::leakShapes())
    if (argc < 2 || shape.find(argv[1]) != std::string::npos) printRow(shape);
  return 0;
} catch (const welkin::base::Error& e) {
  fmt::print(stderr, "{}\n", e.what());
  return 1;
}
