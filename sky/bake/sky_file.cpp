// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/sky_file.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "sky/bake/sky_domain.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/message.h"
#include "sky/base/section.h"
#include "sky/image/image.h"

namespace welkin::bake {

using det::Number3;
namespace {

using Json = nlohmann::ordered_json;

/// The file's folder, and the inputs read so far, with warnings of their headers. Each is read once: its hash is that
/// of the bytes which are decoded.
struct Reading {
  std::filesystem::path folder;
  std::vector<Input> inputs;
  std::map<std::filesystem::path, std::vector<std::byte>> pictures;
  std::vector<model::Warning> warnings;

  void record(const std::string& name, const std::filesystem::path& path, std::span<const std::byte> bytes) {
    for (const Input& input : inputs)
      if (input.path == path) return;
    inputs.push_back(inputOf(name, path, bytes));
  }
  /// Reads the picture that `section`.`key` names.
  image::Image image(const std::string& section, const base::TomlTable& table, const std::string& key,
                     const toml::node& at) {
    const auto name = *at.value<std::string>();
    const std::filesystem::path path = folder / name;
    try {
      const auto [picture, is_new] = pictures.try_emplace(path);
      if (is_new) picture->second = base::readFile(path);
      record(name, path, picture->second);
      image::Image image = image::readImage(path.string(), picture->second);
      for (const std::string& note : image.notes)  // of what the header did to the numbers
        warnings.push_back({"picture", 1,
                            fmt::format("{}:{}: {}.{} = '{}': {}", inputs.front().name, at.source().begin.line, section,
                                        key, base::oneLine(name), base::oneLine(note))});
      return image;
    } catch (const base::Error& e) {
      table.refuse(key, &at, e.what(), e.status());
    }
  }
};

model::Gradient readGradient(base::Section& section, const std::string& key, Reading& reading) {
  const toml::node* n = section.table().node(key);
  if (n == nullptr || !n->is_string()) return model::Gradient::constant(section.colour(key));
  const image::Image image = reading.image("sky", section.table(), key, *n);
  model::Gradient gradient{image.width, image.height, {}};
  const auto line = static_cast<std::size_t>(image.width) * 3;
  for (int row = image.height - 1; row >= 0; --row) {  // The file's last row is the horizon.
    const auto first = image.rgb.begin() + static_cast<std::ptrdiff_t>(line * static_cast<std::size_t>(row));
    gradient.rgb.insert(gradient.rgb.end(), first, first + static_cast<std::ptrdiff_t>(line));
  }
  return gradient;
}

/// Reads a tint: a colour, keys, or an image strip over the day whose rows are averaged.
base::Curve readTint(base::Section& section, Reading& reading) {
  const toml::node* n = section.table().node("polarising_tint");
  if (n == nullptr || !n->is_string()) return section.colourCurve("polarising_tint");
  const image::Image image = reading.image("sky", section.table(), "polarising_tint", *n);
  base::Curve curve{3, {}, {}};
  for (int i = 0; i < image.width; ++i) {
    Number3 sum(0.0);
    for (int j = 0; j < image.height; ++j) {
      const float* p = image.rgb.data() + 3 * (static_cast<std::size_t>(j) * static_cast<std::size_t>(image.width) +
                                               static_cast<std::size_t>(i));
      sum += Number3(double{p[0]}, double{p[1]}, double{p[2]});
    }
    curve.time_h.push_back(24.0 * (i + 0.5) / image.width);
    curve.value.insert(curve.value.end(), {sum.x / image.height, sum.y / image.height, sum.z / image.height});
  }
  return curve;
}

model::LuminanceModel readLuminance(base::Section& section) {
  base::TomlTable& table = section.table();
  const toml::node* n = table.node("luminance");
  if (n == nullptr || n->is_string()) return *model::findLuminance(section.word("luminance"));
  const toml::array* a = n->as_array();
  if (a == nullptr || a->size() != 5)
    table.refuse("luminance", n, "must be a name or five coefficients [a, b, c, d, e]");
  double v[5];
  for (std::size_t i = 0; i < 5; ++i) {
    const auto value = a->get(i)->value<double>();
    const base::Range& range = section.rangeOf("luminance", std::string_view("abcde").substr(i, 1));
    // Both signs pass here. whyUnusable checks which coefficients must be negative under the day's sun.
    if (!value || !a->get(i)->is_number() || !(std::abs(*value) <= -range.low))
      table.refuse("luminance", n,
                   fmt::format("coefficient {} must be a number, {} to {}", "abcde"[i], range.low, -range.low));
    v[i] = *value;
  }
  return {v[0], v[1], v[2], v[3], v[4], 0.0};
}

void readHandPath(base::Section& section, model::LightPath& path) {
  const auto rows = section.rows("path", {"azimuth_deg", "elevation_deg"});
  for (const auto& row : rows) {
    path.key_time_h.push_back(row[0]);
    path.key_azimuth_rad.push_back(row[1] * det::kDegree + path.north_offset_rad);
    path.key_elevation_rad.push_back(row[2] * det::kDegree);
  }
}

void readLightLook(base::Section& section, model::Light& light) {
  base::TomlTable& table = section.table();
  light.illuminance = section.curve("illuminance");
  light.colour = section.colourCurve("colour");
  for (std::size_t i = 0; i < light.colour.time_h.size(); ++i) {
    const double* c = light.colour.value.data() + 3 * i;
    if (!(det::luminanceOf({c[0], c[1], c[2]}) > 1e-12))
      table.refuse("colour", table.node("colour"),
                   "must not be black: it gives hue and saturation, illuminance the rest");
  }
  light.disc_radius_rad = section.number("disc_radius_deg") * det::kDegree;
}

model::Light readSun(base::Section section) {
  model::Light sun;
  const double north = section.number("north_offset_deg") * det::kDegree;
  sun.path.north_offset_rad = north;
  readHandPath(section, sun.path);
  if (sun.path.key_time_h.empty()) {
    const double latitude = section.number("latitude_deg");
    const double longitude = section.number("longitude_deg");
    const double offset = section.number("utc_offset_h", longitude / 15.0);
    const int year = section.wholeNumber("year");
    const int day = section.wholeNumber("day_of_year");
    sun.path = model::sunPathFromPlace(latitude, longitude, offset, year, day);
    sun.path.north_offset_rad = north;
  } else {
    section.excludeBesidePath("cannot stand beside path: a sun has a place and a day, or a path");
  }
  readLightLook(section, sun);
  section.table().finish();
  return sun;
}

model::Light readMoon(base::Section section, const model::LightPath& sun) {
  model::Light moon;
  moon.path.north_offset_rad = section.number("north_offset_deg", sun.north_offset_rad / det::kDegree) * det::kDegree;
  readHandPath(section, moon.path);
  if (moon.path.key_time_h.empty()) {
    if (!section.table().has("declination_deg"))
      section.table().refuse("path", nullptr, "is missing; a moon needs path, or declination_deg and phase");
    const bool sun_has_place = sun.key_time_h.empty();
    moon.path.latitude_rad =
        section.number("latitude_deg", sun_has_place ? std::optional(sun.latitude_rad / det::kDegree) : std::nullopt) *
        det::kDegree;
    moon.path.declination_rad = section.number("declination_deg") * det::kDegree;
    // A new moon (0) crosses the meridian with the sun, a full moon (1/2) twelve hours later.
    moon.path.transit_h = (sun_has_place ? sun.transit_h : 12.0) + 24.0 * section.number("phase");
  } else {
    section.excludeBesidePath("cannot stand beside path");
  }
  readLightLook(section, moon);
  section.table().finish();
  return moon;
}

/// The map turns with the sun's daily circle. For a hand-drawn path it turns about the zenith of latitude 0, with noon
/// at 12 h.
model::Stars readStars(base::Section section, const model::LightPath& sun, Reading& reading) {
  base::TomlTable& table = section.table();
  const base::Range& values = section.rangeOf("image");
  const toml::node* n = table.node("image");
  if (n == nullptr || !n->is_string()) table.refuse("image", n, "must be the name of a star map, an image");
  const image::Image image = reading.image("stars", table, "image", *n);
  model::Stars stars;
  stars.width = image.width;
  stars.height = image.height;
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const double linear = double{image.rgb[i]};
    if (!values.contains(linear))
      table.refuse("image", n,
                   fmt::format("a star map's values must be {} to {}; one is {}: intensity scales them", values.low,
                               values.high, linear));
    stars.rgba.push_back(static_cast<std::uint8_t>(std::floor(det::srgbEncode(linear) * 255.0 + 0.5)));
    if (i % 3 == 2) stars.rgba.push_back(255);
  }
  stars.intensity = section.number("intensity");
  const bool sun_has_place = sun.key_time_h.empty();
  stars.latitude_rad = sun_has_place ? sun.latitude_rad : 0.0;
  stars.north_offset_rad = sun.north_offset_rad;
  stars.midnight_h = format::wrapTime((sun_has_place ? sun.transit_h : 12.0) + 12.0);
  table.finish();
  return stars;
}

void warnOfPath(base::TomlTable& table, const std::string& light, const model::LightPath& path, SkyFile& file) {
  for (model::Warning& w : model::pathWarningsOf(path, light)) {
    w.id = light + "-" + w.id;
    w.message = fmt::format("{}:{}: {}.path: {}", file.inputs.front().name, table.node("path")->source().begin.line,
                            light, w.message);
    file.warnings.push_back(std::move(w));
  }
}

/// TOML as JSON. Dates are no values of a sky file, and the keys are checked before.
Json jsonOf(const toml::node& node) {
  if (const toml::table* table = node.as_table()) {
    Json json = Json::object();
    for (const auto& [key, value] : *table) json[std::string(key.str())] = jsonOf(value);
    return json;
  }
  if (const toml::array* array = node.as_array()) {
    Json json = Json::array();
    for (const toml::node& value : *array) json.push_back(jsonOf(value));
    return json;
  }
  if (const auto* number = node.as_floating_point()) return number->get();
  if (const auto* whole = node.as_integer()) return whole->get();
  if (const auto* boolean = node.as_boolean()) return boolean->get();
  if (const auto* text = node.as_string()) return text->get();
  return {};
}

}  // namespace

Input inputOf(const std::string& name, const std::filesystem::path& path, std::span<const std::byte> bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return {name, path, hash.low64, hash.high64};
}

SkyFile readSkyFile(const std::filesystem::path& path) {
  return skyFileOf(base::readToml(path));
}

SkyFile skyFileOf(const base::TomlFile& toml) {
  const std::string file = toml.path.string();
  const toml::table& root = toml.root;
  Reading reading{toml.path.parent_path(), {}, {}, {}};
  reading.record(toml.path.filename().string(), toml.path, toml.bytes);
  SkyFile result;
  base::TomlTable top(file, &root, "");
  model::Sky& sky = result.sky;
  if (!top.has("sky")) top.refuse("[sky]", nullptr, "is missing: this is not a sky file");
  base::Section section(top, "sky", skyDomain());
  sky.luminance = readLuminance(section);
  sky.normalise_to_sun = section.word("normalise") == "sun";
  sky.intensity = section.curve("intensity");
  sky.gradient_sun = readGradient(section, "gradient_sun", reading);
  sky.gradient_anti = readGradient(section, "gradient_anti", reading);
  model::normalise(sky.gradient_sun, sky.gradient_anti);
  sky.polarising_tint = readTint(section, reading);
  sky.ambient_saturation = section.curve("ambient_saturation");
  sky.ground_albedo = section.colour("ground_albedo");
  sky.luminance_unit = section.number("luminance_unit");
  section.table().finish();

  base::Section sun(top, "sun", skyDomain());
  if (!top.has("sun")) top.refuse("[sun]", nullptr, "is missing; a sky needs latitude_deg and day_of_year, or path");
  sky.sun = readSun(sun);
  base::Section moon(top, "moon", skyDomain());
  if (top.has("moon")) sky.moon = readMoon(moon, sky.sun.path);
  base::Section stars(top, "stars", skyDomain());
  if (top.has("stars")) sky.stars = readStars(stars, sky.sun.path, reading);
  result.bake = readBake(base::Section(top, "bake", skyDomain()));
  top.finish();

  base::TomlTable checked(file, root.get_as<toml::table>("sky"), "sky.");
  if (const auto why = model::whyUnusable(sky.luminance, sky.sun.path))
    checked.refuse("luminance", checked.node("luminance"), *why);
  result.settings = jsonOf(root).dump(2);
  result.inputs = std::move(reading.inputs);
  // A comment in the sky file changes no baked byte: its hash is that of its settings.
  result.inputs.front() = inputOf(toml.path.filename().string(), toml.path, std::as_bytes(std::span(result.settings)));
  result.warnings = std::move(reading.warnings);
  warnOfPath(sun.table(), "sun", sky.sun.path, result);
  if (sky.moon) warnOfPath(moon.table(), "moon", sky.moon->path, result);
  return result;
}

}  // namespace welkin::bake
