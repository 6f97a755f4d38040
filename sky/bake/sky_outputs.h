// SPDX-License-Identifier: Apache-2.0
// The files that a sky's bake writes, and what their names are.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace welkin::bake {

/// File name of the cubemap of a time, without suffix: SKY_HHMMSSmmm, to the nearest millisecond.
std::string cubemapName(double time_h, const std::string& sky = "sky");

/// Writes outputs, and lists them for record and report.
class SkyOutputs {
 public:
  explicit SkyOutputs(std::filesystem::path folder) : folder_(std::move(folder)) {}

  const std::filesystem::path& folder() const { return folder_; }
  /// Of each "file", "bytes" and "xxh3_128".
  const nlohmann::ordered_json& list() const { return list_; }

  /// Lists what will be written later.
  void add(const std::string& name, std::span<const std::byte> bytes);
  void write(const std::string& name, std::span<const std::byte> bytes);

 private:
  std::filesystem::path folder_;
  nlohmann::ordered_json list_ = nlohmann::ordered_json::array();
};

/// Removes cubemaps of earlier bakes of a sky that a finished one, whose outputs are listed, has not.
void removeLeftovers(const std::filesystem::path& folder, const std::string& sky,
                     const nlohmann::ordered_json& outputs);

}  // namespace welkin::bake
