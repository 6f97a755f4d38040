// SPDX-License-Identifier: Apache-2.0
#include "sky/image/jpeg_read.h"

#include <fmt/format.h>
#include <jpeglib.h>

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>
// jerror.h needs what jpeglib.h declares
#include <jerror.h>

#include "sky/base/error.h"
#include "sky/image/image_header.h"

namespace welkin::image {
namespace {

constexpr int kExif = JPEG_APP0 + 1;
constexpr int kIcc = JPEG_APP0 + 2;

/// libjpeg's state. Its errors jump back to the call; no object with a destructor lives in between.
struct JpegDecoder {
  jpeg_decompress_struct state{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf back{};
  char message[JMSG_LENGTH_MAX] = "";

  JpegDecoder() {
    state.err = jpeg_std_error(&errors);
    state.client_data = this;
    errors.error_exit = [](j_common_ptr s) { fail(s); };
    errors.emit_message = [](j_common_ptr s, int level) {
      // Bytes between markers and Adobe's unknown colour transforms lose no texel.
      const int code = s->err->msg_code;
      if (level < 0 && code != JWRN_EXTRANEOUS_DATA && code != JWRN_ADOBE_XFORM) fail(s);
    };
    errors.output_message = [](j_common_ptr) {};
  }
  JpegDecoder(const JpegDecoder&) = delete;
  JpegDecoder& operator=(const JpegDecoder&) = delete;
  ~JpegDecoder() { jpeg_destroy_decompress(&state); }

  bool open(std::span<const std::byte> bytes) {
    if (setjmp(back) != 0) return false;  // NOLINT(cert-err52-cpp): libjpeg's way out
    jpeg_create_decompress(&state);
    // Each scan of a few bytes may pass over the whole picture. Encoders write some ten.
    progress.progress_monitor = [](j_common_ptr s) {
      constexpr int kMostScans = 200;
      if (reinterpret_cast<j_decompress_ptr>(s)->input_scan_number <= kMostScans) return;
      auto* self = static_cast<JpegDecoder*>(s->client_data);
      std::snprintf(self->message, sizeof self->message, "more than %d scans", kMostScans);
      std::longjmp(self->back, 1);  // NOLINT(cert-err52-cpp)
    };
    state.progress = &progress;
    jpeg_mem_src(&state, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    jpeg_save_markers(&state, kExif, 0xffff);
    jpeg_save_markers(&state, kIcc, 0xffff);
    jpeg_read_header(&state, TRUE);
    return true;
  }
  /// Reads all rows, and the file's end behind them.
  bool read(std::uint8_t* texels) {
    if (setjmp(back) != 0) return false;  // NOLINT(cert-err52-cpp)
    state.out_color_space = state.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
    state.dct_method = JDCT_ISLOW;
    jpeg_start_decompress(&state);
    while (state.output_scanline < state.output_height) {
      JSAMPROW row = texels + static_cast<std::size_t>(state.output_scanline) * state.output_width *
                                  static_cast<std::size_t>(state.output_components);
      jpeg_read_scanlines(&state, &row, 1);
    }
    jpeg_finish_decompress(&state);
    return true;
  }
  bool readIcc(JOCTET** profile, unsigned* size) {
    if (setjmp(back) != 0) return false;  // NOLINT(cert-err52-cpp)
    return jpeg_read_icc_profile(&state, profile, size) != FALSE;
  }

 private:
  [[noreturn]] static void fail(j_common_ptr s) {
    auto* self = static_cast<JpegDecoder*>(s->client_data);
    s->err->format_message(s, self->message);
    std::longjmp(self->back, 1);  // NOLINT(cert-err52-cpp)
  }
};

}  // namespace

JpegPicture decodeJpeg(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits) {
  JpegDecoder decoder;
  const auto refuse = [&](const std::string& why) {
    return base::Error(base::ExitStatus::content, fmt::format("{}: {}", name, why));
  };
  if (!decoder.open(bytes)) throw refuse(fmt::format("damaged or cut: {}", decoder.message));
  const jpeg_decompress_struct& state = decoder.state;
  requireSize(name, state.image_width, state.image_height, limits);
  if (state.num_components != 1 && state.num_components != 3)
    throw refuse(fmt::format("{} colours, such as CMYK; grey and RGB are allowed", state.num_components));
  JpegPicture picture;
  picture.width = static_cast<int>(state.image_width);
  picture.height = static_cast<int>(state.image_height);
  picture.channels = state.num_components;
  picture.code.resize(std::size_t{state.image_width} * state.image_height * static_cast<std::size_t>(picture.channels));
  for (auto* marker = state.marker_list; marker != nullptr; marker = marker->next) {
    const std::string_view data(reinterpret_cast<const char*>(marker->data), marker->data_length);
    constexpr std::string_view kStart("Exif\0\0", 6);
    if (marker->marker == kExif && data.starts_with(kStart))
      picture.exif = readExif(std::as_bytes(std::span(data.substr(kStart.size()))));
  }
  if (state.saw_JFIF_marker != FALSE && state.X_density > 0 && state.Y_density > 0)
    picture.pixel_aspect = static_cast<double>(state.Y_density) / static_cast<double>(state.X_density);
  JOCTET* profile = nullptr;
  unsigned size = 0;
  if (decoder.readIcc(&profile, &size)) {
    const auto* first = reinterpret_cast<const std::byte*>(profile);
    picture.icc.assign(first, first + size);
    std::free(profile);
  }
  if (!decoder.read(picture.code.data())) throw refuse(fmt::format("damaged or cut: {}", decoder.message));
  return picture;
}

}  // namespace welkin::image
