// SPDX-License-Identifier: Apache-2.0
#include "command/check_albedo.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <optional>

#include "calibrate/batch.h"
#include "probes/loader/read_scene.h"
#include "probes/loader/texture_source.h"
#include "sh/deterministic.h"
#include "sky/base/toml_file.h"

namespace welkin::command {
namespace {

using calibrate::CheckedAlbedo;
using calibrate::Colour;

level::Scene sceneIn(const std::filesystem::path& path) {
  if (path.extension() == ".toml") return loader::readScene(level::levelFileOf(base::readToml(path)));
  level::LevelFile level;
  level::GeometryEntry entry;
  entry.path = path;
  level.geometry.push_back(entry);
  return loader::readScene(level);
}

/// Texels of a texture that are there.
image::Image texelsOf(const level::TextureSource& source, double alpha_cutoff) {
  static const std::array<float, 256> kLight = [] {
    std::array<float, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i)
      light[i] = static_cast<float>(det::srgbDecode(static_cast<double>(i) / 255.0));
    return light;
  }();
  const geometry::Texture texture = loader::decodeTexture(source);
  image::Image image;
  for (std::size_t i = 0; i < texture.rgba.size(); i += 4) {
    const double alpha = texture.rgba[i + 3] / 255.0;
    if (alpha == 0.0 || alpha < alpha_cutoff) continue;
    for (std::size_t c = 0; c < 3; ++c) image.rgb.push_back(kLight[texture.rgba[i + c]]);
  }
  return image;
}

/// What the draws of one material tell of it.
struct Use {
  std::string object;
  image::Image vertex_colours;
};

std::map<std::uint32_t, Use> usesOf(const level::Scene& scene) {
  std::map<std::uint32_t, Use> uses;
  for (const level::Draw& draw : scene.draws) {
    if (draw.role == geometry::Role::water || draw.role == geometry::Role::ignored || draw.instance_count == 0)
      continue;
    Use& use = uses[draw.material];
    if (use.object.empty()) use.object = scene.objects[scene.placings[draw.first_instance].object].name;
    for (std::uint32_t i = draw.first_index; i < draw.first_index + draw.index_count; ++i) {
      const auto at = static_cast<std::size_t>(std::int64_t{scene.indices[i]} + draw.vertex_offset);
      for (const float c : scene.vertices[at].colour) use.vertex_colours.rgb.push_back(c);
    }
  }
  return uses;
}

std::vector<CheckedAlbedo> checkedScene(const level::Scene& scene, const calibrate::Gamut& gamut) {
  std::vector<CheckedAlbedo> checked;
  for (const auto& [index, use] : usesOf(scene)) {
    const geometry::Material& material = scene.materials[index].surface;
    const Colour tint(material.albedo.x, material.albedo.y, material.albedo.z);
    if (material.texture < 0) {
      checked.push_back(
          {fmt::format("material {} on {}", index, use.object), calibrate::sharesOf(use.vertex_colours, tint, gamut)});
      continue;
    }
    const level::TextureSource& source = scene.textures[static_cast<std::size_t>(material.texture)];
    checked.push_back({fmt::format("{} on {}", source.name, use.object),
                       calibrate::sharesOf(texelsOf(source, material.alpha_cutoff), tint, gamut)});
  }
  return checked;
}

CheckedAlbedo checkedPicture(const std::filesystem::path& path, const calibrate::Gamut& gamut) {
  image::ImageLimits limits = calibrate::kPhotoLimits;
  limits.negative = true;
  return {path.filename().string(), calibrate::sharesOf(image::readImage(path, limits), Colour::Ones(), gamut)};
}

}  // namespace

std::vector<CheckedAlbedo> checkedAlbedo(const std::filesystem::path& path, const calibrate::Gamut& gamut) {
  std::vector<CheckedAlbedo> checked;
  std::error_code none;
  const std::string ending = path.extension().string();
  if (std::filesystem::is_directory(path, none))
    for (const std::filesystem::path& picture : calibrate::picturesIn(path))
      checked.push_back(checkedPicture(picture, gamut));
  else if (ending == ".toml" || ending == ".gltf" || ending == ".glb" || ending == ".obj")
    checked = checkedScene(sceneIn(path), gamut);
  else
    checked.push_back(checkedPicture(path, gamut));
  calibrate::sortByWrong(checked);
  return checked;
}

}  // namespace welkin::command
