// SPDX-License-Identifier: Apache-2.0
#include "sky/image/exr_write.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>

#include <cassert>
#include <utility>

#include "sky/image/exr_stream.h"

namespace welkin::image {

std::vector<std::byte> encodeExr(int width, int height, int channels, std::span<const float> texels) {
  assert(channels == 1 || channels == 3);
  const auto count = static_cast<std::size_t>(channels);
  assert(texels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * count);
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer frame;
  auto* base = const_cast<char*>(reinterpret_cast<const char*>(texels.data()));  // only read by writePixels
  const std::size_t texel = count * sizeof(float);
  const char* const names[3] = {channels == 1 ? "Y" : "R", "G", "B"};
  for (std::size_t c = 0; c < count; ++c) {
    header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
    frame.insert(names[c],
                 Imf::Slice(Imf::FLOAT, base + c * sizeof(float), texel, texel * static_cast<std::size_t>(width)));
  }
  ExrBytes stream;
  {
    Imf::OutputFile file(stream, header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(height);
  }
  return std::move(stream.bytes);
}

}  // namespace welkin::image
