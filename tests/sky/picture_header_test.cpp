// SPDX-License-Identifier: Apache-2.0
// Headers of PNG, TIFF and JPEG: colours, encoding and orientation, in small pictures made here.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>
// jpeglib.h needs what cstdio declares
#include <jpeglib.h>
#include <tiffio.h>

#include "icc_bytes.h"
#include "png_bytes.h"
#include "sh/deterministic.h"
#include "sky/image/colour.h"
#include "sky/image/exif.h"
#include "sky/image/image.h"
#include "tests/folder.h"

namespace welkin::tests {
namespace {

using Chunks = std::vector<std::pair<std::string, std::string>>;
constexpr double kPictureFloat = 4e-7;  // relative: the rounding of a float, times the slope of the decoding
constexpr double kProfile = 4e-4;       // the digits of sRGB's profile: its columns miss D50 by up to 2.6e-4

image::Image decode(const std::string& name, const std::string& bytes) {
  image::ImageLimits limits;
  limits.negative = true;
  return image::readImage(name, std::as_bytes(std::span(bytes)), limits);
}

/// The texel (51, 102, 204) of 8 bits, with chunks before it.
image::Image png(const Chunks& chunks) {
  return decode("a.png", pngOf(1, 1, 8, 2, chunks, {"\x33\x66\xcc"}));
}

void requireTexel(const image::Image& image, const std::array<double, 3>& colour, double tolerance = kPictureFloat) {
  for (std::size_t c = 0; c < 3; ++c) {
    CAPTURE(c);
    REQUIRE(double{image.rgb[c]} == Approx(colour[c]).epsilon(tolerance).margin(tolerance));
  }
}

std::array<double, 3> powers(double exponent) {
  return {std::pow(0.2, exponent), std::pow(0.4, exponent), std::pow(0.8, exponent)};
}

const std::array<double, 3> kSrgb = {det::srgbDecode(0.2), det::srgbDecode(0.4), det::srgbDecode(0.8)};

std::string primaries(const image::Chromaticities& colours) {
  std::string text;
  for (const auto& xy : {colours.white, colours.red, colours.green, colours.blue})
    for (const double v : xy) text += bigEndian(static_cast<std::uint32_t>(std::lround(v * 1e5)));
  return text;
}

const image::Chromaticities kRec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}};

std::array<double, 3> converted(const std::array<double, 3>& v, const image::Chromaticities& from) {
  const det::Number3 colour = *image::toRec709(from) * det::Number3(v[0], v[1], v[2]);
  return {colour.x, colour.y, colour.z};
}

std::pair<std::string, std::string> iccp(const std::string& profile) {
  return {"iCCP", std::string("test\0\0", 6) + stored(profile)};
}

/// Exif with one entry, Orientation, in either order of bytes.
std::string exif(int orientation, bool little) {
  if (!little)
    return std::string("MM\0*", 4) + bigEndian(8) + bigEndian(1, 2) + bigEndian(274, 2) + bigEndian(3, 2) +
           bigEndian(1) + bigEndian(static_cast<std::uint32_t>(orientation), 2) + std::string(6, '\0');
  std::string text("II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0", 18);
  return text + static_cast<char>(orientation) + std::string(7, '\0');
}

/// An entry of a directory of TIFF, in Motorola's order. Shorts and texts fill the value from the left.
std::string entry(std::uint32_t tag, std::uint32_t type, std::uint32_t count, const std::string& value) {
  return bigEndian(tag, 2) + bigEndian(type, 2) + bigEndian(count) + value + std::string(4 - value.size(), '\0');
}

std::string directory(const std::vector<std::string>& entries) {
  std::string text = bigEndian(static_cast<std::uint32_t>(entries.size()), 2);
  for (const std::string& e : entries) text += e;
  return text + bigEndian(0);
}

/// A TIFF file, or Exif, of a first directory with `entries` and a pointer to Exif's, which has a ColorSpace and,
/// unless `index` is empty, an InteroperabilityIndex.
std::string exifColours(int space, const std::string& index, std::vector<std::string> entries = {}) {
  const auto sizeOf = [](std::size_t count) { return static_cast<std::uint32_t>(6 + 12 * count); };
  const std::uint32_t exif_at = 8 + sizeOf(entries.size() + 1), index_at = exif_at + sizeOf(2);
  entries.push_back(entry(34665, 4, 1, bigEndian(exif_at)));
  return std::string("MM\0*", 4) + bigEndian(8) + directory(entries) +
         directory({entry(40961, 3, 1, bigEndian(static_cast<std::uint32_t>(space), 2)),
                    entry(40965, 4, 1, bigEndian(index.empty() ? 0xffffU : index_at))}) +
         (index.empty() ? "" : directory({entry(1, 2, 4, index)}));
}

const image::Chromaticities kAdobeRgb{{0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}, {0.3127, 0.3290}};
constexpr double kAdobeGamma = 563.0 / 256.0;

/// Places of the four corners of the upright picture, 0 the file's first row's first texel, 1 that row's last, 2 and 3
/// the last row's: upper left, upper right, lower left, lower right. From TIFF 6.0's words on Orientation.
constexpr std::array<std::array<int, 4>, 8> kCorners = {{{0, 1, 2, 3},    // 1: rows from the top, columns from the left
                                                         {1, 0, 3, 2},    // 2: columns from the right
                                                         {3, 2, 1, 0},    // 3: both turned
                                                         {2, 3, 0, 1},    // 4: rows from the bottom
                                                         {0, 2, 1, 3},    // 5: row 0 is the left side
                                                         {2, 0, 3, 1},    // 6: row 0 is the right side
                                                         {3, 1, 2, 0},    // 7: row 0 is the right side, from the bottom
                                                         {1, 3, 0, 2}}};  // 8: row 0 is the left side, from the bottom

/// Reads a picture of 3 x 2 whose corners in the file are 0, 1/4, 1/2 and 1, and checks where they come to lie.
void requireUpright(const image::Image& image, int orientation, const std::function<double(int)>& level,
                    double tolerance) {
  INFO("orientation " << orientation);
  const bool columns = orientation >= 5;
  REQUIRE(image.width == (columns ? 2 : 3));
  REQUIRE(image.height == (columns ? 3 : 2));
  const auto width = static_cast<std::size_t>(image.width), texels = image.rgb.size() / 3;
  const std::array<std::size_t, 4> corner = {0, width - 1, texels - width, texels - 1};
  for (std::size_t i = 0; i < 4; ++i) {
    CAPTURE(i);
    const int in_file = kCorners[static_cast<std::size_t>(orientation - 1)][i];
    REQUIRE(double{image.rgb[3 * corner[i]]} == Approx(level(in_file)).margin(tolerance));
  }
}

constexpr std::array<unsigned char, 6> kCornerCodes = {0, 30, 64, 128, 200, 255};  // of 3 x 2, corners 0, 64, 128, 255

double cornerLevel(int corner) {
  return det::srgbDecode(std::array{0.0, 64.0, 128.0, 255.0}[static_cast<std::size_t>(corner)] / 255.0);
}

struct Jpeg {
  std::string exif, icc;
  bool cmyk = false;
  UINT16 lines_per_column = 1;  ///< JFIF's density down, beside 1 across
};

/// A picture of blocks of 16 x 16 of one code each, so that the codec keeps them. 3 x 2 blocks.
std::string jpegOf(const Jpeg& jpeg) {
  jpeg_compress_struct state{};
  jpeg_error_mgr errors{};
  state.err = jpeg_std_error(&errors);
  jpeg_create_compress(&state);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&state, &buffer, &size);
  state.image_width = 48;
  state.image_height = 32;
  state.input_components = jpeg.cmyk ? 4 : 1;
  state.in_color_space = jpeg.cmyk ? JCS_CMYK : JCS_GRAYSCALE;
  jpeg_set_defaults(&state);
  jpeg_set_quality(&state, 100, TRUE);
  state.Y_density = jpeg.lines_per_column;
  jpeg_start_compress(&state, TRUE);
  const auto* bytes = [](const std::string& text) { return reinterpret_cast<const JOCTET*>(text.data()); }(jpeg.exif);
  if (!jpeg.exif.empty()) jpeg_write_marker(&state, JPEG_APP0 + 1, bytes, static_cast<unsigned>(jpeg.exif.size()));
  if (!jpeg.icc.empty())
    jpeg_write_icc_profile(&state, reinterpret_cast<const JOCTET*>(jpeg.icc.data()),
                           static_cast<unsigned>(jpeg.icc.size()));
  std::vector<unsigned char> row(static_cast<std::size_t>(48 * state.input_components));
  while (state.next_scanline < 32) {
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = kCornerCodes[state.next_scanline / 16 * 3 + i / static_cast<std::size_t>(state.input_components) / 16];
    unsigned char* line = row.data();
    jpeg_write_scanlines(&state, &line, 1);
  }
  jpeg_finish_compress(&state);
  std::string file(reinterpret_cast<const char*>(buffer), size);
  jpeg_destroy_compress(&state);
  std::free(buffer);
  return file;
}

/// A grey 3 x 2 TIFF of kCornerCodes, or of one RGB texel, after `set` has given it fields.
image::Image tiff(const std::function<void(TIFF*)>& set, bool one_texel = false) {
  const Folder folder;
  const std::string path = folder / "a.tif";
  TIFF* file = TIFFOpen(path.c_str(), "w");
  REQUIRE(file != nullptr);
  TIFFSetField(file, TIFFTAG_IMAGEWIDTH, one_texel ? 1 : 3);
  TIFFSetField(file, TIFFTAG_IMAGELENGTH, one_texel ? 1 : 2);
  TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8);
  TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, one_texel ? 3 : 1);
  TIFFSetField(file, TIFFTAG_PHOTOMETRIC, one_texel ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
  TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  set(file);
  std::array<unsigned char, 6> codes = kCornerCodes;
  if (one_texel) codes = {0x33, 0x66, 0xcc, 0, 0, 0};
  std::vector<unsigned char> line(static_cast<std::size_t>(TIFFScanlineSize(file)));
  for (std::uint32_t row = 0; row < (one_texel ? 1U : 2U); ++row) {
    std::copy_n(codes.begin() + 3 * row, 3, line.begin());
    REQUIRE(TIFFWriteScanline(file, line.data(), row, 0) == 1);
  }
  TIFFClose(file);
  return decode(path, readBytes(path));
}

}  // namespace

TEST_CASE("PictureHeader, PngGamma") {
  requireTexel(png({}), kSrgb);
  requireTexel(png({{"gAMA", bigEndian(45455)}}), kSrgb);  // the way in which sRGB's curve is written
  requireTexel(png({{"gAMA", bigEndian(100000)}}), powers(1.0));
  requireTexel(png({{"gAMA", bigEndian(55556)}}), powers(1e5 / 55556.0));  // 1.8
  requireTexel(png({{"gAMA", bigEndian(50000)}}), powers(2.0));
  requireTexel(png({{"sRGB", std::string(1, '\0')}, {"gAMA", bigEndian(45455)}}), kSrgb);
}

TEST_CASE("PictureHeader, PngPrimaries") {
  REQUIRE(png({{"cHRM", primaries(image::kRec709)}}).notes.empty());
  const image::Image image = png({{"gAMA", bigEndian(50000)}, {"cHRM", primaries(kRec2020)}});
  requireTexel(image, converted(powers(2.0), kRec2020), 2e-5);  // libpng keeps five digits
  REQUIRE(image.notes.size() == 1);
  REQUIRE_THAT(image.notes[0], Catch::Contains("red (0.708, 0.292)") && Catch::Contains("converted to Rec. 709"));
  // sRGB comes first.
  REQUIRE(png({{"sRGB", std::string(1, '\0')}, {"cHRM", primaries(image::kRec709)}}).notes.empty());
}

TEST_CASE("PictureHeader, PngCodePoints") {
  const auto cicp = [](int primaries, int transfer, int matrix = 0, int full = 1) {
    return png({{"cICP",
                 {static_cast<char>(primaries), static_cast<char>(transfer), static_cast<char>(matrix),
                  static_cast<char>(full)}},
                {"gAMA", bigEndian(50000)}});
  };
  requireTexel(cicp(1, 13), kSrgb);
  requireTexel(cicp(1, 8), powers(1.0));
  requireTexel(cicp(9, 8), converted(powers(1.0), kRec2020));
  requireTexel(cicp(12, 13), converted(kSrgb, {{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}}));
  REQUIRE_THROWS_WITH(cicp(9, 16), Catch::Contains("a.png: the chunk cICP is 9 16 0 1; primaries 1, 9 and 12"));
  REQUIRE_THROWS_WITH(cicp(2, 13), Catch::Contains("cICP is 2 13 0 1"));
  REQUIRE_THROWS_WITH(cicp(1, 13, 1), Catch::Contains("cICP is 1 13 1 1"));
  REQUIRE_THROWS_WITH(cicp(1, 13, 0, 0), Catch::Contains("cICP is 1 13 0 0"));
}

TEST_CASE("PictureHeader, PngProfiles") {
  const image::Image square = png({iccp(rgbProfile(gammaTag(2.0)))});
  requireTexel(square, powers(2.0), kProfile);
  REQUIRE(square.notes.empty());  // the primaries are Rec. 709's
  // A profile comes before gAMA and cHRM.
  requireTexel(png({iccp(rgbProfile(gammaTag(2.0))), {"gAMA", bigEndian(100000)}}), powers(2.0), kProfile);
  // Red and green change places.
  const image::Image swapped = png({iccp(rgbProfile(gammaTag(1.0), true))});
  requireTexel(swapped, {0.4, 0.2, 0.8}, kProfile);
  REQUIRE(swapped.notes.size() == 1);
  REQUIRE_THAT(swapped.notes[0], Catch::Contains("the ICC profile were converted"));
  // Curves: a table, linear between its rows, and the parametric types, each with a value below its d.
  requireTexel(png({iccp(rgbProfile(tableTag({0.0, 0.1, 1.0})))}), {0.04, 0.08, 0.64}, kProfile);
  requireTexel(png({iccp(rgbProfile("curv" + bigEndian(0) + bigEndian(0)))}), powers(1.0), kProfile);
  requireTexel(png({iccp(rgbProfile(parametricTag(0, {3.0})))}), powers(3.0), kProfile);
  requireTexel(png({iccp(rgbProfile(parametricTag(1, {2.0, 1.25, -0.25})))}),
               {0.0, std::pow(0.25, 2), std::pow(0.75, 2)}, kProfile);
  requireTexel(png({iccp(rgbProfile(parametricTag(2, {2.0, 1.25, -0.25, 0.125})))}),
               {0.125, 0.125 + std::pow(0.25, 2), 0.125 + std::pow(0.75, 2)}, kProfile);
  requireTexel(png({iccp(rgbProfile(parametricTag(3, {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045})))}), kSrgb,
               kProfile);
  requireTexel(png({iccp(rgbProfile(parametricTag(4, {1.0, 0.5, 0.0, 0.25, 0.3, 0.125, 0.0625})))}),
               {0.05 + 0.0625, 0.2 + 0.125, 0.4 + 0.125}, kProfile);
  const image::Image grey =
      decode("a.png", pngOf(1, 1, 8, 0, {iccp(iccOf("GRAY", {{"kTRC", gammaTag(2.0)}}))}, {"\x33"}));
  requireTexel(grey, {0.04, 0.04, 0.04}, kProfile);
}

TEST_CASE("PictureHeader, ProfilesThatCannotBeHonouredAreRefusedOrSaid") {
  const std::string curve = gammaTag(1.0);
  REQUIRE_THROWS_WITH(png({iccp(iccOf("RGB ", {{"A2B0", std::string(64, '\0')}}))}),
                      Catch::Contains("a.png: ICC profile: a table of colours"));
  REQUIRE_THROWS_WITH(png({iccp(rgbProfile(parametricTag(5, {1.0})))}), Catch::Contains("a curve of type 5; 0 to 4"));
  REQUIRE_THROWS_WITH(png({iccp(rgbProfile("text" + bigEndian(0)))}), Catch::Contains("rTRC is no curve"));
  REQUIRE_THROWS_WITH(png({iccp(rgbProfile("curv" + bigEndian(0) + bigEndian(9999)))}),
                      Catch::Contains("damaged or cut"));
  // libpng drops these; a note says so.
  const image::Image foreign = png({iccp("no profile at all")});
  REQUIRE(foreign.notes.size() == 1);
  REQUIRE_THAT(foreign.notes[0], Catch::Contains("the chunk iCCP is damaged or contradicts another"));
  requireTexel(foreign, kSrgb);
  const image::Image moving = png({{"acTL", bigEndian(2) + bigEndian(0)}});
  REQUIRE(moving.notes == std::vector<std::string>{"an animation (acTL); its first picture was read"});
  const image::Image flat = png({{"gAMA", bigEndian(0)}});
  REQUIRE(flat.notes.size() == 1);
  REQUIRE_THAT(flat.notes[0], Catch::Contains("the chunk gAMA"));
}

TEST_CASE("PictureHeader, PngTurns") {
  for (const bool little : {false, true})
    for (int orientation = 1; orientation <= 8; ++orientation) {
      const std::string row(kCornerCodes.begin(), kCornerCodes.begin() + 3);
      const std::string last(kCornerCodes.begin() + 3, kCornerCodes.end());
      requireUpright(decode("a.png", pngOf(3, 2, 8, 0, {{"eXIf", exif(orientation, little)}}, {row, last})),
                     orientation, cornerLevel, kPictureFloat);
    }
}

TEST_CASE("PictureHeader, ExifSaysAdobeRgb") {
  const std::array<double, 3> adobe = converted(powers(kAdobeGamma), kAdobeRgb);
  for (const auto& [space, index] : {std::pair(65535, "R03"), std::pair(2, "")}) {
    const image::Image image = png({{"eXIf", exifColours(space, index)}});
    requireTexel(image, adobe);
    REQUIRE(image.notes.size() == 2);
    REQUIRE_THAT(image.notes[0], Catch::Contains("Adobe RGB (1998)"));
    REQUIRE_THAT(image.notes[1], Catch::Contains("green (0.21, 0.71)"));
  }
  // R98 is sRGB's index; 65535 beside it is no colour space.
  for (const char* index : {"", "R98"}) {
    const image::Image image = png({{"eXIf", exifColours(65535, index)}});
    requireTexel(image, kSrgb);
    REQUIRE(image.notes.size() == 1);
    REQUIRE_THAT(image.notes[0], Catch::Contains("Exif's ColorSpace is 65535, uncalibrated"));
  }
  REQUIRE(png({{"eXIf", exifColours(1, "R98")}}).notes.empty());
  // PNG's own chunks come first, and so does a profile.
  const auto beside = [](const Chunks& chunks) {
    Chunks all = chunks;
    all.push_back({"eXIf", exifColours(65535, "R03")});
    return png(all);
  };
  requireTexel(beside({{"sRGB", std::string(1, '\0')}}), kSrgb);
  requireTexel(beside({{"gAMA", bigEndian(45455)}}), kSrgb);
  requireTexel(beside({iccp(rgbProfile(gammaTag(2.0)))}), powers(2.0), kProfile);
  // Every cut keeps within the bytes and says nothing that is not there.
  const std::string whole = exifColours(65535, "R03");
  for (std::size_t size = 0; size < whole.size() - 10; ++size) {
    CAPTURE(size);
    const image::ExifFields cut = image::readExif(std::as_bytes(std::span(whole).first(size)));
    REQUIRE(cut.orientation == 1);
    REQUIRE(cut.colours != image::ExifColours::adobe_rgb);
  }
}

TEST_CASE("PictureHeader, ExifOfTiffSaysAdobeRgb") {
  const auto file = [](const std::string& index) {
    const auto number = [](std::uint32_t tag, std::uint32_t v) { return entry(tag, 4, 1, bigEndian(v)); };
    const auto shortOf = [](std::uint32_t tag, std::uint32_t v) { return entry(tag, 3, 1, bigEndian(v, 2)); };
    const auto bytes = [&](std::uint32_t strip_at) {
      return exifColours(65535, index,
                         {number(256, 1), number(257, 1), shortOf(258, 8), shortOf(262, 2), number(273, strip_at),
                          shortOf(277, 3), number(278, 1), number(279, 3)});
    };
    const auto size = static_cast<std::uint32_t>(bytes(0).size());
    return decode("a.tif", bytes(size) + "\x33\x66\xcc");
  };
  requireTexel(file("R03"), converted(powers(kAdobeGamma), kAdobeRgb));
  const image::Image unknown = file("");
  requireTexel(unknown, kSrgb);
  REQUIRE_THAT(unknown.notes.at(0), Catch::Contains("65535, uncalibrated"));
}

TEST_CASE("PictureHeader, PixelsThatAreNotSquareAreSaid") {
  const auto physical = [](std::uint32_t across, std::uint32_t down, char unit) {
    return png({{"pHYs", bigEndian(across) + bigEndian(down) + unit}}).notes;
  };
  REQUIRE(physical(2834, 2835, '\1').empty());
  REQUIRE(physical(0, 7, '\0').empty());
  const auto wide = physical(100, 200, '\0');
  REQUIRE(wide.size() == 1);
  REQUIRE_THAT(wide[0], Catch::Contains("pHYs: pixels are 2 times as wide as high"));
  const auto resolved = [](float across, float down) {
    return tiff([&](TIFF* file) {
             TIFFSetField(file, TIFFTAG_XRESOLUTION, double{across});
             TIFFSetField(file, TIFFTAG_YRESOLUTION, double{down});
           })
        .notes;
  };
  REQUIRE(resolved(72.0F, 72.0F).empty());
  REQUIRE(resolved(0.0F, 72.0F).empty());
  REQUIRE_THAT(resolved(72.0F, 36.0F).at(0), Catch::Contains("XResolution and YResolution: pixels are 0.5 times"));
}

TEST_CASE("PictureHeader, TiffTurns") {
  for (int orientation = 1; orientation <= 8; ++orientation)
    requireUpright(tiff([&](TIFF* file) { TIFFSetField(file, TIFFTAG_ORIENTATION, orientation); }), orientation,
                   cornerLevel, kPictureFloat);
}

TEST_CASE("PictureHeader, TiffColours") {
  const auto colours = [](TIFF* file) {
    float white[2] = {0.3127F, 0.3290F}, p[6] = {0.708F, 0.292F, 0.170F, 0.797F, 0.131F, 0.046F};
    TIFFSetField(file, TIFFTAG_WHITEPOINT, white);
    TIFFSetField(file, TIFFTAG_PRIMARYCHROMATICITIES, p);
  };
  const image::Image image = tiff(colours, true);
  requireTexel(image, converted(kSrgb, kRec2020), 1e-6);
  REQUIRE(image.notes.size() == 1);
  const std::string profile = rgbProfile(gammaTag(2.0));
  const auto icc = [&](TIFF* file) {
    TIFFSetField(file, TIFFTAG_ICCPROFILE, static_cast<std::uint32_t>(profile.size()), profile.data());
  };
  requireTexel(tiff(icc, true), powers(2.0), kProfile);
  requireTexel(tiff([](TIFF*) {}, true), kSrgb);
}

TEST_CASE("PictureHeader, TiffGreysFromWhiteAndFurtherPictures") {
  const image::Image image = tiff([](TIFF* file) { TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISWHITE); });
  REQUIRE(double{image.rgb[0]} == Approx(1.0));
  REQUIRE(double{image.rgb.back()} == Approx(0.0));
  REQUIRE(image.notes.empty());
  const Folder folder;
  const std::string path = folder / "a.tif";
  TIFF* file = TIFFOpen(path.c_str(), "w");
  for (unsigned char page = 1; page <= 2; ++page) {
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, 1);
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, 1);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    REQUIRE(TIFFWriteScanline(file, &page, 0, 0) == 1);
    REQUIRE(TIFFWriteDirectory(file) == 1);
  }
  TIFFClose(file);
  const image::Image pages = decode(path, readBytes(path));
  REQUIRE(double{pages.rgb[0]} == Approx(1.0 / 255.0 / 12.92).epsilon(kPictureFloat));
  REQUIRE(pages.notes == std::vector<std::string>{"the first picture was read; those behind it were left out"});
}

TEST_CASE("PictureHeader, TiffStoNitsIsSaid") {
  const image::Image image = tiff([](TIFF* file) { TIFFSetField(file, TIFFTAG_STONITS, 179.0); }, true);
  requireTexel(image, kSrgb);
  REQUIRE(image.notes == std::vector<std::string>{"StoNits is 179; values are not multiplied by it"});
}

TEST_CASE("PictureHeader, TiffFieldsThatAreNotReadAreRefused") {
  REQUIRE_THROWS_WITH(tiff([](TIFF* file) { TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_CIELAB); }, true),
                      Catch::Contains("PhotometricInterpretation is 8"));
  std::vector<std::uint16_t> curve(256, 7);
  const auto transfer = [&](TIFF* file) { TIFFSetField(file, TIFFTAG_TRANSFERFUNCTION, curve.data()); };
  REQUIRE_THROWS_WITH(tiff(transfer), Catch::Contains("TransferFunction"));
  // A strip of 1.6 GB that a file of some hundred bytes cannot hold. Packed, so that its size is not told by the
  // file's.
  const auto huge = [](TIFF* file) {
    TIFFSetField(file, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, 16384);
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, 1024);
    TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, 1024);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 64);
    TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
  };
  REQUIRE_THROWS_WITH(tiff(huge), Catch::Contains("strips or tiles of more bytes than the file can hold"));
}

TEST_CASE("PictureHeader, JpegTurns") {
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const image::Image image =
        decode("a.jpg", jpegOf({std::string("Exif\0\0", 6) + exif(orientation, orientation % 2 == 0), "", false}));
    // One texel of each block.
    image::Image blocks;
    blocks.width = image.width / 16;
    blocks.height = image.height / 16;
    for (int y = 0; y < blocks.height; ++y)
      for (int x = 0; x < blocks.width; ++x)
        for (int c = 0; c < 3; ++c)
          blocks.rgb.push_back(image.rgb[static_cast<std::size_t>(3 * ((16 * y + 8) * image.width + 16 * x + 8) + c)]);
    requireUpright(blocks, orientation, cornerLevel, 0.01);  // the codec's rounding: a code of 255
  }
}

TEST_CASE("PictureHeader, JpegInAdobeRgbAndWithPixelsThatAreNotSquare") {
  const std::string start("Exif\0\0", 6);
  const auto at128 = static_cast<std::size_t>(3 * (24 * 48 + 8));
  const image::Image adobe = decode("a.jpg", jpegOf({start + exifColours(65535, "R03"), "", false}));
  REQUIRE(double{adobe.rgb[at128]} == Approx(std::pow(128.0 / 255.0, kAdobeGamma)).margin(0.005));
  REQUIRE_THAT(adobe.notes.at(0), Catch::Contains("Adobe RGB (1998)"));
  const image::Image unknown = decode("a.jpg", jpegOf({start + exifColours(65535, ""), "", false}));
  REQUIRE(double{unknown.rgb[at128]} == Approx(det::srgbDecode(128.0 / 255.0)).margin(0.005));
  REQUIRE_THAT(unknown.notes.at(0), Catch::Contains("uncalibrated"));
  // A profile comes first.
  const std::string profile = iccOf("GRAY", {{"kTRC", gammaTag(1.0)}});
  const image::Image both = decode("a.jpg", jpegOf({start + exifColours(65535, "R03"), profile, false}));
  REQUIRE(double{both.rgb[at128]} == Approx(128.0 / 255.0).margin(0.005));

  REQUIRE(decode("a.jpg", jpegOf({"", "", false})).notes.empty());
  const image::Image wide = decode("a.jpg", jpegOf({"", "", false, 2}));
  REQUIRE(wide.notes.size() == 1);
  REQUIRE_THAT(wide.notes[0], Catch::Contains("JFIF: pixels are 2 times as wide as high"));
}

TEST_CASE("PictureHeader, JpegProfilesAndCmyk") {
  const std::string profile = iccOf("GRAY", {{"kTRC", gammaTag(1.0)}});
  const image::Image linear = decode("a.jpg", jpegOf({"", profile, false}));
  REQUIRE(double{linear.rgb.back()} == Approx(1.0).margin(0.01));
  REQUIRE(double{linear.rgb[static_cast<std::size_t>(3 * (24 * 48 + 8))]} == Approx(128.0 / 255.0).margin(0.005));
  REQUIRE_THROWS_WITH(decode("a.jpg", jpegOf({"", "", true})), Catch::Contains("a.jpg: 4 colours, such as CMYK"));
}

}  // namespace welkin::tests
