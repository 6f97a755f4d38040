// SPDX-License-Identifier: Apache-2.0
#include "probes/loader/obj_material.h"

#include <fmt/format.h>

#include <algorithm>

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::loader {
namespace {

bool isThere(const std::filesystem::path& path) {
  std::error_code none;
  return std::filesystem::exists(path, none);
}

}  // namespace

ObjMaterials::ObjMaterials(const std::filesystem::path& obj, const std::vector<std::string>& files,
                           level::SceneBuilder& builder)
    : obj_(obj.string()), builder_(builder) {
  for (std::string name : files) {
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::filesystem::path path = obj.parent_path() / name;
    if (!isThere(path)) {
      builder_.scene().warnings.push_back(
          fmt::format("{}: mtllib {} is not there: level.toml's albedo stands in for its materials", obj_, name));
      continue;
    }
    const std::vector<MtlMaterial> materials = readMtl(path);
    builder_.scene().files.push_back(path);
    for (const MtlMaterial& material : materials)
      sources_.insert_or_assign(material.name, Source{material, path.parent_path()});
  }
}

std::optional<uint32_t> ObjMaterials::at(const std::string& name, bool has_uv) {
  if (name.empty()) return std::nullopt;
  const auto known = read_.find({name, has_uv});
  if (known != read_.end()) return known->second;
  const auto source = sources_.find(name);
  std::optional<uint32_t> result;
  if (source == sources_.end())
    unknown_materials_.push_back(name);
  else
    result = read(source->second, has_uv);
  return read_[{name, has_uv}] = result;
}

std::optional<uint32_t> ObjMaterials::read(const Source& source, bool has_uv) {
  const MtlMaterial& from = source.material;
  level::SceneMaterial result;
  geometry::Material& surface = result.surface;
  std::optional<int> texture;
  if (from.diffuse_map && has_uv) texture = readTexture(*from.diffuse_map, source.folder);
  const bool image_missing = from.diffuse_map && !texture;
  const bool emits = from.emission.x > 0.0 || from.emission.y > 0.0 || from.emission.z > 0.0;
  if (!texture && !emits && from.dissolve == 1.0 && (image_missing || !from.diffuse)) return std::nullopt;
  if (texture) {
    surface.texture = *texture;
    const MtlMap& map = *from.diffuse_map;
    surface.uv_row = {{{map.scale[0], 0.0, map.offset[0]},
                       {0.0, map.scale[1], 1.0 - map.scale[1] - map.offset[1]}}};  // vertices count v from the top
    surface.albedo = from.diffuse.value_or(f64::Number3(1.0));
  } else if (from.diffuse && !image_missing) {
    surface.albedo = *from.diffuse;
  }
  surface.emission = from.emission;
  readAlpha(from, surface);
  return builder_.addMaterial(std::move(result));
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
  warnings.push_back(fmt::format("{}: material {}: transparent: the surface is there where its alpha is {} or more",
                                 obj_, material.name, kCutoff));
}

std::optional<int> ObjMaterials::readTexture(const MtlMap& map, const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / map.file;
  if (!isThere(path)) {
    if (std::find(missing_images_.begin(), missing_images_.end(), map.file) == missing_images_.end())
      missing_images_.push_back(map.file);
    return std::nullopt;
  }
  level::TextureSource source;
  source.name = path.string();
  source.bytes = base::readFile(path);
  source.wrap_u = source.wrap_v = map.clamped ? geometry::Texture::Wrap::clamped : geometry::Texture::Wrap::repeat;
  builder_.scene().files.push_back(path);
  return builder_.addTexture(std::move(source));
}

void ObjMaterials::warn() {
  auto& warnings = builder_.scene().warnings;
  if (!missing_images_.empty())
    warnings.push_back(
        fmt::format("{}: {} images of its materials are not there, the first {}: level.toml's albedo stands in", obj_,
                    missing_images_.size(), missing_images_.front()));
  if (!unknown_materials_.empty())
    warnings.push_back(
        fmt::format("{}: {} materials are in none of its mtllib, the first {}: level.toml's albedo stands in", obj_,
                    unknown_materials_.size(), unknown_materials_.front()));
}

}  // namespace welkin::loader
