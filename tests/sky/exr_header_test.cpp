// SPDX-License-Identifier: Apache-2.0
// OpenEXR files whose header says what their numbers mean: chromaticities, luminance and chroma, windows, layers,
// views.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "sky/base/error.h"
#include "sky/image/colour.h"
#include "sky/image/image.h"
#include "tests/folder.h"

namespace welkin::tests {

using det::Number3;
namespace {

constexpr double kHeaderFloat = 1e-6;  // relative: a few roundings of floats

/// A channel's value at (x, y) of the data window.
using Channel = float (*)(int x, int y);

struct Stored {
  Channel value;
  int step = 1;
};

/// Adds float channels to the header, and their samples to the frame buffer.
void fill(Imf::Header& header, Imf::FrameBuffer& frame, const std::map<std::string, Stored>& channels,
          std::map<std::string, std::vector<float>>& kept) {
  const Imath::Box2i window = header.dataWindow();
  for (const auto& [name, stored] : channels) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT, stored.step, stored.step));
    std::vector<float>& sample = kept[header.hasName() ? header.name() + name : name];
    const int width = (window.max.x - window.min.x) / stored.step + 1;
    for (int y = window.min.y; y <= window.max.y; y += stored.step)
      for (int x = window.min.x; x <= window.max.x; x += stored.step) sample.push_back(stored.value(x, y));
    frame.insert(name, Imf::Slice::Make(Imf::FLOAT, sample.data(), window, sizeof(float),
                                        sizeof(float) * static_cast<std::size_t>(width), stored.step, stored.step));
  }
}

/// Writes the channels, named as in the file, and reads the picture back.
image::Image roundTrip(Imf::Header header, const std::map<std::string, Stored>& channels,
                       const image::ImageLimits& limits = {}, const std::string& layer = "") {
  const Folder folder;
  Imf::FrameBuffer frame;
  std::map<std::string, std::vector<float>> kept;
  fill(header, frame, channels, kept);
  {
    Imf::OutputFile file((folder / "a.exr").c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(header.dataWindow().max.y - header.dataWindow().min.y + 1);
  }
  return image::readImage(std::filesystem::path(folder / "a.exr"), limits, layer);
}

void requireTexel(const image::Image& image, int x, int y, const Number3& colour) {
  const auto i = 3 * static_cast<std::size_t>(y * image.width + x);
  for (int c = 0; c < 3; ++c) {
    CAPTURE(x, y, c);
    REQUIRE(double{image.rgb[i + static_cast<std::size_t>(c)]} ==
            Approx(colour[c]).epsilon(kHeaderFloat).margin(kHeaderFloat));
  }
}

float zero(int, int) {
  return 0.0F;
}
float half(int, int) {
  return 0.5F;
}
float one(int, int) {
  return 1.0F;
}
float two(int, int) {
  return 2.0F;
}

}  // namespace

TEST_CASE("ExrHeader, ChromaticitiesBecomeRec709") {
  Imf::Header header(2, 1);
  Imf::addChromaticities(
      header, Imf::Chromaticities({0.713F, 0.293F}, {0.165F, 0.83F}, {0.128F, 0.044F}, {0.32168F, 0.33767F}));
  const image::Image white = roundTrip(header, {{"R", {two}}, {"G", {two}}, {"B", {two}}});
  requireTexel(white, 1, 0, Number3(2.0));
  REQUIRE(white.notes.size() == 1);
  REQUIRE_THAT(white.notes[0], Catch::Contains("0.713") && Catch::Contains("converted to Rec. 709"));

  image::ImageLimits negative;
  negative.negative = true;
  const std::map<std::string, Stored> red = {{"R", {one}}, {"G", {zero}}, {"B", {zero}}};
  const image::Image image = roundTrip(header, red, negative);
  REQUIRE(double{image.rgb[0]} == Approx(1.70505).margin(1e-5));
  REQUIRE(double{image.rgb[1]} == Approx(-0.13026).margin(1e-5));
  REQUIRE_THROWS_WITH(roundTrip(header, red), Catch::Contains("channel 1, converted to Rec. 709"));
}

TEST_CASE("ExrHeader, Rec709AndNoChromaticitiesAreTakenAsTheyAre") {
  for (const bool named : {false, true}) {
    Imf::Header header(1, 1);
    if (named) Imf::addChromaticities(header, Imf::Chromaticities());
    const image::Image image = roundTrip(header, {{"R", {half}}, {"G", {one}}, {"B", {two}}});
    REQUIRE(image.rgb == std::vector<float>{0.5F, 1.0F, 2.0F});
    REQUIRE(image.notes.empty());
  }
}

TEST_CASE("ExrHeader, ImpossibleChromaticitiesAreRefused") {
  Imf::Header header(1, 1);
  Imf::addChromaticities(header, Imf::Chromaticities({0.3F, 0.3F}, {0.3F, 0.3F}, {0.3F, 0.3F}, {0.3F, 0.3F}));
  REQUIRE_THROWS_WITH(roundTrip(header, {{"R", {one}}, {"G", {one}}, {"B", {one}}}),
                      Catch::Contains("chromaticities that are no colour space"));
}

TEST_CASE("ExrHeader, LuminanceAndChromaBecomeColours") {
  // R = Y (1 + RY), B = Y (1 + BY), and Y is Rec. 709's luminance of the three.
  const auto luminance = [](int x, int y) { return 1.0F + 0.1F * static_cast<float>(x + 10 * y); };
  const auto red = [](int x, int y) { return 0.25F + 0.125F * static_cast<float>(x + y); };  // linear: exact between
  for (const int step : {1, 2}) {
    const image::Image image = roundTrip(
        Imf::Header(8, 6), {{"Y", {luminance}}, {"RY", {red, step}}, {"BY", {[](int, int) { return -0.5F; }, step}}},
        {16384, 1 << 24, true});
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 8; ++x) {
        const double l = double{luminance(x, y)};
        const float chroma = red(std::min(x, 8 - step), std::min(y, 6 - step));  // constant past the last sample
        const double r = l * (1.0 + double{chroma}), b = l * 0.5;
        requireTexel(image, x, y, Number3(r, (l - 0.2126390 * r - 0.0721923 * b) / 0.7151687, b));
      }
  }
}

TEST_CASE("ExrHeader, LuminanceAloneIsGrey") {
  const image::Image image = roundTrip(Imf::Header(1, 1), {{"Y", {two}}});
  requireTexel(image, 0, 0, Number3(2.0));
}

TEST_CASE("ExrHeader, FieldsThatAreNotAppliedAreSaid") {
  Imf::Header header(1, 1);
  Imf::addWhiteLuminance(header, 250.0F);
  Imf::addAdoptedNeutral(header, {0.3F, 0.3F});
  const image::Image image = roundTrip(header, {{"Y", {two}}});
  requireTexel(image, 0, 0, Number3(2.0));
  REQUIRE(image.notes.size() == 2);
  REQUIRE_THAT(image.notes[0], Catch::Contains("whiteLuminance is 250"));
  REQUIRE_THAT(image.notes[1], Catch::Contains("adoptedNeutral"));
}

TEST_CASE("ExrHeader, NamesOfColourSpacesAreSaidUnlessThereAreChromaticities") {
  const std::map<std::string, Stored> grey = {{"R", {one}}, {"G", {one}}, {"B", {one}}};
  for (const char* field : {"colorInteropID", "colorSpace", "oiio:ColorSpace"})
    for (const auto& [name, notes] : {std::pair("lin_ap1_scene", 1U), std::pair("Linear", 0U), std::pair("sRGB", 1U)}) {
      CAPTURE(field, name);
      Imf::Header header(1, 1);
      header.insert(field, Imf::StringAttribute(name));
      const image::Image image = roundTrip(header, grey);
      REQUIRE(image.notes.size() == notes);
      if (notes > 0) REQUIRE_THAT(image.notes[0], Catch::Contains(field) && Catch::Contains(name));
      Imf::addChromaticities(header, Imf::Chromaticities());
      REQUIRE(roundTrip(header, grey).notes.empty());
    }
  Imf::Header aces(1, 1);
  aces.insert("acesImageContainerFlag", Imf::IntAttribute(1));
  aces.insert("Orientation", Imf::IntAttribute(3));
  const image::Image image = roundTrip(aces, grey);
  REQUIRE(image.notes.size() == 2);
  REQUIRE_THAT(image.notes[0], Catch::Contains("acesImageContainerFlag"));
  REQUIRE_THAT(image.notes[1], Catch::Contains("Orientation is 3"));
}

TEST_CASE("ExrHeader, AnUnknownKindOfEnvironmentIsRefused") {
  Imf::Header header(2, 1);
  Imf::addEnvmap(header, static_cast<Imf::Envmap>(7));
  REQUIRE_THROWS_WITH(roundTrip(header, {{"Y", {one}}}), Catch::Contains("envmap is neither 0"));
}

TEST_CASE("ExrHeader, YAmongPlacesOrWithHalfItsChromaIsNoColour") {
  const Stored value{one};
  for (const std::map<std::string, Stored>& channels : {std::map<std::string, Stored>{{"Y", value}, {"RY", value}},
                                                        {{"Y", value}, {"BY", value}},
                                                        {{"X", value}, {"Y", value}, {"Z", value}}})
    REQUIRE_THROWS_WITH(roundTrip(Imf::Header(1, 1), channels),
                        Catch::Contains("no Y that is alone or with RY and BY"));
  // A pass of normals beside the picture is no layer of colours; a depth beside a grey picture leaves it grey.
  requireTexel(
      roundTrip(
          Imf::Header(1, 1),
          {{"a.N.X", value}, {"a.N.Y", value}, {"a.N.Z", value}, {"a.C.R", {two}}, {"a.C.G", {two}}, {"a.C.B", {two}}}),
      0, 0, Number3(2.0));
  requireTexel(roundTrip(Imf::Header(1, 1), {{"Y", {two}}, {"Z", value}}), 0, 0, Number3(2.0));
}

TEST_CASE("ExrHeader, PixelsThatAreNotSquareAreSaid") {
  for (const float aspect : {1.0F, 2.0F}) {
    Imf::Header header(2, 1);
    header.pixelAspectRatio() = aspect;
    const image::Image image = roundTrip(header, {{"Y", {two}}});
    requireTexel(image, 1, 0, Number3(2.0));
    REQUIRE(image.notes.size() == (aspect == 1.0F ? 0U : 1U));
    if (aspect != 1.0F)
      REQUIRE_THAT(image.notes[0], Catch::Contains("pixelAspectRatio: pixels are 2 times as wide as high"));
  }
}

TEST_CASE("ExrHeader, ThePictureIsTheDisplayWindow") {
  const auto place = [](int x, int y) { return static_cast<float>(100 + 10 * y + x); };
  const std::map<std::string, Stored> channels = {{"R", {place}}, {"G", {place}}, {"B", {place}}};
  // Display (0, 0) to (3, 1); the data lacks its first column and reaches one row and column past it.
  const Imf::Header header(Imath::Box2i({0, 0}, {3, 1}), Imath::Box2i({1, 0}, {4, 2}));
  const image::Image image = roundTrip(header, channels);
  REQUIRE(image.width == 4);
  REQUIRE(image.height == 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x) requireTexel(image, x, y, Number3(x == 0 ? 0.0 : double{place(x, y)}));
  REQUIRE(image.notes.size() == 2);
  REQUIRE_THAT(image.notes[0], Catch::Contains("2 texels of the display window"));
  REQUIRE_THAT(image.notes[1], Catch::Contains("6 texels outside"));

  Imf::Header map = header;  // OpenEXR's own maps are the data window
  Imf::addEnvmap(map, Imf::ENVMAP_LATLONG);
  const image::Image whole = roundTrip(map, channels);
  REQUIRE(whole.height == 3);
  requireTexel(whole, 0, 0, Number3(101.0));
  REQUIRE(whole.notes.empty());
}

TEST_CASE("ExrHeader, LayersByNameAndByRule") {
  const auto layer = [](const std::string& name, Channel value) {
    return std::map<std::string, Stored>{{name + ".R", {value}}, {name + ".G", {value}}, {name + ".B", {value}}};
  };
  std::map<std::string, Stored> channels = layer("ViewLayer.Combined", half);
  channels["ViewLayer.Depth.Z"] = {one};
  REQUIRE(roundTrip(Imf::Header(1, 1), channels).notes.empty());
  requireTexel(roundTrip(Imf::Header(1, 1), channels), 0, 0, Number3(0.5));

  channels.merge(layer("ViewLayer.Emit", two));
  const image::Image combined = roundTrip(Imf::Header(1, 1), channels);
  requireTexel(combined, 0, 0, Number3(0.5));
  REQUIRE(combined.notes.size() == 1);
  REQUIRE_THAT(combined.notes[0],
               Catch::Contains("'ViewLayer.Combined'") && Catch::Contains("left out: 'ViewLayer.Emit'"));
  requireTexel(roundTrip(Imf::Header(1, 1), channels, {}, "ViewLayer.Emit"), 0, 0, Number3(2.0));
  REQUIRE_THROWS_WITH(roundTrip(Imf::Header(1, 1), channels, {}, "Emit"), Catch::Contains("'ViewLayer.Emit'"));

  auto two_of_them = layer("a", half);
  two_of_them.merge(layer("b", two));
  REQUIRE_THROWS_WITH(roundTrip(Imf::Header(1, 1), two_of_them), Catch::Contains("'a', 'b'"));
  two_of_them.merge(std::map<std::string, Stored>{{"R", {one}}, {"G", {one}}, {"B", {one}}});
  requireTexel(roundTrip(Imf::Header(1, 1), two_of_them), 0, 0, Number3(1.0));
  REQUIRE_THROWS_WITH(roundTrip(Imf::Header(1, 1), {{"Z", {one}}}), Catch::Contains("no channels R, G and B"));
}

TEST_CASE("ExrHeader, PartsAreLayers") {
  const Folder folder;
  {
    std::vector<Imf::Header> headers(2, Imf::Header(1, 1));
    std::vector<Imf::FrameBuffer> frames(2);
    std::map<std::string, std::vector<float>> kept;
    for (std::size_t i = 0; i < 2; ++i) {
      const Stored value{i == 0 ? one : two};
      headers[i].setName(i == 0 ? "left" : "right");
      headers[i].setType(Imf::SCANLINEIMAGE);
      headers[i].setView(headers[i].name());
      fill(headers[i], frames[i], {{"R", value}, {"G", value}, {"B", value}}, kept);
    }
    Imf::MultiPartOutputFile file((folder / "a.exr").c_str(), headers.data(), 2);
    for (int i = 0; i < 2; ++i) {
      Imf::OutputPart part(file, i);
      part.setFrameBuffer(frames[static_cast<std::size_t>(i)]);
      part.writePixels(1);
    }
  }
  const std::filesystem::path path = folder / "a.exr";
  const image::Image first = image::readImage(path);
  requireTexel(first, 0, 0, Number3(1.0));
  REQUIRE(first.notes.size() == 1);
  REQUIRE_THAT(first.notes[0], Catch::Contains("layer read: 'left'; layers left out: 'right'"));
  requireTexel(image::readImage(path, {}, "right"), 0, 0, Number3(2.0));
}

TEST_CASE("ExrHeader, AFewKilobytesThatPromiseABigPictureAreRefused") {
  // One chunk of 16 rows of zeros, whose header says 8192 rows; the table names that chunk 512 times.
  constexpr int kWidth = 16384, kRows = 16, kPromised = 8192;
  for (const Imf::Compression packing : {Imf::ZIP_COMPRESSION, Imf::DWAA_COMPRESSION}) {
    const Folder folder;
    {
      Imf::Header header(kWidth, kRows);
      header.compression() = packing;
      Imf::FrameBuffer frame;
      std::map<std::string, std::vector<float>> kept;
      fill(header, frame, {{"R", {zero}}, {"G", {zero}}, {"B", {zero}}}, kept);
      Imf::OutputFile file((folder / "a.exr").c_str(), header);
      file.setFrameBuffer(frame);
      file.writePixels(kRows);
    }
    std::string bytes = readBytes(folder / "a.exr");
    for (const std::string window : {"dataWindow", "displayWindow"}) {
      const std::size_t last_row = bytes.find(window) + window.size() + 1 + std::string("box2i").size() + 1 + 4 + 12;
      REQUIRE(bytes.substr(last_row, 2) == std::string("\x0f\0", 2));
      bytes[last_row] = static_cast<char>((kPromised - 1) & 0xff);
      bytes[last_row + 1] = static_cast<char>((kPromised - 1) >> 8);
    }
    const auto offset = [](std::uint64_t v) {
      return std::string{static_cast<char>(v), static_cast<char>(v >> 8U), static_cast<char>(v >> 16U), 0, 0, 0, 0, 0};
    };
    // The one entry of the table is the place right behind it.
    std::size_t table = bytes.find("screenWindowWidth");
    while (bytes.substr(table, 8) != offset(table + 8)) ++table;
    const std::size_t chunks = packing == Imf::ZIP_COMPRESSION ? kPromised / 16 : kPromised / 32;
    std::string entries;
    for (std::size_t i = 0; i < chunks; ++i) entries += offset(table + 8 * chunks);
    const std::string forged = bytes.substr(0, table) + entries + bytes.substr(table + 8);
    CAPTURE(forged.size());
    REQUIRE(forged.size() < 10000);
    const image::ImageLimits limits{65536, std::size_t{1} << 27, true};
    REQUIRE_THROWS_WITH(image::readImage("a.exr", std::as_bytes(std::span(forged)), limits),
                        Catch::Contains("bytes cannot hold 16384 x 8192 texels"));
  }
}

}  // namespace welkin::tests
