// SPDX-License-Identifier: Apache-2.0
// welkin_island DIR: writes the example level, island.gltf and island.bin, into a folder.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <span>

#include "generate/island.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

int main(int argc, char** argv) {
  using welkin::base::ExitStatus;
  if (argc != 2) {
    std::fputs("usage: welkin_island DIR\n", stderr);
    return static_cast<int>(ExitStatus::usage);
  }
  try {
    const std::filesystem::path folder = argv[1];
    welkin::base::makeFolder(folder);
    const welkin::island::GltfFiles files = welkin::island::islandFiles();
    welkin::base::writeFile(folder / "island.bin", std::span<const std::byte>(files.binary));
    welkin::base::writeFile(folder / "island.gltf", files.json);
    return static_cast<int>(ExitStatus::done);
  } catch (const welkin::base::Error& error) {
    std::fprintf(stderr, "welkin_island: %s\n", error.what());
    return static_cast<int>(error.status());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "welkin_island: %s\n", error.what());
    return static_cast<int>(ExitStatus::internal);
  }
}
