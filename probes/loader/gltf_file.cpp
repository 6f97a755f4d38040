// SPDX-License-Identifier: Apache-2.0
// Parses glTF with tinygltf.
#include "probes/loader/gltf_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::loader {
namespace {

/// Records the files that tinygltf asked for, because it reports every failure with the same result.
struct Reading {
  std::string unreadable;  ///< message of the first file that could not be read
  std::vector<std::filesystem::path>* files = nullptr;
};

/// Extensions that a file may require. Unlit surfaces have the albedo of their base colour.
constexpr std::array<std::string_view, 5> kExtensions = {"EXT_texture_webp", "KHR_lights_punctual",
                                                         "KHR_materials_emissive_strength", "KHR_materials_unlit",
                                                         "KHR_texture_transform"};

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
    if (e.status() == base::ExitStatus::file && reading->unreadable.empty()) reading->unreadable = e.what();
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

std::string oneLine(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  for (char& c : text)
    if (c == '\n') c = ' ';
  return text.size() > 300 ? text.substr(0, 297) + "..." : text;
}

void requireKnownExtensions(const std::string& name, const tinygltf::Model& model) {
  for (const std::string& required : model.extensionsRequired)
    if (std::find(kExtensions.begin(), kExtensions.end(), required) == kExtensions.end())
      throw base::Error(base::ExitStatus::content,
                        fmt::format("{}: extensionsRequired: \"{}\" is not known; {} are", name, required.substr(0, 60),
                                    fmt::join(kExtensions, ", ")));
}

}  // namespace

tinygltf::Model readGltf(const std::filesystem::path& path, std::vector<std::filesystem::path>& files) {
  const std::string name = path.string();
  const std::vector<std::byte> bytes = base::readFile(path, std::numeric_limits<unsigned int>::max());
  files.push_back(path);
  Reading reading{{}, &files};
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks({exists, unchanged, readWhole, writeNothing, &reading});
  loader.SetImageLoader(keepImage, nullptr);
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const std::string folder = path.parent_path().string();
  const auto size = static_cast<unsigned int>(bytes.size());
  const bool binary = bytes.size() >= 4 && std::string(reinterpret_cast<const char*>(bytes.data()), 4) == "glTF";
  bool parsed = false;
  try {
    parsed = binary ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                                  reinterpret_cast<const unsigned char*>(bytes.data()), size, folder)
                    : loader.LoadASCIIFromString(&model, &error, &warning, reinterpret_cast<const char*>(bytes.data()),
                                                 size, folder);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {  // from the JSON library, for types that glTF does not have there
    error = e.what();
  }
  if (!parsed && !reading.unreadable.empty())
    throw base::Error(base::ExitStatus::file, fmt::format("{}: {}", name, reading.unreadable));
  if (!parsed)
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: not a whole glTF file: {}", name, oneLine(error.empty() ? warning : error)));
  if (!model.asset.version.starts_with("2."))
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: asset.version = \"{}\": must be 2.0", name, model.asset.version.substr(0, 20)));
  requireKnownExtensions(name, model);
  return model;
}

}  // namespace welkin::loader
