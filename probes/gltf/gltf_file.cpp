// SPDX-License-Identifier: Apache-2.0
// Checks the JSON, reads the buffers, and parses the rest with tinygltf.
#include "probes/gltf/gltf_file.h"

#include <fmt/format.h>

#include <limits>

#include "probes/gltf/gltf_buffers.h"
#include "probes/gltf/gltf_draco.h"
#include "probes/gltf/gltf_extensions.h"
#include "probes/gltf/gltf_json.h"
#include "probes/gltf/gltf_meshopt.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::gltf {
namespace {

/// Gets the paths of images that were read.
struct Reading {
  std::vector<std::filesystem::path>* files = nullptr;
};

bool exists(const std::string& path, void*) {
  (void)path;
  return true;  // the read itself will report the reason
}

std::string unchanged(const std::string& path, void*) {
  return path;
}

bool readWhole(std::vector<unsigned char>* out, std::string* error, const std::string& path, void* user) {
  auto* reading = static_cast<Reading*>(user);
  try {
    const std::vector<std::byte> bytes = base::readFile(path);
    reading->files->emplace_back(path);
    const auto* first = reinterpret_cast<const unsigned char*>(bytes.data());
    out->assign(first, first + bytes.size());
    return true;
  } catch (const base::Error& e) {
    if (error != nullptr) *error += e.what();
    return false;
  }
}

bool writeNothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
  return false;
}

/// Keeps an image encoded. A buffer view is not checked here, and its bytes stay where they are.
bool keepImage(tinygltf::Image* image, const int, std::string*, std::string*, int, int, const unsigned char* bytes,
               int size, void*) {
  if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
  return true;
}

/// Parses a text whose buffers have been read. tinygltf gets small ones instead of them, as it decodes slowly.
tinygltf::Model parse(nlohmann::json& gltf, GltfBuffers buffers, const std::string& name, const std::string& folder,
                      Reading& reading) {
  for (nlohmann::json& buffer : gltf["buffers"])
    buffer = {{"byteLength", 1}, {"uri", "data:application/octet-stream;base64,AA=="}};
  const std::string text = gltf.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks({exists, unchanged, readWhole, writeNothing, &reading});
  loader.SetImageLoader(keepImage, nullptr);
  tinygltf::Model model;
  std::string error;
  std::string warning;
  bool parsed = false;
  try {
    parsed = loader.LoadASCIIFromString(&model, &error, &warning, text.data(), static_cast<unsigned int>(text.size()),
                                        folder);
  } catch (const nlohmann::json::exception& e) {  // for types that glTF does not have there
    error = e.what();
  }
  if (!parsed)
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: not a whole glTF file: {}", name,
                                  base::shortened(base::oneLine(error.empty() ? warning : error), 300)));
  for (std::size_t i = 0; i < buffers.size(); ++i) model.buffers[i].data = std::move(buffers[i]);
  return model;
}

/// Refuses another version before the types, which glTF 1.0 has others of. Types refuse a version that is no string.
void requireVersion(const nlohmann::json& gltf, const std::string& name) {
  const auto asset = gltf.find("asset");
  if (asset == gltf.end() || !asset->is_object()) return;
  const auto version = asset->find("version");
  if (version == asset->end() || !version->is_string()) return;
  const auto text = version->get<std::string>();
  if (!text.starts_with("2."))
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: asset.version = \"{}\": must be 2.0", name, base::shortened(text, 20)));
}

/// Gives indices without a bufferView, which are all 0 but for sparse ones, a buffer of zeros: tinygltf demands one.
void storeZeroIndices(nlohmann::json& gltf, GltfBuffers& buffers, const std::string& name) {
  constexpr std::size_t kMost = std::size_t{1} << 24;  // of a file
  std::size_t total = 0;
  if (!gltf.contains("meshes") || !gltf.contains("accessors")) return;
  for (const auto& mesh : gltf["meshes"])
    for (const auto& primitive : mesh["primitives"]) {
      const auto found = primitive.find("indices");
      if (found == primitive.end() || found->get<std::size_t>() >= gltf["accessors"].size()) continue;
      auto& accessor = gltf["accessors"][found->get<std::size_t>()];
      if (accessor.contains("bufferView")) continue;
      const auto count = accessor["count"].get<std::size_t>();
      if (count > kMost - total)
        throw base::Error(
            base::ExitStatus::content,
            fmt::format("{}: accessors[{}]: {} indices without a bufferView: at most {} are allowed in all", name,
                        found->get<std::size_t>(), count, kMost));
      total += count;
      accessor["bufferView"] = addGltfBuffer(gltf, buffers, std::vector<unsigned char>(4 * count));
    }
}

}  // namespace

tinygltf::Model readGltf(const std::filesystem::path& path, std::vector<std::filesystem::path>& files,
                         std::vector<std::string>& warnings) {
  const std::string name = path.string();
  const std::vector<std::byte> bytes = base::readFile(path, std::numeric_limits<unsigned int>::max());
  files.push_back(path);
  const GltfParts parts = partsOfGltf(bytes, name);
  nlohmann::json gltf = parseGltfJson(parts.json, name);
  requireVersion(gltf, name);
  checkGltfTypes(gltf, name);
  requireKnownExtensions(gltf, name);
  for (std::string& warning : extensionWarnings(gltf, name)) warnings.push_back(std::move(warning));
  GltfBuffers buffers = readGltfBuffers(gltf, parts.binary, path, files);
  unpackMeshopt(gltf, buffers, name);
  unpackDraco(gltf, buffers, name);
  storeZeroIndices(gltf, buffers, name);
  Reading reading{&files};
  return parse(gltf, std::move(buffers), name, path.parent_path().string(), reading);
}

}  // namespace welkin::gltf
