// SPDX-License-Identifier: Apache-2.0
// The committed levels of the talk are what their generator writes.
#include "generate/talk.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>

#include "sky/base/atomic_file.h"

namespace welkin::talk {

TEST_CASE("TalkLevels, GeneratorWritesTheCommittedBytes") {
  for (const TalkLevel& level : talkLevels()) {
    CAPTURE(level.name);
    const std::filesystem::path file = std::filesystem::path(TALK_FOLDER) / level.name / level.name;
    const std::vector<std::byte> json = base::readFile(file.string() + ".gltf");
    const bool is_same_json =
        json.size() == level.files.json.size() && std::memcmp(json.data(), level.files.json.data(), json.size()) == 0;
    CHECK(is_same_json);
    const bool is_same_binary = base::readFile(file.string() + ".bin") == level.files.binary;
    CHECK(is_same_binary);
  }
}

}  // namespace welkin::talk
