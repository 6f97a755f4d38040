// SPDX-License-Identifier: Apache-2.0
#include "probes/obj/obj_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "probes/obj/text_lines.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/image/coded_image.h"

namespace welkin::obj {
namespace {

bool isFile(const std::filesystem::path& path) {
  std::error_code none;
  return std::filesystem::is_regular_file(path, none);
}

std::string withSlashes(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

/// Adds the file names in the words of a mtllib. They may hold spaces: a name ends where it is a file or has the suffix
/// of one.
void addNames(const std::filesystem::path& folder, const std::string& words, std::vector<std::string>& names) {
  constexpr std::size_t kLongestPath = 4096;
  for (std::size_t first = 0; first < words.size();) {
    std::size_t end = first;
    for (bool whole = false; !whole && end < words.size();) {
      end = std::min(words.find_first_of(" \t", end + 1), words.size());
      const std::string name = words.substr(first, std::min(end - first, kLongestPath));
      whole = lowerCase(name).ends_with(".mtl") || isFile(folder / name);
    }
    names.push_back(words.substr(first, end - first));
    first = std::min(words.find_first_not_of(" \t", end), words.size());
  }
}

/// Adds the names of words with quotes around some of the names. The quotes around the whole are gone already.
void addQuotedNames(const std::filesystem::path& folder, const std::string& words, std::vector<std::string>& names) {
  for (std::size_t first = 0; first < words.size();) {
    first = std::min(words.find_first_not_of(" \t\"", first), words.size());
    const std::size_t end = std::min(words.find('"', first), words.size());
    const std::size_t last = words.find_last_not_of(" \t", end == 0 ? 0 : end - 1);
    if (end > first) addNames(folder, words.substr(first, last + 1 - first), names);
    first = end;
  }
}

std::vector<std::string> namesIn(const std::filesystem::path& folder, const std::vector<std::string>& libraries) {
  std::vector<std::string> names;
  for (const std::string& line : libraries) {
    const std::string words = withSlashes(line);
    if (isFile(folder / words))
      names.push_back(words);
    else
      addQuotedNames(folder, std::string(withoutComment(words)), names);
  }
  return names;
}

/// Vertices count v from the top.
geometry::UvRows uvRowsOf(const MtlMap& map) {
  return {{{map.scale[0], 0.0, map.offset[0]}, {0.0, map.scale[1], 1.0 - map.scale[1] - map.offset[1]}}};
}

void addOnce(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

}  // namespace

ObjMaterials::ObjMaterials(const std::filesystem::path& obj, const std::vector<std::string>& libraries,
                           level::SceneBuilder& builder)
    : obj_(obj.string()), builder_(builder) {
  const std::filesystem::path folder = obj.parent_path();
  std::set<std::string> seen;
  for (const std::string& name : namesIn(folder, libraries)) {
    if (!seen.insert(name).second) continue;
    if (isFile(folder / name))
      readLibrary(folder / name);
    else
      builder_.scene().warnings.push_back(
          fmt::format("{}: mtllib {} is not there: level.toml's albedo stands in for its materials", obj_, name));
  }
  for (const auto& [name, source] : sources_) commented_.emplace(withoutComment(name), &source);
}

void ObjMaterials::readLibrary(const std::filesystem::path& path) {
  const MtlFile file = readMtl(path);
  for (const std::string& warning : file.warnings)
    builder_.scene().warnings.push_back(fmt::format("{}: {}", path.string(), warning));
  builder_.scene().files.push_back(path);
  for (const MtlMaterial& material : file.materials)
    sources_.emplace(material.name, Source{material, path.parent_path()});
}

/// In one of the files a comment may follow the name. Two names that differ after a # are two materials.
const ObjMaterials::Source* ObjMaterials::find(const std::string& name) const {
  const auto exact = sources_.find(name);
  if (exact != sources_.end()) return &exact->second;
  const std::string bare(withoutComment(name));
  if (bare == name) {
    const auto commented = commented_.find(name);
    return commented != commented_.end() ? commented->second : nullptr;
  }
  const auto found = sources_.find(bare);
  return found != sources_.end() ? &found->second : nullptr;
}

std::optional<uint32_t> ObjMaterials::at(const std::string& name, bool has_uv) {
  if (name.empty()) return std::nullopt;
  const auto known = read_.find({name, has_uv});
  if (known != read_.end()) return known->second;
  const Source* source = find(name);
  std::optional<uint32_t> result;
  if (source == nullptr)
    unknown_materials_.push_back(name);
  else
    result = read(*source, has_uv);
  return read_[{name, has_uv}] = result;
}

std::optional<uint32_t> ObjMaterials::read(const Source& source, bool has_uv) {
  const MtlMaterial& from = source.material;
  level::SceneMaterial result;
  geometry::Material& surface = result.surface;
  std::optional<int> texture;
  if (from.diffuse_map && has_uv) texture = readTexture(*from.diffuse_map, source.folder);
  const bool image_missing = from.diffuse_map && !texture;
  const bool emits = readEmission(source, has_uv, surface);
  if (!texture && !emits && from.dissolve == 1.0 && (image_missing || !from.diffuse)) return std::nullopt;
  if (texture) {
    surface.texture = *texture;
    surface.uv_row = uvRowsOf(*from.diffuse_map);
    surface.albedo = from.diffuse.value_or(f64::Number3(1.0));
    if (surface.albedo.x == 0.0 && surface.albedo.y == 0.0 && surface.albedo.z == 0.0)
      builder_.scene().warnings.push_back(
          fmt::format("{}: material {}: black, as Kd 0 0 0 multiplies map_Kd", obj_, from.name));
  } else if (from.diffuse && !image_missing) {
    surface.albedo = *from.diffuse;
  }
  readAlpha(from, surface);
  return builder_.addMaterial(std::move(result));
}

/// Without its image, or coordinates for it, a material emits nothing: a factor of 1 stands for the image alone.
bool ObjMaterials::readEmission(const Source& source, bool has_uv, geometry::Material& surface) {
  const MtlMaterial& from = source.material;
  if (!from.emission && !from.emission_map) return false;
  const f64::Number3 emission = from.emission.value_or(f64::Number3(1.0));
  if (emission == f64::Number3(0.0)) return false;
  if (from.emission_map) {
    if (!has_uv) return false;
    const std::optional<int> texture = readTexture(*from.emission_map, source.folder);
    if (!texture) return false;
    surface.emission_texture = *texture;
    surface.emission_uv_row = uvRowsOf(*from.emission_map);
  }
  surface.emission = emission;
  return true;
}

void ObjMaterials::readAlpha(const MtlMaterial& material, geometry::Material& surface) {
  constexpr double kCutoff = 0.5;
  auto& warnings = builder_.scene().warnings;
  const bool own_alpha =
      surface.texture >= 0 && !material.alpha_map.empty() && material.alpha_map == material.diffuse_map->file;
  if (!material.alpha_map.empty() && !own_alpha)
    warnings.push_back(
        fmt::format("{}: material {}: map_d is left out, as it is not the image of map_Kd", obj_, material.name));
  surface.alpha = material.dissolve;
  if (material.dissolve == 1.0 && !own_alpha) return;
  surface.alpha_cutoff = kCutoff;
  surface.blended = true;
}

std::optional<int> ObjMaterials::readTexture(const MtlMap& map, const std::filesystem::path& folder) {
  const std::string bare(withoutComment(map.file));
  const std::filesystem::path path = folder / (isFile(folder / map.file) ? map.file : bare);
  if (!isFile(path)) {
    addOnce(missing_images_, bare);
    return std::nullopt;
  }
  level::TextureSource source;
  source.name = path.string();
  source.bytes = base::readFile(path);
  builder_.scene().files.push_back(path);
  if (!image::isTexture(source.name, source.bytes)) {
    addOnce(foreign_images_, bare);
    return std::nullopt;
  }
  source.wrap_u = source.wrap_v = map.clamped ? geometry::Texture::Wrap::clamped : geometry::Texture::Wrap::repeat;
  return builder_.addTexture(std::move(source));
}

void ObjMaterials::warn() {
  auto& warnings = builder_.scene().warnings;
  if (!missing_images_.empty())
    warnings.push_back(
        fmt::format("{}: {} images of its materials are not there, the first {}: level.toml's albedo stands in", obj_,
                    missing_images_.size(), missing_images_.front()));
  if (!foreign_images_.empty())
    warnings.push_back(fmt::format(
        "{}: {} images of its materials are in a format that is not read, the first {}: level.toml's albedo stands in",
        obj_, foreign_images_.size(), foreign_images_.front()));
  if (!unknown_materials_.empty())
    warnings.push_back(
        fmt::format("{}: {} materials are in none of its mtllib, the first {}: level.toml's albedo stands in", obj_,
                    unknown_materials_.size(), unknown_materials_.front()));
}

}  // namespace welkin::obj
