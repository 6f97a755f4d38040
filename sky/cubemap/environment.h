// SPDX-License-Identifier: Apache-2.0
// Pictures of the whole sphere from files, in the layouts that tools write, as spherical harmonics.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sh/environment.h"

namespace welkin::cubemap {

/// A cubemap's or latlong's radiance, and how the file was understood.
struct Environment {
  std::string layout;  ///< as --layout takes it, or "cube" and "faces"
  sh::TexelRule rule = sh::TexelRule::half_texel;
  int width = 0;                          ///< the latlong's, or a face's
  int height = 0;                         ///< the same
  std::size_t negative = 0;               ///< values below 0
  std::vector<std::string> notes;         ///< for the user: fields of the header, parts left out, a layout's doubts
  std::vector<det::Number3> radiance_sh;  ///< bands^2, world axes
};

/// Choices that a file leaves open. Empty ones are made by the rules of docs/pictures.md.
struct PictureChoice {
  std::string layout;  ///< "latlong", "exr-latlong", or a name that cubeLayout() takes
  std::string layer;   ///< of an OpenEXR file
};

/// Reads and projects an image. A chosen layout comes first, then OpenEXR's `envmap` attribute with its rule and
/// orientation (texel centres on edges and poles), then the shape: 2:1 a latlong that lies as OpenEXR's does, otherwise
/// layoutsOfShape(). Where a shape has several layouts, the faces' seams decide. `bands` in [1, sh::kMostBands]. Throws
/// Error as readImage does, Error(content) for another shape and Error(usage) for an unknown layout.
Environment projectImage(const std::filesystem::path& path, int bands, const PictureChoice& choice = {});

/// Projects six square pictures of one size: +x -x +y -y +z -z, each oriented as Vulkan's face.
Environment projectFaces(std::span<const std::filesystem::path, 6> paths, int bands, const std::string& layer = "");

}  // namespace welkin::cubemap
