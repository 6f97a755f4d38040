// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/sky_domain.h"

#include "format/day_numbers.h"
#include "format/key_segment.h"
#include "sky/model/luminance.h"

namespace welkin::bake {
namespace {

using base::Default;
using base::Domain;
using base::Kind;
using base::Parameter;
using base::Range;
using base::Required;

constexpr Range kBrightness{0.0, 1e12};  // Scene units; its square stays far inside float's range.
constexpr Range kFraction{0.0, 1.0};
constexpr Range kLatitude{-90.0, 90.0};
constexpr Range kTurn{-360.0, 360.0};
constexpr Range kDay{0.0, format::kDay_h, true};
constexpr Range kCoefficient{-1e4, 1e4};
constexpr Range kNegativeCoefficient{-1e4, 0.0, true};
constexpr Range kAzimuth{-1e4, 1e4};
constexpr Range kDiscRadius{0.0, 45.0};
constexpr double kSunRadius_deg = 0.27;

constexpr std::string_view kScene = "scene units";
constexpr std::string_view kDegrees = "degrees";
constexpr std::string_view kHours = "h";

std::vector<std::string_view> luminanceNames() {
  std::vector<std::string_view> names;
  for (const model::NamedLuminance& named : model::namedLuminances()) names.push_back(named.name);
  return names;
}

std::vector<std::string_view> encodingNames() {
  std::vector<std::string_view> names = {"auto"};
  for (const format::Encoding encoding : format::kEncodings) names.emplace_back(nameOf(encoding));
  return names;
}

/// Marks a row that is not allowed beside a path: a place, a day, a phase.
Parameter withoutPath(Parameter p) {
  p.without_path = true;
  return p;
}

Domain rows() {
  return {
      {"", "time_h", "", Kind::part, kHours, kDay, Required{}, "time of a key; ascending, periodic"},
      {"sky",
       "luminance",
       "",
       Kind::luminance,
       "",
       {},
       "far-cry-3",
       "gradation and indicatrix must be above 1e-9 for every direction and every sun of the day",
       "refused",
       luminanceNames()},
      {"sky", "luminance", "a", Kind::part, "", kCoefficient, Required{}, ""},
      {"sky", "luminance", "b", Kind::part, "", kNegativeCoefficient, Required{}, ""},
      {"sky", "luminance", "c", Kind::part, "", kCoefficient, Required{}, ""},
      {"sky", "luminance", "d", Kind::part, "", kNegativeCoefficient, Required{}, ""},
      {"sky", "luminance", "e", Kind::part, "", kCoefficient, Required{}, ""},
      {"sky",
       "normalise",
       "",
       Kind::word,
       "",
       {},
       "sun",
       "the direction whose relative luminance is 1",
       "refused",
       {"sun", "zenith"}},
      {"sky", "intensity", "", Kind::number_or_keys, kScene, kBrightness, 1.0, "radiance where the luminance is 1",
       "refused; cubemap texels past 65504 are stored as that, and counted"},
      {"sky", "gradient_sun", "", Kind::gradient, "", kBrightness, 1.0,
       "at the sun's azimuth; an image's texels are finite and not negative"},
      {"sky", "gradient_anti", "", Kind::gradient, "", kBrightness, 1.0, "at the opposite azimuth; texels likewise"},
      {"sky", "polarising_tint", "", Kind::tint, "", kBrightness, 1.0,
       "an image is a strip over the day whose rows are averaged; its texels are finite and not negative"},
      {"sky", "ambient_saturation", "", Kind::number_or_keys, "", kFraction, 1.0, ""},
      {"sky", "ground_albedo", "", Kind::colour, "", kFraction, 0.0, ""},
      {"sky", "luminance_unit", "", Kind::number, "cd/m2", {1e-12, 1e12}, 1.0, "luminance of radiance 1"},
      withoutPath({"sun", "latitude_deg", "", Kind::number, kDegrees, kLatitude, Required{}, ""}),
      withoutPath({"sun", "longitude_deg", "", Kind::number, kDegrees, {-180.0, 180.0}, 0.0, "east positive"}),
      withoutPath({"sun", "utc_offset_h", "", Kind::number, kHours, {-14.0, 14.0}, "longitude_deg / 15", ""}),
      withoutPath({"sun", "year", "", Kind::whole_number, "", {-2000.0, 6000.0}, 2000.0, ""}),
      withoutPath({"sun", "day_of_year", "", Kind::whole_number, "", {1.0, 366.0}, Required{}, ""}),
      {"sun", "north_offset_deg", "", Kind::number, kDegrees, kTurn, 0.0, "added to every azimuth"},
      {"sun", "path", "", Kind::path, "", {}, "a place and a day", ""},
      {"sun", "path", "azimuth_deg", Kind::part, kDegrees, kAzimuth, Required{}, "whole turns change nothing"},
      {"sun", "path", "elevation_deg", Kind::part, kDegrees, kLatitude, Required{}, ""},
      {"sun", "illuminance", "", Kind::number_or_keys, kScene, kBrightness, 0.0, "on a surface that faces the light"},
      {"sun", "colour", "", Kind::colour_or_keys, "", kBrightness, 1.0, "luminance above 1e-12"},
      {"sun", "disc_radius_deg", "", Kind::number, kDegrees, kDiscRadius, kSunRadius_deg, "0: no disc"},
      withoutPath({"moon", "declination_deg", "", Kind::number, kDegrees, kLatitude, Required{}, ""}),
      withoutPath({"moon", "phase", "", Kind::number, "", kFraction, Required{}, "0 new, 0.5 full"}),
      withoutPath({"moon", "latitude_deg", "", Kind::number, kDegrees, kLatitude, "the sun's", ""}),
      {"moon", "north_offset_deg", "", Kind::number, kDegrees, kTurn, "the sun's", "added to every azimuth"},
      {"moon", "path", "", Kind::path, "", {}, "declination and phase", ""},
      {"moon", "path", "azimuth_deg", Kind::part, kDegrees, kAzimuth, Required{}, "whole turns change nothing"},
      {"moon", "path", "elevation_deg", Kind::part, kDegrees, kLatitude, Required{}, ""},
      {"moon", "illuminance", "", Kind::number_or_keys, kScene, kBrightness, 0.0, "on a surface that faces the light"},
      {"moon", "colour", "", Kind::colour_or_keys, "", kBrightness, 1.0, "luminance above 1e-12"},
      {"moon", "disc_radius_deg", "", Kind::number, kDegrees, kDiscRadius, kSunRadius_deg, "0: no disc"},
      {"stars", "image", "", Kind::image, "", kFraction, Required{},
       "equirectangular, the celestial north pole on top, the middle column on the meridian at midnight"},
      {"stars", "intensity", "", Kind::number, kScene, kBrightness, Required{},
       "radiance of the map's white; a sky as bright hides it"},
      {"bake",
       "max_error",
       "",
       Kind::number,
       "",
       {1e-5, 1.0},
       "0.03 where no key of [bake] but cubemap_error is set, else no budget",
       "largest error of a bake, as a fraction"},
      {"bake",
       "bands",
       "",
       Kind::whole_number,
       "",
       {2.0, 5.0},
       2.0,
       "`auto`: under a budget as few as meet it",
       "refused",
       {"auto"}},
      {"bake",
       "keys",
       "",
       Kind::hours,
       "",
       {1.0, 86400.0},
       "auto",
       "`auto`: every five minutes, under a budget where they are needed",
       "refused",
       {"auto"}},
      {"bake",
       "cubemap_size",
       "",
       Kind::whole_number,
       "texels",
       {0.0, 4096.0},
       128.0,
       "along a face; 0: no cubemaps; not 1",
       "refused",
       {"auto"}},
      {"bake", "cubemap_times", "", Kind::hours, "", {1.0, 1440.0}, 8.0, "a millisecond apart", "refused", {"auto"}},
      {"bake",
       "cubemap_error",
       "",
       Kind::number,
       "",
       {1e-5, 1.0},
       "auto",
       "largest error of the cubemaps; `auto`: under a budget max_error, or the least within 64 MB of cubemaps",
       "refused",
       {"auto"}},
      {"bake",
       "cubemap_format",
       "",
       Kind::word,
       "",
       {},
       "auto",
       "8, 4 and 4 bytes a texel, rounded by up to 0.05, 0.2 and 0.8 % (blue 1.6 %); `auto`: without a budget "
       "`rgba16f`",
       "refused",
       {"auto", "rgba16f", "rgb9e5", "b10g11r11"}},
      {"bake",
       "gradient_format",
       "",
       Kind::word,
       "",
       {},
       "auto",
       "12 and 4 bytes a texel, rounded by up to 0.2 % of its largest component, which only the analytic dome sees; "
       "`auto`: without a budget `rgb32f`",
       "refused",
       {"auto", "rgb32f", "rgb9e5"}},
      {"bake",
       "reconstruction",
       "",
       Kind::word,
       "",
       {},
       "auto",
       "how irradiance is held; `auto`: without a budget `projected`",
       "refused",
       {"auto", "projected", "fitted", "modes"}},
      {"bake",
       "target",
       "",
       Kind::word,
       "",
       {},
       "modes",
       "the reader of the ambient light: the game's own shaders (`modes`), 2 or 3 bands of SH, or an engine that takes "
       "3",
       "refused",
       {"modes", "sh2", "sh3", "filament", "three", "unity", "unreal", "godot"}},
      {"bake",
       "encoding",
       "",
       Kind::word,
       "",
       {},
       "auto",
       "numbers of the table; `auto`: without a budget `float32`",
       "refused",
       encodingNames()},
      {"bake",
       "window",
       "",
       Kind::word,
       "",
       {},
       "off",
       "window on the coefficients; `mildest`: the mildest that keeps irradiance from becoming negative",
       "refused",
       {"off", "mildest"}},
  };
}

}  // namespace

const Domain& skyDomain() {
  static const Domain kRows = rows();
  return kRows;
}

}  // namespace welkin::bake
