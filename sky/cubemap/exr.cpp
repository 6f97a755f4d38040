// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <algorithm>

#include "sky/image/exr_stream.h"

namespace welkin::cubemap {

std::vector<std::byte> encodeExr(const DomeImage& image, std::optional<Layout> layout, double luminance_unit,
                                 const base::Progress& progress) {
  Imf::Header header(image.extent.width, image.extent.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities());  // Rec. 709, D65
  Imf::addWhiteLuminance(header, static_cast<float>(luminance_unit));
  if (layout) Imf::addEnvmap(header, *layout == Layout::exr_cube ? Imf::ENVMAP_CUBE : Imf::ENVMAP_LATLONG);
  Imf::FrameBuffer frame;
  auto* base = const_cast<char*>(reinterpret_cast<const char*>(image.rgb_half.data()));  // only read by writePixels
  const std::size_t texel = 3 * sizeof(std::uint16_t);
  const char* names[3] = {"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) {
    header.channels().insert(names[c], Imf::Channel(Imf::HALF));
    frame.insert(names[c], Imf::Slice(Imf::HALF, base + c * sizeof(std::uint16_t), texel,
                                      texel * static_cast<std::size_t>(image.extent.width)));
  }
  image::ExrBytes stream;
  {
    Imf::OutputFile file(stream, header, 0);
    file.setFrameBuffer(frame);
    constexpr int kLines = 256;  // a multiple of the 16 lines that are compressed together
    for (int line = 0; line < image.extent.height; line += kLines) {
      file.writePixels(std::min(kLines, image.extent.height - line));
      progress.check();
    }
  }
  return std::move(stream.bytes);
}

}  // namespace welkin::cubemap
