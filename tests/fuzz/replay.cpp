// SPDX-License-Identifier: Apache-2.0
// Runs a fuzz target over files, and over every file in folders, without libFuzzer. It works with any compiler.
#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <vector>

#include "fuzz.h"

namespace {

void replay(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  welkin::fuzz::require(stream.good() || stream.eof(), "the file can be read");
  std::printf("%s\n", path.c_str());
  std::fflush(stdout);  // the last line names an input that ends the program
  const auto start = std::chrono::steady_clock::now();
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (taken.count() > 2.0) std::printf("slow: %.1f s\n", taken.count());
}

}  // namespace

int main(int count, char** arguments) {
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < count; ++i) {
    if (!std::filesystem::is_directory(arguments[i])) {
      files.emplace_back(arguments[i]);
      continue;
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(arguments[i]))
      if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  welkin::fuzz::require(!files.empty(), "there is something to replay");
  for (const auto& file : files) replay(file);
  std::printf("%zu inputs\n", files.size());
  return 0;
}
