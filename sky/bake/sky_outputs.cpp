// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/sky_outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "sky/base/atomic_file.h"
#include "sky/base/hash.h"
#include "sky/cubemap/cubemap.h"

namespace welkin::bake {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string cubemapName(double time_h, const std::string& sky) {
  const long ms = cubemap::millisecondOf(time_h);
  return fmt::format("{}_{:02}{:02}{:02}{:03}", sky, ms / 3600000, ms / 60000 % 60, ms / 1000 % 60, ms % 1000);
}

void SkyOutputs::add(const std::string& name, std::span<const std::byte> bytes) {
  list_.push_back({{"file", name}, {"bytes", bytes.size()}, {"xxh3_128", base::textOf(base::hashOf(bytes))}});
}

void SkyOutputs::write(const std::string& name, std::span<const std::byte> bytes) {
  base::writeFile(folder_ / name, bytes);
  add(name, bytes);
}

void removeLeftovers(const std::filesystem::path& folder, const std::string& sky, const Json& outputs) {
  static const std::regex kOurs("_[0-9]{9}(_latlong)?\\.exr");
  const auto isOutput = [&](const std::string& name) {
    return std::any_of(outputs.begin(), outputs.end(), [&](const Json& o) { return o["file"] == "cubemaps/" + name; });
  };
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "cubemaps", error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(sky) && std::regex_match(name.substr(sky.size()), kOurs) && !isOutput(name))
      std::filesystem::remove(entry.path(), error);
  }
}

}  // namespace welkin::bake
