// SPDX-License-Identifier: Apache-2.0
#include "sky/image/exr_read.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <fmt/format.h>

#include <array>

#include "sky/base/error.h"
#include "sky/image/image_header.h"

namespace welkin::image {
namespace {

/// Names of the channels that give red, green and blue. Grey is one name three times. Empty if there are none.
std::array<std::string, 3> colourChannels(const Imf::ChannelList& channels) {
  const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
  if (has("R") && has("G") && has("B")) return {"R", "G", "B"};
  if (has("Y")) return {"Y", "Y", "Y"};
  return {};
}

Image read(const std::string& name, const ImageLimits& limits) {
  const auto refuse = [&](const std::string& why) { return base::Error(base::ExitStatus::content, name + ": " + why); };
  Imf::InputFile file(name.c_str());
  const Imf::Header& header = file.header();
  const Imath::Box2i& window = header.dataWindow();
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
  const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
  requireSize(name, width, height, limits);
  const auto channels = colourChannels(header.channels());
  if (channels[0].empty()) throw refuse("no channels R, G and B, and no Y");

  Image image{static_cast<int>(width), static_cast<int>(height),
              std::vector<float>(static_cast<std::size_t>(width * height * 3)), EnvironmentMap::none};
  if (Imf::hasEnvmap(header))
    image.envmap = Imf::envmap(header) == Imf::ENVMAP_CUBE ? EnvironmentMap::cube : EnvironmentMap::latlong;
  constexpr std::size_t kTexel = 3 * sizeof(float);
  const bool grey = channels[0] == channels[1];
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < (grey ? 1 : 3); ++c) {
    const auto* channel = header.channels().findChannel(channels[c]);
    if (channel->xSampling != 1 || channel->ySampling != 1)
      throw refuse(fmt::format("channel {} has not every texel", channels[c]));
    frame.insert(channels[c], Imf::Slice::Make(Imf::FLOAT, image.rgb.data() + c, window, kTexel,
                                               kTexel * static_cast<std::size_t>(width)));
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  if (grey)
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) image.rgb[i + 1] = image.rgb[i + 2] = image.rgb[i];
  return image;
}

}  // namespace

Image readExr(const std::filesystem::path& path, const ImageLimits& limits) {
  try {
    return read(path.string(), limits);
  } catch (const base::Error&) {
    throw;
  } catch (const std::exception& e) {  // OpenEXR's exceptions, whatever their base, and exhausted memory
    throw base::Error(base::ExitStatus::content, fmt::format("{}: damaged or cut: {}", path.string(), e.what()));
  }
}

}  // namespace welkin::image
