// SPDX-License-Identifier: Apache-2.0
#include "sky/image/exr_notes.h"

#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

#include "sky/base/message.h"
#include "sky/image/pixel_aspect.h"

namespace welkin::image {
namespace {

/// Names of linear Rec. 709: of the Color Interop Forum, of OpenColorIO's configurations and of OpenImageIO.
constexpr std::string_view kLinearRec709[] = {"lin_rec709_scene",      "lin_rec709",  "lin_srgb", "linear",
                                              "linear rec.709 (srgb)", "scene_linear"};

void noteColourSpace(const Imf::Header& header, Image& image) {
  for (const char* field : {"colorInteropID", "colorSpace", "oiio:ColorSpace"}) {
    const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(field);
    if (attribute == nullptr || attribute->value().empty()) continue;
    std::string name = attribute->value();
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (std::find(std::begin(kLinearRec709), std::end(kLinearRec709), name) == std::end(kLinearRec709))
      image.notes.push_back(fmt::format("{} \"{}\" is not read; without chromaticities the colours are linear Rec. 709",
                                        field, base::shortened(attribute->value(), 60)));
  }
  const auto* aces = header.findTypedAttribute<Imf::IntAttribute>("acesImageContainerFlag");
  if (aces != nullptr && aces->value() == 1)
    image.notes.push_back(
        "acesImageContainerFlag is not read; without chromaticities the colours are linear Rec. 709, not those of "
        "ACES");
}

}  // namespace

void noteUnusedFields(const Imf::Header& header, Image& image) {
  if (!Imf::hasChromaticities(header)) noteColourSpace(header, image);
  if (Imf::hasWhiteLuminance(header) && Imf::whiteLuminance(header) != 1.0F)
    image.notes.push_back(
        fmt::format("whiteLuminance is {:.6g}; values are not multiplied by it", Imf::whiteLuminance(header)));
  notePixelAspect("pixelAspectRatio", double{header.pixelAspectRatio()}, image);
  if (Imf::hasAdoptedNeutral(header))
    image.notes.push_back(fmt::format("adoptedNeutral ({:.4g}, {:.4g}) is not read; the white of the chromaticities is",
                                      Imf::adoptedNeutral(header).x, Imf::adoptedNeutral(header).y));
  const auto* turn = header.findTypedAttribute<Imf::IntAttribute>("Orientation");
  if (turn != nullptr && turn->value() != 1)
    image.notes.push_back(fmt::format("Orientation is {}; the picture is not turned by it", turn->value()));
}

}  // namespace welkin::image
