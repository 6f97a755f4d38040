// SPDX-License-Identifier: Apache-2.0
#include "calibrate/profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/json_text.h"
#include "sky/base/message.h"

namespace welkin::calibrate {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kProfileForm = "welkin calibration 1";
constexpr const char* kPhotoKey = "photo_xxh3_128";

[[noreturn]] void refuseProfile(const std::string& name, const std::string& why) {
  throw base::Error(base::ExitStatus::content, fmt::format("{}: {}", name, why));
}

std::vector<double> numbersOf(const std::string& name, const Json& json, const char* key, std::size_t count) {
  constexpr double kMost = 1e6;
  std::vector<double> numbers;
  for (const Json& value : json[key]) {
    if (!value.is_number() || !(std::abs(value.get<double>()) <= kMost))
      refuseProfile(name, fmt::format("{0}: numbers from -{1:.0f} to {1:.0f} are allowed", key, kMost));
    numbers.push_back(value.get<double>());
  }
  if (numbers.size() != count)
    refuseProfile(name, fmt::format("{}: {} numbers; {} are wanted", key, numbers.size(), count));
  return numbers;
}

/// Models divide by some of their numbers: so colours are tried from black to twice the chart's range.
bool givesColours(const Profile& profile) {
  constexpr int kSteps = 8;
  for (int r = 0; r <= kSteps; ++r)
    for (int g = 0; g <= kSteps; ++g)
      for (int b = 0; b <= kSteps; ++b)
        if (!profile.model(2.0 / kSteps * Colour(r, g, b).cwiseProduct(profile.brightest)).allFinite()) return false;
  return true;
}

}  // namespace

Profile profileOf(const CalibratedPhoto& photo) {
  Profile profile{photo.calibration.model, photo.linear_codes, Colour::Zero(), photo.hash};
  for (const std::size_t i : photo.calibration.used)
    profile.brightest = profile.brightest.cwiseMax(photo.charts[0].patches[i].mean);
  return profile;
}

Json profileJson(const Profile& profile) {
  Json json = {{"format", kProfileForm},
               {"input", profile.linear_codes ? "linear" : "srgb"},
               {"model", profile.model.kind->name},
               {"numbers", profile.model.numbers},
               {"brightest", {profile.brightest.x(), profile.brightest.y(), profile.brightest.z()}}};
  if (!profile.photo.empty()) json[kPhotoKey] = profile.photo;
  return json;
}

Profile readProfile(const std::filesystem::path& path) {
  constexpr std::size_t kMostBytes = 65536;
  static const Json kForm = {
      {"format", "a"}, {"input", "a"}, {"model", "a"}, {"numbers", Json::array()}, {"brightest", Json::array()}};
  const std::string name = path.string();
  const std::vector<std::byte> bytes = base::readFile(path, kMostBytes);
  const auto json = base::parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!json || !base::hasForm(*json, kForm) || (*json)["format"] != kProfileForm)
    refuseProfile(name, fmt::format("no profile of `welkin calibrate`: \"format\": \"{}\", input, model, numbers and "
                                    "brightest are wanted",
                                    kProfileForm));
  const std::string input = (*json)["input"], model = (*json)["model"];
  if (input != "srgb" && input != "linear")
    refuseProfile(name, fmt::format("input: \"{}\"; srgb and linear are allowed", base::oneLine(input)));
  Profile profile;
  profile.linear_codes = input == "linear";
  profile.model.kind = modelNamed(model);
  if (profile.model.kind == nullptr)
    refuseProfile(name, fmt::format("model: \"{}\"; {} are allowed", base::oneLine(model), modelNames()));
  profile.model.numbers = numbersOf(name, *json, "numbers", profile.model.kind->count);
  const std::vector<double> brightest = numbersOf(name, *json, "brightest", 3);
  profile.brightest = {brightest[0], brightest[1], brightest[2]};
  if (!(profile.brightest.minCoeff() > 0.0)) refuseProfile(name, "brightest: numbers above 0 are allowed");
  if (json->contains(kPhotoKey)) {
    if (!(*json)[kPhotoKey].is_string()) refuseProfile(name, fmt::format("{}: text is wanted", kPhotoKey));
    profile.photo = (*json)[kPhotoKey];
  }
  if (!givesColours(profile))
    refuseProfile(name, "numbers: some colours up to twice the chart's have no finite result");
  return profile;
}

double partPastChart(const image::Image& image, const Profile& profile) {
  const std::size_t texels = image.rgb.size() / 3;
  std::size_t past = 0;
  for (std::size_t i = 0; i < texels; ++i) {
    const float* c = image.rgb.data() + 3 * i;
    past += double{c[0]} > profile.brightest.x() || double{c[1]} > profile.brightest.y() ||
                    double{c[2]} > profile.brightest.z()
                ? 1
                : 0;
  }
  return static_cast<double>(past) / static_cast<double>(std::max<std::size_t>(1, texels));
}

}  // namespace welkin::calibrate
