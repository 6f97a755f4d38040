// SPDX-License-Identifier: Apache-2.0
// Radiance pictures and PNM: orders of the texels, exposures, colours, both run-length codes, scales and largest
// values.
#include <catch2/catch.hpp>
#include <cmath>
#include <span>
#include <string>

#include "sky/base/error.h"
#include "sky/image/image.h"

namespace welkin::tests {
namespace {

image::Image decode(const std::string& bytes) {
  image::ImageLimits limits;
  limits.negative = true;
  return image::readImage("a.hdr", std::as_bytes(std::span(bytes)), limits);
}

void requireRefused(const std::string& bytes, const std::string& why) {
  INFO(bytes.substr(0, 80));
  REQUIRE_THROWS_WITH(decode(bytes), Catch::Contains("a.hdr: ") && Catch::Contains(why));
}

/// A picture of flat texels; a mantissa m at exponent 136 is the value m + 1/2.
std::string radiance(const std::string& fields, const std::string& order, const std::string& texels) {
  return "#?RADIANCE\n" + fields + "\n" + order + "\n" + texels;
}

std::string texel(int r, int g, int b, int e = 136) {
  return {static_cast<char>(r), static_cast<char>(g), static_cast<char>(b), static_cast<char>(e)};
}

const std::string kFormat = "FORMAT=32-bit_rle_rgbe\n";

}  // namespace

TEST_CASE("Radiance, AllOrdersOfTheTexelsAreTurnedUpright") {
  // The picture has columns 0 to 2 and rows 0 and 1; the texel at (x, y) is 10 + 3 y + x.
  for (const bool columns : {false, true})
    for (const bool up : {false, true})
      for (const bool left : {false, true}) {
        std::string texels;
        for (int line = 0; line < (columns ? 3 : 2); ++line)
          for (int i = 0; i < (columns ? 2 : 3); ++i) {
            const int along_x = columns ? line : i, along_y = columns ? i : line;
            const int x = left ? 2 - along_x : along_x, y = up ? 1 - along_y : along_y;
            texels += texel(10 + 3 * y + x, 0, 0);
          }
        const std::string x_axis = std::string(left ? "-X" : "+X") + " 3",
                          y_axis = std::string(up ? "+Y" : "-Y") + " 2";
        const std::string order = columns ? x_axis + " " + y_axis : y_axis + " " + x_axis;
        INFO(order);
        const image::Image image = decode(radiance(kFormat, order, texels));
        REQUIRE(image.width == 3);
        REQUIRE(image.height == 2);
        for (std::size_t i = 0; i < 6; ++i) REQUIRE(image.rgb[3 * i] == 10.5F + static_cast<float>(i));
      }
}

TEST_CASE("Radiance, ExposureAndColourCorrectionAreDividedOut") {
  const std::string texels = texel(19, 39, 79);
  const image::Image plain = decode(radiance(kFormat, "-Y 1 +X 1", texels));
  REQUIRE(plain.rgb == std::vector<float>{19.5F, 39.5F, 79.5F});
  REQUIRE(plain.notes.empty());
  const image::Image image =
      decode(radiance(kFormat + "EXPOSURE=4\nEXPOSURE= 0.5\nCOLORCORR= 1 2 4\n\tEXPOSURE=100\n", "-Y 1 +X 1", texels));
  REQUIRE(image.rgb == std::vector<float>{19.5F / 2, 39.5F / 4, 79.5F / 8});
  REQUIRE(image.notes.size() == 1);
  REQUIRE_THAT(image.notes[0], Catch::Contains("EXPOSURE and COLORCORR, together 2 4 8"));
  for (const char* field : {"EXPOSURE=0\n", "EXPOSURE=-1\n", "EXPOSURE=nan\n", "EXPOSURE=x\n", "EXPOSURE=1 2\n",
                            "COLORCORR=1 1\n", "COLORCORR=1 0 1\n", "EXPOSURE=1e31\n", "EXPOSURE=\n"})
    requireRefused(radiance(field, "-Y 1 +X 1", texels), std::string(field).substr(0, 8));
}

TEST_CASE("Radiance, ViewsAndPixelsThatAreNotSquareAreSaid") {
  const auto notes = [](const std::string& fields) {
    return decode(radiance(kFormat + fields, "-Y 1 +X 1", texel(9, 9, 9))).notes;
  };
  REQUIRE(notes("PIXASPECT=1\n\tVIEW= -vtv\n\tPIXASPECT=3\n").empty());
  REQUIRE(notes("PIXASPECT=2\nPIXASPECT= 0.5\n").empty());  // they multiply
  const auto wide = notes("PIXASPECT= 0.25\n");
  REQUIRE(wide.size() == 1);
  REQUIRE_THAT(wide[0], Catch::Contains("PIXASPECT: pixels are 4 times as wide as high"));
  const auto seen = notes("VIEW= -vtv -vp 0 0 0 -vd 0 1 0\nVIEW= -vth\n");
  REQUIRE(seen.size() == 1);
  REQUIRE_THAT(seen[0], Catch::Contains("VIEW is not read"));
  for (const char* field : {"PIXASPECT=0\n", "PIXASPECT=-1\n", "PIXASPECT=nan\n", "PIXASPECT=\n", "PIXASPECT=1e7\n"})
    requireRefused(radiance(field, "-Y 1 +X 1", texel(9, 9, 9)), "PIXASPECT");
}

TEST_CASE("Radiance, XyzAndPrimariesBecomeRec709") {
  // Rec. 709's green in XYZ: (0.3576, 0.7152, 0.1192).
  const image::Image green =
      decode(radiance("FORMAT=32-bit_rle_xyze\n", "-Y 1 +X 1", texel(89, 178, 29)));  // times 250
  REQUIRE(double{green.rgb[0]} == Approx(0.0).margin(1.5));  // half a step of 1 times the elements of the matrix
  REQUIRE(double{green.rgb[1]} == Approx(250.0).margin(1.5));
  REQUIRE(double{green.rgb[2]} == Approx(0.0).margin(1.5));
  REQUIRE_THAT(green.notes.at(0), Catch::Contains("CIE XYZ"));

  const std::string same = kFormat + "PRIMARIES=0.64 0.33 0.30 0.60 0.15 0.06 0.3127 0.3290\n";
  REQUIRE(decode(radiance(same, "-Y 1 +X 1", texel(9, 9, 9))).notes.empty());
  const std::string own = kFormat + "PRIMARIES=0.640 0.330 0.290 0.600 0.150 0.060 0.333 0.333\n";
  const image::Image image = decode(radiance(own, "-Y 1 +X 1", texel(0, 199, 0)));
  REQUIRE(image.rgb[0] < -1.0F);  // greener than Rec. 709's green
  REQUIRE_THAT(image.notes.at(0), Catch::Contains("green (0.29, 0.6)"));
  requireRefused(radiance("PRIMARIES=1 1 1 1 1 1 1 1\n", "-Y 1 +X 1", texel(2, 2, 2)), "no colour space");
}

TEST_CASE("Radiance, BothRunLengthCodes") {
  std::string packed("\x02\x02\x00\x0a", 4);
  for (const int value : {7, 8, 9, 136}) packed += {static_cast<char>(128 + 8), static_cast<char>(value), 2, 50, 51};
  const image::Image image = decode(radiance(kFormat, "-Y 1 +X 10", packed));
  REQUIRE(image.rgb[0] == 7.5F);
  REQUIRE(image.rgb[3 * 7 + 2] == 9.5F);
  REQUIRE(image.rgb[3 * 9] == std::ldexp(51.5F, 51 - 136));

  // 1, 1, 1, n repeats n times; right after it the count is n times 256.
  const std::string old = texel(3, 3, 3) + texel(1, 1, 1, 4) + texel(1, 1, 1, 1) + texel(5, 5, 5);
  const image::Image runs = decode(radiance(kFormat, "-Y 1 +X 262", old));
  REQUIRE(runs.rgb[3 * 260] == 3.5F);
  REQUIRE(runs.rgb[3 * 261] == 5.5F);
  requireRefused(radiance(kFormat, "-Y 1 +X 3", texel(3, 3, 3) + texel(1, 1, 1, 3)), "a run of texels passes");
  requireRefused(radiance(kFormat, "-Y 1 +X 3", texel(1, 1, 1, 3)), "a run of texels passes");
}

TEST_CASE("Radiance, EveryCutAndForeignHeaderIsRefused") {
  const std::string whole =
      radiance(kFormat, "-Y 2 +X 2", texel(9, 9, 9) + texel(8, 8, 8) + texel(7, 7, 7) + texel(6, 6, 6));
  REQUIRE(decode(whole).width == 2);
  for (std::size_t size = 2; size < whole.size(); ++size) requireRefused(whole.substr(0, size), "damaged or cut");
  requireRefused(radiance("FORMAT=other\n", "-Y 1 +X 1", texel(1, 1, 1)), "FORMAT");
  requireRefused(radiance("GAMMA=2.2\n", "-Y 1 +X 1", texel(1, 1, 1)), "GAMMA");
  for (const char* order : {"-Y 1 -Y 1", "-Z 1 +X 1", "Y 1 +X 1", "-Y 1", "-Y 1 +X 1 +X 1", "-Y x +X 1"})
    requireRefused(radiance(kFormat, order, texel(1, 1, 1)), "damaged or cut");
  for (const char* order : {"-Y 0 +X 1", "-Y -1 +X 1", "-Y 99999 +X 1"})
    requireRefused(radiance(kFormat, order, texel(1, 1, 1)), "a side are allowed");
}

TEST_CASE("Pnm, CodesAreSrgbAndFloatsAreScaled") {
  for (const std::string& half :
       {std::string("P2 1 1 # comment\n 2 1\n"), std::string("P5 1 1 2\n\x01"), std::string("P3 1 1 2 1 1 1"),
        std::string("P6\n1 1\n2\n\x01\x01\x01"), std::string("P5 1 1 510\n\x00\xff", 13)})
    REQUIRE(double{decode(half).rgb[1]} == Approx(0.21404114).epsilon(1e-6));  // sRGB's curve at 1/2
  const std::string one("\x3f\x80\x00\x00", 4), two("\x40\x00\x00\x00", 4);
  const image::Image floats = decode("Pf\n1 2\n3.0\n" + one + two);
  REQUIRE(floats.rgb == std::vector<float>{6.0F, 6.0F, 6.0F, 3.0F, 3.0F, 3.0F});  // rows from the bottom
  REQUIRE(floats.notes.size() == 1);
  const std::string swapped(one.rbegin(), one.rend());
  REQUIRE(decode("PF\n1 1\n-1\n" + swapped + swapped + swapped).rgb == std::vector<float>{1.0F, 1.0F, 1.0F});
}

TEST_CASE("Pnm, EveryCutAndImpossibleNumberIsRefused") {
  const std::string one("\x3f\x80\x00\x00", 4);
  for (const std::string& whole : {std::string("P6 2 1 255\nabcdef"), std::string("P5 2 1 65535\nabcd"),
                                   "Pf 2 1 1.0\n" + one + one, std::string("P2 2 1 9 7 8")}) {
    REQUIRE(decode(whole).width == 2);
    for (std::size_t size = 2; size < whole.size(); ++size) {
      // A cut number of a text is another number, until none is left.
      requireRefused(whole.substr(0, size), "");
    }
  }
  for (const char* largest : {"0", "-1", "65536", "x", ""})
    requireRefused(std::string("P5 1 1 ") + largest + "\na", "");
  requireRefused("P5 1 1 10\nz", "a texel is 122; 0 to 10 are allowed");
  requireRefused("P2 1 1 10\n-1", "a texel is -1");
  for (const char* scale : {"0", "nan", "1e40"}) requireRefused(std::string("Pf 1 1 ") + scale + "\n" + one, "scale");
}

}  // namespace welkin::tests
