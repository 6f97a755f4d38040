// SPDX-License-Identifier: Apache-2.0
#include "gloss/normal_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <regex>
#include <utility>

#include "sh/deterministic.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::gloss {
namespace {

using det::Number3;

constexpr double kShortest = 0.1;         // below it a vector has no direction: 8-bit codes of 0 give up to 0.007
constexpr double kDeviation = 0.05;       // mean of | |n| - 1 | that codes of 8 bits (0.002) and JPEG (0.02) stay below
constexpr std::size_t kSample = 1 << 16;  // texels that tell how the numbers are coded

base::Error refusal(const std::string& name, const std::string& why) {
  return base::Error(base::ExitStatus::content, fmt::format("{}: {}", name, why));
}

double lengthOf(const Number3& n) {
  return std::sqrt(dot(n, n));
}

Number3 texel(const image::Image& image, std::size_t i) {
  const float* v = image.rgb.data() + 3 * i;
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

Number3 signedOf(const Number3& v) {
  return v * 2.0 - Number3(1.0);
}

template <typename Curve>
Number3 through(const Number3& v, Curve&& curve) {
  const auto held = [&](double x) { return curve(std::clamp(x, 0.0, 1.0)); };
  return {held(v.x), held(v.y), held(v.z)};
}

/// What a sample of the texels says about their coding.
struct Signs {
  double as_codes = 0.0, plain = 0.0, srgb_decoded = 0.0, srgb_encoded = 0.0;  ///< mean of | |n| - 1 |
  bool negative = false;
  bool grey = true;
};

Signs signsOf(const image::Image& image) {
  const std::size_t texels = image.rgb.size() / 3;
  const std::size_t step = std::max<std::size_t>(texels / kSample, 1);
  Signs signs;
  double count = 0.0;
  for (std::size_t i = 0; i < texels; i += step) {
    const Number3 v = texel(image, i);
    signs.as_codes += std::abs(lengthOf(signedOf(v)) - 1.0);
    signs.plain += std::abs(lengthOf(v) - 1.0);
    signs.srgb_decoded += std::abs(lengthOf(signedOf(through(v, det::srgbDecode))) - 1.0);
    signs.srgb_encoded += std::abs(lengthOf(signedOf(through(v, det::srgbEncode))) - 1.0);
    signs.negative = signs.negative || v.x < 0.0 || v.y < 0.0 || v.z < 0.0;
    signs.grey = signs.grey && v.x == v.y && v.y == v.z;
    count += 1.0;
  }
  for (double* mean : {&signs.as_codes, &signs.plain, &signs.srgb_decoded, &signs.srgb_encoded}) *mean /= count;
  return signs;
}

/// Whether blue is one number, 0, 1/2 or 1, and the others are not: z was left out.
bool lacksZ(const image::Image& image) {
  const Number3 first = texel(image, 0);
  constexpr double kStep = 1.5 / 255.0;
  if (std::abs(first.z) > kStep && std::abs(first.z - 0.5) > kStep && std::abs(first.z - 1.0) > kStep) return false;
  bool varies = false;
  for (std::size_t i = 0; i < image.rgb.size() / 3; ++i) {
    const Number3 v = texel(image, i);
    if (v.z != first.z) return false;
    varies = varies || v.x != first.x || v.y != first.y;
  }
  return varies;
}

Coding codingOf(const std::string& name, const image::Image& image, bool decode_srgb) {
  const Signs signs = signsOf(image);
  if (signs.negative || (signs.plain < 1e-3 && signs.plain < signs.as_codes)) return Coding::plain;
  if (signs.grey)
    throw refusal(name, "red, green and blue are equal: a map of heights, gloss or roughness, not of normals");
  if (lacksZ(image)) return Coding::two_channel;
  if (decode_srgb || signs.as_codes < kDeviation) return Coding::codes;
  const auto fits = [&](double deviation) { return deviation < signs.as_codes / 4.0; };
  if (fits(signs.srgb_decoded))
    throw refusal(name,
                  fmt::format("normals are sRGB-encoded: their lengths are off by {:.3f} in the mean, and by {:.3f} "
                              "once decoded. Export them as data, or pass --decode-srgb",
                              signs.as_codes, signs.srgb_decoded));
  if (fits(signs.srgb_encoded))
    throw refusal(name, fmt::format("normals were decoded from sRGB, which they never were: their lengths are off by "
                                    "{:.3f} in the mean, and by {:.3f} once encoded. Export them as data",
                                    signs.as_codes, signs.srgb_encoded));
  return Coding::codes;
}

Number3 vectorOf(const Number3& v, Coding coding, bool decode_srgb) {
  if (coding == Coding::plain) return v;
  const Number3 n = signedOf(decode_srgb ? through(v, det::srgbDecode) : v);
  if (coding == Coding::codes) return n;
  return {n.x, n.y, std::sqrt(std::max(1.0 - n.x * n.x - n.y * n.y, 0.0))};
}

/// Counts of vectors with a fault.
struct Faults {
  std::size_t without_direction = 0, inward = 0;
  std::optional<std::size_t> first;  ///< texel of the first without a direction
};

void warn(NormalMap& map, const std::string& id, std::size_t count, const std::string& message) {
  map.warnings.push_back({id, count, message});
}

void warnOfFaults(const Faults& faults, const NormalMapOptions& options, NormalMap& map) {
  if (faults.without_direction > 0)
    warn(map, "zero-normals", faults.without_direction,
         fmt::format("{} normals have no direction; flat ones stand for them", faults.without_direction));
  if (faults.inward > 0)
    warn(map, "inward-normals", faults.inward,
         fmt::format("{} normals point into the surface (z < 0){}", faults.inward,
                     options.repair ? "; flat ones stand for them" : "; --repair makes them flat"));
  if (map.coding == Coding::two_channel)
    warn(map, "two-channel", 1, "blue is constant: a map of two channels; z is rebuilt from x and y");
  if (std::abs(map.mean_stored_length - 1.0) > kDeviation)
    warn(map, "lengths", 1,
         fmt::format("vectors are {:.3f} long in the mean: a map that was reduced in size? What they lost is not "
                     "known to belong to bumps, and they are normalised",
                     map.mean_stored_length));
}

}  // namespace

const char* nameOf(Coding coding) {
  return coding == Coding::codes ? "codes" : coding == Coding::plain ? "plain" : "two-channel";
}

NormalMap normalMapOf(const std::string& name, image::Image image, const NormalMapOptions& options) {
  NormalMap map;
  map.width = image.width;
  map.height = image.height;
  map.coding = codingOf(name, image, options.decode_srgb);
  Faults faults;
  double lengths = 0.0;
  for (std::size_t i = 0; i < image.rgb.size() / 3; ++i) {
    Number3 n = vectorOf(texel(image, i), map.coding, options.decode_srgb);
    const double length = lengthOf(n);
    lengths += length;
    const bool directed = length >= kShortest && length < 1e18;
    if (!directed && faults.without_direction++ == 0) faults.first = i;
    const bool inward = directed && n.z < 0.0;
    if (inward) ++faults.inward;
    n = !directed || (inward && options.repair) ? Number3(0.0, 0.0, 1.0) : n / length;
    for (int c = 0; c < 3; ++c) image.rgb[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(n[c]);
  }
  map.mean_stored_length = lengths / static_cast<double>(image.rgb.size() / 3);
  if (faults.without_direction > 0 && !options.repair) {
    const auto width = static_cast<std::size_t>(map.width);
    throw refusal(name,
                  fmt::format("{} normals have no direction, the first at column {}, row {} from the top; lengths "
                              "from {} are allowed. --repair makes them flat",
                              faults.without_direction, *faults.first % width, *faults.first / width, kShortest));
  }
  map.xyz = std::move(image.rgb);
  warnOfFaults(faults, options, map);
  return map;
}

NormalMap readNormalMap(const std::filesystem::path& path, const NormalMapOptions& options) {
  NormalMap map = normalMapOf(path.string(), image::readCodes(path, kNormalLimits), options);
  static const std::regex kMip("[._-]mip([1-9][0-9]*)$", std::regex::icase);
  if (std::smatch found; std::string(path.stem().string()) != "") {
    const std::string stem = path.stem().string();
    if (std::regex_search(stem, found, kMip))
      warn(
          map, "is-a-mip", 1,
          fmt::format("the name says that this is mip {}: its vectors were averaged already, and what they lost is not "
                      "in them. Give mip 0",
                      found[1].str()));
  }
  constexpr std::size_t kMipCount = 28;  // place of dwMipMapCount in a DDS file
  const std::vector<std::byte> start = base::readStart(path, 128);
  if (start.size() == 128 && start[0] == std::byte{'D'} && start[1] == std::byte{'D'} &&
      start[kMipCount] > std::byte{1})
    warn(map, "own-mips", std::to_integer<std::size_t>(start[kMipCount]) - 1,
         "the file's own mips are not read: normals that were normalised after averaging say nothing about bumps");
  return map;
}

}  // namespace welkin::gloss
