// SPDX-License-Identifier: Apache-2.0
#include "gloss/gloss_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "sh/deterministic_materials.h"
#include "sky/base/error.h"

namespace welkin::gloss {
namespace {

double powerOf(double value, bool roughness) {
  return roughness ? det::powerOfRoughness(value) : det::powerOfGloss(value);
}

/// Whether the file's name speaks of a word, in any case.
bool nameSays(const std::filesystem::path& path, const std::string& word) {
  std::string stem = path.stem().string();
  std::transform(stem.begin(), stem.end(), stem.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return stem.find(word) != std::string::npos;
}

void warnOfName(const std::filesystem::path& path, bool roughness, GlossMap& map) {
  const bool says_roughness = nameSays(path, "rough");
  const bool says_gloss = nameSays(path, "gloss") || nameSays(path, "smooth");
  if (says_roughness != says_gloss && says_roughness != roughness)
    map.warnings.push_back({"swapped", 1,
                            fmt::format("the name says {}, and it is read as {}; pass it with --{} instead?",
                                        says_roughness ? "roughness" : "gloss", roughness ? "roughness" : "gloss",
                                        says_roughness ? "roughness" : "gloss")});
}

}  // namespace

bool isNumber(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0';
}

GlossMap readGloss(const std::string& text, bool roughness) {
  const char* const option = roughness ? "--roughness" : "--gloss";
  GlossMap map;
  if (isNumber(text)) {
    const double number = std::strtod(text.c_str(), nullptr);
    if (!(number >= 0.0 && number <= 1.0))
      throw base::Error(base::ExitStatus::usage, fmt::format("{}: {} is not in [0, 1]", option, text));
    map.number = roughness ? det::glossOfPower(det::powerOfRoughness(number)) : number;
    return map;
  }
  const std::filesystem::path path = text;
  const image::Image image = image::readCodes(path, kNormalLimits);
  map.width = image.width;
  map.height = image.height;
  bool grey = true;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    grey = grey && image.rgb[i] == image.rgb[i + 1] && image.rgb[i] == image.rgb[i + 2];
    const double value = double{image.rgb[i + (roughness ? 1 : 0)]};
    if (!(value >= 0.0 && value <= 1.0))
      throw base::Error(base::ExitStatus::content,
                        fmt::format("{}: {} at column {}, row {} from the top; values of {} from 0 to 1 are allowed",
                                    text, value, i / 3 % static_cast<std::size_t>(image.width),
                                    i / 3 / static_cast<std::size_t>(image.width), option + 2));
    map.variance.push_back(static_cast<float>(1.0 / powerOf(value, roughness)));
  }
  if (!grey)
    map.warnings.push_back(
        {"coloured", 1, fmt::format("a map in colour; its {} channel is read", roughness ? "green" : "red")});
  warnOfName(path, roughness, map);
  return map;
}

}  // namespace welkin::gloss
