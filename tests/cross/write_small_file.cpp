// SPDX-License-Identifier: Apache-2.0
// Writes the sky of the runtime's unit tests for another system, on which nothing bakes.
//   cross_small_file FILE
#include <cstdio>

#include "tests/runtime/small_file.h"

int main(int argc, char** argv) {
  if (argc != 2) return 1;
  const auto& bytes = welkin::tests::smallFile();
  std::FILE* file = std::fopen(argv[1], "wb");
  if (file == nullptr) return 1;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  return std::fclose(file) == 0 && written ? 0 : 1;
}
