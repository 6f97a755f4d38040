// SPDX-License-Identifier: Apache-2.0
// welkin_talk DIR: writes the geometry of the talk's levels into DIR/walls, DIR/yard and DIR/lamp.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <span>

#include "generate/talk.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

int main(int argc, char** argv) {
  using welkin::base::ExitStatus;
  if (argc != 2) {
    std::fputs("usage: welkin_talk DIR\n", stderr);
    return static_cast<int>(ExitStatus::usage);
  }
  try {
    for (const welkin::talk::TalkLevel& level : welkin::talk::talkLevels()) {
      const std::filesystem::path folder = std::filesystem::path(argv[1]) / level.name;
      welkin::base::makeFolder(folder);
      const std::string name = level.name;
      welkin::base::writeFile(folder / (name + ".bin"), std::span<const std::byte>(level.files.binary));
      welkin::base::writeFile(folder / (name + ".gltf"), level.files.json);
    }
    return static_cast<int>(ExitStatus::done);
  } catch (const welkin::base::Error& error) {
    std::fprintf(stderr, "welkin_talk: %s\n", error.what());
    return static_cast<int>(error.status());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "welkin_talk: %s\n", error.what());
    return static_cast<int>(ExitStatus::internal);
  }
}
