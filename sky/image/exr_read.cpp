// SPDX-License-Identifier: Apache-2.0
#include "sky/image/exr_read.h"

#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <utility>

#include "sky/base/error.h"
#include "sky/base/message.h"
#include "sky/image/colour.h"
#include "sky/image/exr_layers.h"
#include "sky/image/exr_notes.h"
#include "sky/image/image_header.h"

namespace welkin::image {
namespace {

class MemoryStream : public Imf::IStream {
 public:
  MemoryStream(const std::string& name, std::span<const std::byte> bytes) : Imf::IStream(name.c_str()), bytes_(bytes) {}

  bool read(char* to, int count) override {
    const auto wanted = static_cast<std::size_t>(count);
    if (count < 0 || place_ > bytes_.size() || wanted > bytes_.size() - place_)
      throw Iex::InputExc("the file ends too early");
    std::memcpy(to, bytes_.data() + place_, wanted);
    place_ += wanted;
    return place_ < bytes_.size();
  }
  std::uint64_t tellg() override { return place_; }
  void seekg(std::uint64_t place) override { place_ = place; }

 private:
  std::span<const std::byte> bytes_;
  std::uint64_t place_ = 0;
};

std::int64_t widthOf(const Imath::Box2i& window) {
  return std::int64_t{window.max.x} - window.min.x + 1;
}
std::int64_t heightOf(const Imath::Box2i& window) {
  return std::int64_t{window.max.y} - window.min.y + 1;
}

/// One channel's samples: every x_step-th column and y_step-th row of the data window.
struct Plane {
  int x_step = 1, y_step = 1;
  std::int64_t width = 0, height = 0;
  std::vector<float> sample;

  /// The value at a column and row of the data window, linear between samples and constant past the last one.
  float at(std::int64_t column, std::int64_t row) const {
    const std::int64_t i = std::min(column / x_step, width - 1), j = std::min(row / y_step, height - 1);
    const std::int64_t right = std::min(i + 1, width - 1), below = std::min(j + 1, height - 1);
    const float u = static_cast<float>(column % x_step) / static_cast<float>(x_step);
    const float v = static_cast<float>(row % y_step) / static_cast<float>(y_step);
    const auto get = [&](std::int64_t x, std::int64_t y) { return sample[static_cast<std::size_t>(y * width + x)]; };
    const auto mix = [](float a, float b, float t) { return t == 0.0F ? a : a + (b - a) * t; };
    return mix(mix(get(i, j), get(right, j), u), mix(get(i, below), get(right, below), u), v);
  }
};

/// Makes a plane of NaN for a channel and puts it into the frame buffer.
Plane insertPlane(const Imf::Header& header, const std::string& channel, Imf::FrameBuffer& frame) {
  const Imf::Channel& stored = *header.channels().findChannel(channel);
  const Imath::Box2i& window = header.dataWindow();
  Plane plane{stored.xSampling, stored.ySampling, 0, 0, {}};
  plane.width = (widthOf(window) + plane.x_step - 1) / plane.x_step;
  plane.height = (heightOf(window) + plane.y_step - 1) / plane.y_step;
  plane.sample.assign(static_cast<std::size_t>(plane.width * plane.height), std::numeric_limits<float>::quiet_NaN());
  frame.insert(channel,
               Imf::Slice::Make(Imf::FLOAT, plane.sample.data(), window, sizeof(float),
                                sizeof(float) * static_cast<std::size_t>(plane.width), plane.x_step, plane.y_step));
  return plane;
}

Chromaticities chromaticitiesOf(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header)) return kRec709;
  const Imf::Chromaticities& c = Imf::chromaticities(header);
  const auto pair = [](const Imath::V2f& v) { return std::array<double, 2>{double{v.x}, double{v.y}}; };
  return {pair(c.red), pair(c.green), pair(c.blue), pair(c.white)};
}

/// RGB of luminance and chroma: RY is (R - Y) / Y and BY is (B - Y) / Y (OpenEXR, "Technical Introduction").
void readChroma(const std::array<Plane, 3>& plane, const det::Number3& luminance, std::int64_t width, Image& image) {
  for (std::size_t i = 0; i < image.rgb.size() / 3; ++i) {
    const auto column = static_cast<std::int64_t>(i) % width, row = static_cast<std::int64_t>(i) / width;
    const double y = double{plane[0].at(column, row)};
    const double red = (double{plane[1].at(column, row)} + 1.0) * y;
    const double blue = (double{plane[2].at(column, row)} + 1.0) * y;
    const double green = (y - luminance.x * red - luminance.z * blue) / luminance.y;
    image.rgb[3 * i] = static_cast<float>(red);
    image.rgb[3 * i + 1] = static_cast<float>(green);
    image.rgb[3 * i + 2] = static_cast<float>(blue);
  }
}

/// The picture of the display window, from that of the data window.
Image windowed(Image image, const Imath::Box2i& from, const Imath::Box2i& to) {
  const std::vector<float> data = std::move(image.rgb);
  image.width = static_cast<int>(widthOf(to));
  image.height = static_cast<int>(heightOf(to));
  image.rgb.assign(3 * static_cast<std::size_t>(widthOf(to) * heightOf(to)), 0.0F);
  const Imath::Box2i both({std::max(from.min.x, to.min.x), std::max(from.min.y, to.min.y)},
                          {std::min(from.max.x, to.max.x), std::min(from.max.y, to.max.y)});
  std::int64_t covered = 0;
  if (both.max.x >= both.min.x)
    for (int y = both.min.y; y <= both.max.y; ++y) {
      const auto place = [&](const Imath::Box2i& window) {
        return 3 * ((std::int64_t{y} - window.min.y) * widthOf(window) + both.min.x - window.min.x);
      };
      std::copy_n(data.begin() + place(from), 3 * widthOf(both), image.rgb.begin() + place(to));
      covered += widthOf(both);
    }
  const std::int64_t missing = widthOf(to) * heightOf(to) - covered;
  const std::int64_t outside = widthOf(from) * heightOf(from) - covered;
  if (missing > 0)
    image.notes.push_back(fmt::format("{} texels of the display window are not in the data window: black", missing));
  if (outside > 0) image.notes.push_back(fmt::format("{} texels outside of the display window were left out", outside));
  return image;
}

/// Whether a file of so many bytes can hold the samples of one channel. Zip packs at most 1032 bytes into one, and
/// every other code less. DWA drops frequencies first: at least one number of 64 is left.
bool canHold(const Imf::Header& header, std::size_t file_bytes, std::int64_t samples) {
  constexpr std::int64_t kMostPacked = 1032, kDropped = 64, kSmallest = 2;  // bytes of a half
  const bool dwa = header.compression() == Imf::DWAA_COMPRESSION || header.compression() == Imf::DWAB_COMPRESSION;
  return samples / (kMostPacked * (dwa ? kDropped : 1)) <= static_cast<std::int64_t>(file_bytes) / kSmallest;
}

Image read(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits,
           const std::string& wanted) {
  const auto refuse = [&](const std::string& why) { return base::Error(base::ExitStatus::content, name + ": " + why); };
  MemoryStream stream(name, bytes);
  Imf::MultiPartInputFile file(stream, 0, false);
  const auto layers = exrLayers(file);
  const ExrLayer layer = chooseLayer(name, layers, wanted);
  const Imf::Header& header = file.header(layer.part);
  if (header.hasType() && Imf::isDeepData(header.type())) throw refuse("deep samples; a picture is flat");
  const bool envmap = Imf::hasEnvmap(header);
  if (envmap && Imf::envmap(header) != Imf::ENVMAP_CUBE && Imf::envmap(header) != Imf::ENVMAP_LATLONG)
    throw refuse("envmap is neither 0 (latlong) nor 1 (cube)");
  const Imath::Box2i& window = header.dataWindow();
  const std::int64_t width = widthOf(window), height = heightOf(window);
  requireSize(name, width, height, limits);
  if (!envmap) requireSize(name, widthOf(header.displayWindow()), heightOf(header.displayWindow()), limits);
  if (!file.partComplete(layer.part)) throw refuse("damaged or cut: the table of its chunks has gaps");
  if (!canHold(header, bytes.size(), width * height))
    throw refuse(fmt::format("damaged or cut: {} bytes cannot hold {} x {} texels", bytes.size(), width, height));

  Image image;
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  // A sample that is never written shows as NaN.
  image.rgb.assign(3 * static_cast<std::size_t>(width * height), std::numeric_limits<float>::quiet_NaN());
  const bool grey = layer.colours == ExrColours::grey;
  const bool chroma = layer.colours == ExrColours::chroma;
  const char* const channels[2][3] = {{"R", "G", "B"}, {"Y", "RY", "BY"}};
  Imf::FrameBuffer frame;
  std::array<Plane, 3> plane;
  for (std::size_t c = 0; c < (grey ? 1 : 3); ++c) {
    const std::string channel = layer.prefix + channels[grey || chroma][c];
    const Imf::Channel& stored = *header.channels().findChannel(channel);
    if ((stored.xSampling != 1 || stored.ySampling != 1) && !(chroma && c > 0))
      throw refuse(fmt::format("channel {} has not every texel", channel));
    if (grey || chroma)
      plane[c] = insertPlane(header, channel, frame);
    else
      frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, image.rgb.data() + c, window, 3 * sizeof(float),
                                             3 * sizeof(float) * static_cast<std::size_t>(width)));
  }
  Imf::InputPart part(file, layer.part);
  part.setFrameBuffer(frame);
  part.readPixels(window.min.y, window.max.y);

  const Chromaticities colours = chromaticitiesOf(header);
  if (chroma) {
    const auto xyz = toXyz(colours);
    if (!xyz) throw refuse("chromaticities that are no colour space: " + textOf(colours));
    readChroma(plane, {xyz->column[0].y, xyz->column[1].y, xyz->column[2].y}, width, image);
  } else if (grey) {
    for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = plane[0].sample[i / 3];
  }
  if (!grey) convertColours(name, colours, image);  // grey is as bright in any primaries
  if (const std::string note = leftOutNote(layers, layer); !note.empty()) image.notes.push_back(note);
  noteUnusedFields(header, image);
  if (envmap)
    image.envmap = Imf::envmap(header) == Imf::ENVMAP_CUBE ? EnvironmentMap::cube : EnvironmentMap::latlong;
  else if (window != header.displayWindow())
    image = windowed(std::move(image), window, header.displayWindow());
  return image;
}

}  // namespace

Image readExr(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits,
              const std::string& layer) {
  try {
    return read(name, bytes, limits, layer);
  } catch (const base::Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {  // OpenEXR's exceptions, whatever their base
    throw base::Error(base::ExitStatus::content, fmt::format("{}: damaged or cut: {}", name, base::oneLine(e.what())));
  }
}

}  // namespace welkin::image
