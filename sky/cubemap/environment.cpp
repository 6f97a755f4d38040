// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sky/base/error.h"
#include "sky/cubemap/cube_layout.h"
#include "sky/image/image.h"

namespace welkin::cubemap {
namespace {

constexpr image::ImageLimits kLimits{65536, std::size_t{1} << 27, true};

base::Error refusal(const std::string& name, const image::Image& image, const std::string& why) {
  return {base::ExitStatus::content, fmt::format("{}: {} x {} texels: {}", name, image.width, image.height, why)};
}

Environment describe(const image::Image& image) {
  Environment result;
  result.negative =
      static_cast<std::size_t>(std::count_if(image.rgb.begin(), image.rgb.end(), [](float v) { return v < 0.0F; }));
  result.width = image.width;
  result.height = image.height;
  result.notes = image.notes;
  return result;
}

void projectLatlong(const std::string& name, const image::Image& image, sh::TexelRule rule, int bands,
                    Environment& result) {
  if (rule == sh::TexelRule::edge_centres && std::min(image.width, image.height) < 2)
    throw refusal(name, image, "OpenEXR's latlong has at least 2 columns and rows");
  result.rule = rule;
  result.radiance_sh = sh::projectLatlong(image.rgb.data(), image.width, image.height, rule, bands);
}

void projectCube(const CubeLayout& layout, const image::Image& image, int bands, Environment& result) {
  result.rule = layout.rule;
  result.width = result.height = image.width / layout.across;
  result.radiance_sh = sh::projectCube(facesOf(layout, image), result.width, layout.rule, bands);
}

CubeLayout layoutOf(const std::string& name, const image::Image& image, const std::string& wanted) {
  const auto layout = cubeLayout(wanted);
  if (!layout)
    throw base::Error(base::ExitStatus::usage,
                      fmt::format("{}: no layout '{}': latlong, exr-latlong, vstrip, hstrip, exr-cube, hcross:MR and "
                                  "vcross:MR[:upright] are, where M and R are two of +x -x +z -z, such as hcross:-z+x",
                                  name, wanted));
  if (!fits(*layout, image))
    throw refusal(name, image, fmt::format("{} is {} x {} faces", wanted, layout->across, layout->down));
  return *layout;
}

/// The layout of the shape whose faces meet best. Another than the first must meet twice as well, in the square.
CubeLayout layoutByShape(const std::string& name, const image::Image& image, std::vector<std::string>& notes) {
  std::vector<CubeLayout> layouts = layoutsOfShape(image.width, image.height);
  std::erase_if(layouts, [&](const CubeLayout& layout) { return !fits(layout, image); });
  if (layouts.empty()) throw refusal(name, image, "a latlong is 2:1, a cubemap 1:6, 6:1, 4:3 or 3:4");
  std::size_t best = 0;
  if (layouts.size() > 1) {
    constexpr double kDecisive = 0.5;
    const double first = seamOf(layouts[0], image);
    if (seamOf(layouts[1], image) < kDecisive * first) best = 1;
  }
  const CubeLayout& layout = layouts[best];
  if (best != 0)
    notes.push_back(
        fmt::format("read as {}, in which its faces meet; as {} they do not", layout.name, layouts[0].name));
  if (layout.name.find("cross") != std::string::npos)
    notes.push_back(
        fmt::format("no field says which face of a cross is in its middle; read as {} (--layout)", layout.name));
  return layout;
}

}  // namespace

Environment projectImage(const std::filesystem::path& path, int bands, const PictureChoice& choice) {
  const std::string name = path.string();
  const image::Image image = image::readImage(path, kLimits, choice.layer);
  Environment result = describe(image);
  const bool exr_map = choice.layout.empty() && image.envmap != image::EnvironmentMap::none;
  const bool exr_cube = exr_map && image.envmap == image::EnvironmentMap::cube;
  const bool two_to_one = choice.layout.empty() && !exr_map && image.width == 2 * image.height;
  result.layout = exr_cube ? "cube" : exr_map || two_to_one ? "latlong" : choice.layout;
  if (result.layout == "latlong" || result.layout == "exr-latlong") {
    const bool edges = exr_map || result.layout == "exr-latlong";
    projectLatlong(name, image, edges ? sh::TexelRule::edge_centres : sh::TexelRule::half_texel, bands, result);
    return result;
  }
  if (exr_cube) {
    const CubeLayout layout = *cubeLayout("exr-cube");
    if (!fits(layout, image))
      throw refusal(name, image, "OpenEXR's cube is six faces of 2 or more texels below each other, 1:6");
    projectCube(layout, image, bands, result);
    return result;
  }
  const CubeLayout layout =
      choice.layout.empty() ? layoutByShape(name, image, result.notes) : layoutOf(name, image, choice.layout);
  result.layout = layout.name;
  projectCube(layout, image, bands, result);
  return result;
}

Environment projectFaces(std::span<const std::filesystem::path, 6> paths, int bands, const std::string& layer) {
  image::Image all = image::readImage(paths[0], kLimits, layer);
  if (all.width != all.height) throw refusal(paths[0].string(), all, "a face is square");
  for (std::size_t f = 1; f < 6; ++f) {
    const image::Image face = image::readImage(paths[f], kLimits, layer);
    if (face.width != all.width || face.height != all.width)
      throw refusal(paths[f].string(), face, fmt::format("the first face has {} x {}", all.width, all.width));
    all.rgb.insert(all.rgb.end(), face.rgb.begin(), face.rgb.end());
    for (const std::string& note : face.notes)
      if (std::find(all.notes.begin(), all.notes.end(), note) == all.notes.end()) all.notes.push_back(note);
  }
  all.height = 6 * all.width;
  Environment result = describe(all);
  result.layout = "faces";
  projectCube(*cubeLayout("vstrip"), all, bands, result);
  return result;
}

}  // namespace welkin::cubemap
