// SPDX-License-Identifier: Apache-2.0
#include "sky/image/png_read.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <string_view>
#include <utility>

#include "sky/base/error.h"
#include "sky/image/exif.h"
#include "sky/image/image_header.h"

namespace welkin::image {
namespace {

constexpr png_byte kCicp[] = "cICP";

/// libpng's state. Its errors jump back to the call; no object with a destructor lives in between.
struct PngDecoder {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::span<const std::byte> bytes;
  std::size_t place = 0;
  std::array<char, 256> message{};

  explicit PngDecoder(std::span<const std::byte> file) : bytes(file) {
    png = png_create_read_struct(
        PNG_LIBPNG_VER_STRING, this,
        [](png_structp p, png_const_charp text) {
          auto* self = static_cast<PngDecoder*>(png_get_error_ptr(p));
          std::strncpy(self->message.data(), text, self->message.size() - 1);
          std::longjmp(png_jmpbuf(p), 1);  // NOLINT(cert-err52-cpp): libpng's way out
        },
        [](png_structp, png_const_charp) {});
    info = png == nullptr ? nullptr : png_create_info_struct(png);
    if (info == nullptr) throw base::Error(base::ExitStatus::file, "libpng cannot start");
  }
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;
  ~PngDecoder() { png_destroy_read_struct(&png, &info, nullptr); }

  bool open() {
    if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp)
    png_set_read_fn(png, this, [](png_structp p, png_bytep to, std::size_t count) {
      auto* self = static_cast<PngDecoder*>(png_get_io_ptr(p));
      if (count > self->bytes.size() - self->place) png_error(p, "the file ends too early");
      std::memcpy(to, self->bytes.data() + self->place, count);
      self->place += count;
    });
    png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);  // a chunk about colours must not be dropped
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_ALWAYS, kCicp, 1);
    png_read_info(png, info);
    return true;
  }
  bool read(std::uint8_t* texels, std::size_t row_bytes, png_bytepp rows) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp)
    const png_uint_32 height = png_get_image_height(png, info);
    for (png_uint_32 row = 0; row < height; ++row) rows[row] = texels + row * row_bytes;
    png_read_image(png, rows);
    png_read_end(png, info);
    return true;
  }
  /// Grey or RGB, with alpha if the file has some, of 8 or 16 bits.
  bool prepare() {
    if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp)
    png_set_expand(png);
    png_set_swap(png);
    png_read_update_info(png, info);
    return true;
  }
};

/// Whether the file has a chunk of that name before its texels.
bool hasChunk(std::span<const std::byte> file, std::string_view name) {
  constexpr std::size_t kSignature = 8, kName = 4, kFrame = 12;
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  for (std::size_t at = kSignature; at + kFrame <= text.size();) {
    const std::string_view found = text.substr(at + 4, kName);
    if (found == name) return true;
    if (found == "IDAT") return false;
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8U | static_cast<unsigned char>(text[at + i]);
    if (length > text.size() - at - kFrame) return false;
    at += kFrame + length;
  }
  return false;
}

/// Notes what is left out. libpng drops chunks about colours that contradict each other or themselves.
void noteDropped(const PngDecoder& d, PngPicture& picture) {
  constexpr std::pair<const char*, png_uint_32> kChunks[] = {
      {"gAMA", PNG_INFO_gAMA}, {"cHRM", PNG_INFO_cHRM}, {"sRGB", PNG_INFO_sRGB}, {"iCCP", PNG_INFO_iCCP}};
  for (const auto& [name, flag] : kChunks)
    if (png_get_valid(d.png, d.info, flag) == 0 && hasChunk(d.bytes, name))
      picture.notes.push_back(fmt::format("the chunk {} is damaged or contradicts another; it was ignored", name));
  if (hasChunk(d.bytes, "acTL")) picture.notes.push_back("an animation (acTL); its first picture was read");
}

void readColours(PngDecoder& d, PngPicture& picture) {
  noteDropped(d, picture);
  png_charp name = nullptr;
  int number = 0;
  png_bytep profile = nullptr;
  png_uint_32 size = 0;
  if (png_get_iCCP(d.png, d.info, &name, &number, &profile, &size) != 0) {
    const auto* first = reinterpret_cast<const std::byte*>(profile);
    picture.icc.assign(first, first + size);
  }
  png_unknown_chunkp chunk = nullptr;
  const int chunks = png_get_unknown_chunks(d.png, d.info, &chunk);
  for (int i = 0; i < chunks; ++i)
    if (chunk[i].size == 4 && std::memcmp(chunk[i].name, kCicp, 4) == 0) {
      picture.cicp.emplace();
      std::copy_n(chunk[i].data, 4, picture.cicp->begin());
    }
  if (png_get_valid(d.png, d.info, PNG_INFO_sRGB) != 0) return;
  double file_gamma = 0.0;
  if (png_get_gAMA(d.png, d.info, &file_gamma) != 0 && file_gamma > 0.0) {
    const double gamma = 1.0 / file_gamma;
    constexpr double kSrgb = 2.2, kNear = 0.03;  // sRGB's curve is written this way
    if (std::abs(gamma - kSrgb) >= kNear) picture.gamma = std::abs(gamma - 1.0) < 1e-4 ? 1.0 : gamma;
  }
  double c[8];
  if (png_get_cHRM(d.png, d.info, &c[0], &c[1], &c[2], &c[3], &c[4], &c[5], &c[6], &c[7]) != 0)
    picture.colours = Chromaticities{{c[2], c[3]}, {c[4], c[5]}, {c[6], c[7]}, {c[0], c[1]}};
}

}  // namespace

PngPicture decodePng(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  PngDecoder decoder(bytes);
  const auto damaged = [&] {
    return base::Error(base::ExitStatus::content, fmt::format("{}: damaged or cut: {}", name, decoder.message.data()));
  };
  if (!decoder.open()) throw damaged();
  requireSize(name, png_get_image_width(decoder.png, decoder.info), png_get_image_height(decoder.png, decoder.info),
              limits);
  PngPicture picture;
  picture.width = static_cast<int>(png_get_image_width(decoder.png, decoder.info));
  picture.height = static_cast<int>(png_get_image_height(decoder.png, decoder.info));
  readColours(decoder, picture);
  if (!decoder.prepare()) throw damaged();
  picture.channels = png_get_channels(decoder.png, decoder.info);
  picture.bits = png_get_bit_depth(decoder.png, decoder.info);
  const std::size_t row_bytes = png_get_rowbytes(decoder.png, decoder.info);
  picture.code.resize(row_bytes * static_cast<std::size_t>(picture.height));
  std::vector<png_bytep> rows(static_cast<std::size_t>(picture.height));
  if (!decoder.read(picture.code.data(), row_bytes, rows.data())) throw damaged();
  png_bytep exif = nullptr;
  png_uint_32 exif_size = 0;
  if (png_get_eXIf_1(decoder.png, decoder.info, &exif_size, &exif) != 0)
    picture.exif = readExif(std::as_bytes(std::span(exif, exif_size)));
  constexpr png_uint_32 kColours = PNG_INFO_gAMA | PNG_INFO_cHRM | PNG_INFO_sRGB | PNG_INFO_iCCP;
  if (picture.cicp || png_get_valid(decoder.png, decoder.info, kColours) != 0)
    picture.exif.colours = ExifColours::unsaid;
  png_uint_32 across = 0, down = 0;
  int unit = 0;
  if (png_get_pHYs(decoder.png, decoder.info, &across, &down, &unit) != 0 && across > 0 && down > 0)
    picture.pixel_aspect = static_cast<double>(down) / static_cast<double>(across);
  return picture;
}

}  // namespace welkin::image
