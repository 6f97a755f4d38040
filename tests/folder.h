// SPDX-License-Identifier: Apache-2.0
// A folder for a test's files, which goes away with everything in it.
#pragma once

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace welkin::tests {

/// A new folder, in the system's place for temporary files unless it is told another.
class Folder {
 public:
  explicit Folder(const std::filesystem::path& parent = std::filesystem::temp_directory_path()) {
    std::string name = (parent / "welkin_test_XXXXXX").string();
#ifdef _WIN32
    const bool made = ::_mktemp(name.data()) != nullptr && std::filesystem::create_directory(name);
#else
    const bool made = ::mkdtemp(name.data()) != nullptr;
#endif
    if (!made) throw std::runtime_error("cannot make a temporary folder");
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const {
    return path_;
  }
  std::string operator/(const std::string& name) const {
    return (path_ / name).string();
  }

  /// Writes a file, its folders included, and returns its path.
  std::string write(const std::string& name, const std::string& bytes) const {
    const std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream stream(file, std::ios::binary);
    stream << bytes;
    stream.close();
    if (!stream) throw std::runtime_error("cannot write " + file.string());
    return file.string();
  }

 private:
  std::filesystem::path path_;
};

inline std::string readBytes(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Flips the lowest bit of one byte, which must exist.
inline void flipBit(const std::filesystem::path& path, std::size_t at) {
  std::string bytes = readBytes(path);
  bytes.at(at) ^= 1;
  std::ofstream(path, std::ios::binary) << bytes;
}

/// Paths of all regular files under a folder, relative to it, sorted.
inline std::vector<std::string> filesUnder(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) names.push_back(std::filesystem::relative(entry.path(), folder).string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace welkin::tests
