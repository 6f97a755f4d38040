// SPDX-License-Identifier: Apache-2.0
// The layers of an EXR file that have colours: a part of a file of several parts, a view, or channels of a common
// prefix ("ViewLayer.Combined.R").
#pragma once

#include <OpenEXR/ImfMultiPartInputFile.h>

#include <string>
#include <vector>

namespace welkin::image {

/// How a layer's channels give red, green and blue.
enum class ExrColours {
  rgb,     ///< R, G and B
  chroma,  ///< Y, RY and BY
  grey     ///< Y alone
};

struct ExrLayer {
  int part = 0;
  std::string prefix;  ///< of the channels' names, with its dot; empty for the layer without a name
  std::string name;    ///< for the user: the part's name and the prefix
  ExrColours colours = ExrColours::rgb;
};

/// Every layer with colours, in the order of parts and names.
std::vector<ExrLayer> exrLayers(const Imf::MultiPartInputFile& file);

/// The layer of that name. For an empty one see readImage(). Throws Error(content), naming the file and its layers.
ExrLayer chooseLayer(const std::string& file, const std::vector<ExrLayer>& layers, const std::string& name);

/// A note of the layers that were left out. Empty if there are none.
std::string leftOutNote(const std::vector<ExrLayer>& layers, const ExrLayer& chosen);

}  // namespace welkin::image
