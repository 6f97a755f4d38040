// SPDX-License-Identifier: Apache-2.0
#include "probes/gltf/gltf_buffers.h"

#include <fmt/format.h>

#include <cstring>

#include "probes/gltf/data_uri.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::gltf {
namespace {

using Json = nlohmann::json;

std::vector<unsigned char> copyOf(std::span<const std::byte> bytes) {
  const auto* first = reinterpret_cast<const unsigned char*>(bytes.data());
  return {first, first + bytes.size()};
}

std::vector<unsigned char> readBytes(const Json& buffer, const std::string& what, std::span<const std::byte> binary,
                                     const std::filesystem::path& folder, std::vector<std::filesystem::path>& files,
                                     const std::string& file) {
  const auto uri = buffer.find("uri");
  if (uri == buffer.end()) return copyOf(binary);
  const auto& text = uri->get_ref<const std::string&>();
  if (isDataUri(text)) return dataUriBytes(text, what);
  const std::filesystem::path path = folder / withoutPercents(text);
  try {
    std::vector<unsigned char> bytes = copyOf(base::readFile(path));
    files.push_back(path);
    return bytes;
  } catch (const base::Error& e) {
    throw base::Error(e.status(), fmt::format("{}: {}", file, e.what()));
  }
}

}  // namespace

GltfParts partsOfGltf(std::span<const std::byte> bytes, const std::string& file) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (!text.starts_with("glTF")) return {text, {}};
  const auto refuse = [&](const std::string& why) {
    return base::Error(base::ExitStatus::content, fmt::format("{}: not a whole glTF file: {}", file, why));
  };
  const auto word = [&](std::size_t at) {
    if (at + 4 > bytes.size()) throw refuse("it is cut");
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof(value));
    return std::size_t{value};
  };
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kJson = 0x4e4f534a;
  constexpr std::size_t kBinary = 0x004e4942;
  if (word(4) != 2) throw refuse(fmt::format("its container has version {}: must be 2", word(4)));
  const std::size_t length = word(8);
  if (length > bytes.size()) throw refuse(fmt::format("it has {} of its {} bytes", bytes.size(), length));
  GltfParts parts;
  for (std::size_t at = kHeader; at < length;) {
    const std::size_t size = word(at);
    const std::size_t type = word(at + 4);
    at += 8;
    if (size > length - std::min(at, length)) throw refuse(fmt::format("a chunk of {} bytes is cut", size));
    if (type == kJson && parts.json.empty()) parts.json = text.substr(at, size);
    if (type == kBinary && parts.binary.empty()) parts.binary = bytes.subspan(at, size);
    at += (size + 3) / 4 * 4;
  }
  if (parts.json.empty()) throw refuse("it has no JSON chunk");
  return parts;
}

GltfBuffers readGltfBuffers(Json& gltf, std::span<const std::byte> binary, const std::filesystem::path& path,
                            std::vector<std::filesystem::path>& files) {
  const std::string file = path.string();
  GltfBuffers buffers;
  if (const auto list = gltf.find("buffers"); list != gltf.end())
    for (std::size_t i = 0; i < list->size(); ++i) {
      const Json& buffer = (*list)[i];
      const std::string what = fmt::format("{}: buffers[{}]", file, i);
      const auto must = buffer["byteLength"].get<std::size_t>();
      std::vector<unsigned char> bytes =
          readBytes(buffer, what, i == 0 ? binary : std::span<const std::byte>(), path.parent_path(), files, file);
      const bool empty = bytes.empty() && !buffer.contains("uri");  // filled by an extension
      if (bytes.size() < must && !empty)
        throw base::Error(base::ExitStatus::content,
                          fmt::format("{}: is cut: it has {} of its {} bytes", what, bytes.size(), must));
      if (!empty) bytes.resize(must);
      buffers.push_back(std::move(bytes));
    }
  if (const auto list = gltf.find("images"); list != gltf.end())
    for (std::size_t i = 0; i < list->size(); ++i) {
      const auto uri = (*list)[i].find("uri");
      if (uri == (*list)[i].end() || !isDataUri(uri->get_ref<const std::string&>())) continue;
      const std::string what = fmt::format("{}: images[{}]", file, i);
      const std::size_t view = addGltfBuffer(gltf, buffers, dataUriBytes(uri->get_ref<const std::string&>(), what));
      Json& image = gltf["images"][i];
      image.erase("uri");
      image["bufferView"] = view;
    }
  return buffers;
}

std::size_t addGltfBuffer(Json& gltf, GltfBuffers& buffers, std::vector<unsigned char> bytes) {
  gltf["bufferViews"].push_back({{"buffer", buffers.size()}, {"byteLength", bytes.size()}});
  gltf["buffers"].push_back({{"byteLength", bytes.size()}});
  buffers.push_back(std::move(bytes));
  return gltf["bufferViews"].size() - 1;
}

}  // namespace welkin::gltf
