// SPDX-License-Identifier: Apache-2.0
#include "sky/image/tiff_check.h"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "sky/base/error.h"
#include "sky/image/image_header.h"

namespace welkin::image {
namespace {

/// The file in memory, and libtiff's first complaint.
struct Source {
  std::span<const std::byte> bytes;
  std::size_t place = 0;
  std::string complaint;

  static Source& of(thandle_t handle) { return *static_cast<Source*>(handle); }
};

tmsize_t readBytes(thandle_t handle, void* to, tmsize_t count) {
  Source& source = Source::of(handle);
  if (source.place > source.bytes.size()) return 0;
  const std::size_t size = std::min(static_cast<std::size_t>(count), source.bytes.size() - source.place);
  std::memcpy(to, source.bytes.data() + source.place, size);
  source.place += size;
  return static_cast<tmsize_t>(size);
}
tmsize_t writeNothing(thandle_t, void*, tmsize_t) {
  return 0;
}
toff_t seek(thandle_t handle, toff_t offset, int whence) {
  Source& source = Source::of(handle);
  const toff_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? source.place : source.bytes.size();
  source.place = from + offset;
  return source.place;
}
int closeNothing(thandle_t) {
  return 0;
}
toff_t sizeOf(thandle_t handle) {
  return Source::of(handle).bytes.size();
}

int complain(TIFF*, void* source, const char*, const char* format, va_list arguments) {
  char text[256] = "";
  std::vsnprintf(text, sizeof text, format, arguments);
  auto& complaint = static_cast<Source*>(source)->complaint;
  if (complaint.empty()) complaint = text;
  return 1;
}
/// Codecs warn of missing data; libtiff itself warns of unknown tags, which do no harm.
int warn(TIFF* tiff, void* source, const char* module, const char* format, va_list arguments) {
  const bool codec =
      module != nullptr && (std::strstr(module, "JPEG") != nullptr || std::strstr(module, "Decode") != nullptr ||
                            std::strstr(module, "Fax") != nullptr);
  return codec ? complain(tiff, source, module, format, arguments) : 1;
}

struct Closer {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
struct OptionsCloser {
  void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};

template <typename Number>
Number fieldOf(TIFF* tiff, std::uint32_t tag, Number otherwise) {
  Number value = otherwise;
  TIFFGetFieldDefaulted(tiff, tag, &value);
  return value;
}

bool isRead(std::uint16_t photometric) {
  return photometric == PHOTOMETRIC_MINISWHITE || photometric == PHOTOMETRIC_MINISBLACK ||
         photometric == PHOTOMETRIC_RGB || photometric == PHOTOMETRIC_PALETTE || photometric == PHOTOMETRIC_YCBCR;
}

}  // namespace

TiffFields checkTiff(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  Source source{bytes, 0, ""};
  const auto refuse = [&](const std::string& why) {
    return base::Error(base::ExitStatus::content, fmt::format("{}: {}", name, why));
  };
  const auto damaged = [&](const char* why) {
    return refuse(fmt::format("damaged or cut: {}", source.complaint.empty() ? why : source.complaint));
  };
  const std::unique_ptr<TIFFOpenOptions, OptionsCloser> options(TIFFOpenOptionsAlloc());
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), complain, &source);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), warn, &source);
  const std::unique_ptr<TIFF, Closer> file(TIFFClientOpenExt("picture", "rm", &source, readBytes, writeNothing, seek,
                                                             closeNothing, sizeOf, nullptr, nullptr, options.get()));
  TIFF* const tiff = file.get();
  if (tiff == nullptr) throw damaged("no directory");

  const auto width = fieldOf<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0);
  const auto height = fieldOf<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0);
  requireSize(name, width, height, limits);
  const auto photometric = fieldOf<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  if (!isRead(photometric))
    throw refuse(fmt::format("PhotometricInterpretation is {}; grey, RGB, palette and YCbCr are read", photometric));
  std::uint16_t* curve[3] = {};
  if (TIFFGetField(tiff, TIFFTAG_TRANSFERFUNCTION, &curve[0], &curve[1], &curve[2]) != 0)
    throw refuse("TransferFunction is not read; an ICC profile is");

  TiffFields fields;
  fields.exif = readExif(bytes);
  fields.exif.orientation = fieldOf<std::uint16_t>(tiff, TIFFTAG_ORIENTATION, 1);
  const auto across = fieldOf<float>(tiff, TIFFTAG_XRESOLUTION, 0.0F),
             down = fieldOf<float>(tiff, TIFFTAG_YRESOLUTION, 0.0F);
  if (across > 0.0F && down > 0.0F) fields.pixel_aspect = double{down} / double{across};
  fields.nits = fieldOf<double>(tiff, TIFFTAG_STONITS, 1.0);
  fields.has_more = TIFFLastDirectory(tiff) == 0;
  float* white = nullptr;
  float* p = nullptr;
  if (TIFFGetField(tiff, TIFFTAG_WHITEPOINT, &white) != 0 && TIFFGetField(tiff, TIFFTAG_PRIMARYCHROMATICITIES, &p) != 0)
    fields.colours = Chromaticities{{double{p[0]}, double{p[1]}},
                                    {double{p[2]}, double{p[3]}},
                                    {double{p[4]}, double{p[5]}},
                                    {double{white[0]}, double{white[1]}}};

  const bool tiled = TIFFIsTiled(tiff) != 0;
  const std::uint32_t count = tiled ? TIFFNumberOfTiles(tiff) : TIFFNumberOfStrips(tiff);
  const tmsize_t size = tiled ? TIFFTileSize(tiff) : TIFFStripSize(tiff);
  // LZW packs at most 2730 bytes into one. Fax codes pack more, but of one bit a texel.
  constexpr std::uint64_t kMostPacked = 4096, kAlways = std::uint64_t{1} << 26;
  if (size <= 0 || static_cast<std::uint64_t>(size) > std::max(kAlways, kMostPacked * bytes.size()))
    throw damaged("strips or tiles of more bytes than the file can hold");
  std::vector<std::byte> texels(static_cast<std::size_t>(size));
  const std::uint32_t rows = std::max(1U, std::min(height, fieldOf<std::uint32_t>(tiff, TIFFTAG_ROWSPERSTRIP, height)));
  const std::uint32_t strips_a_plane = (height + rows - 1) / rows;
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool short_strip = !tiled && i % strips_a_plane == strips_a_plane - 1;
    const tmsize_t expected = short_strip ? TIFFVStripSize(tiff, height - (strips_a_plane - 1) * rows) : size;
    const tmsize_t got =
        tiled ? TIFFReadEncodedTile(tiff, i, texels.data(), size) : TIFFReadEncodedStrip(tiff, i, texels.data(), size);
    if (got != expected || !source.complaint.empty()) throw damaged("a strip or tile ends too early");
  }
  return fields;
}

}  // namespace welkin::image
