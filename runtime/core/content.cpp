// SPDX-License-Identifier: Apache-2.0
// Checks a file before anything samples it: every field is there, every size fits the other fields, and every number is
// in its domain. The container's checksum finds accidents. This check finds files that another program made.
#include <algorithm>
#include <cmath>

#include "core/sky.h"
#include "format/cubemap_format.h"
#include "format/day_numbers.h"
#include "format/domain_check.h"
#include "format/key_segment.h"

namespace welkin::core {
namespace {

/// Collects the first complaint.
struct Check {
  WelkinMessage* message;
  WelkinResult result = WELKIN_OK;

  bool that(bool holds, const char* what, const char* must) {
    if (!holds && result == WELKIN_OK) result = fail(message, WELKIN_ERROR_CONTENT, "%s %s", what, must);
    return holds && result == WELKIN_OK;
  }
};

using format::aligned;
using format::kAny;
using format::within;

constexpr double kDarkestColour = 1e-12;  // the illuminance is divided by its luminance

void checkCurve(Check& check, const format::Curve* curve, std::size_t components, double high, const char* name) {
  if (!check.that(curve != nullptr && curve->time_h() != nullptr && curve->value() != nullptr, name, "is missing"))
    return;
  if (!check.that(aligned(curve->time_h()) && aligned(curve->value()), name, "has misaligned numbers")) return;
  const auto times = spanOf(curve->time_h());
  const auto values = spanOf(curve->value());
  check.that(format::areKeyTimes(times), name, "must have ascending key times in [0, 24)");
  check.that(curve->components() == components && values.size() == times.size() * components, name,
             "must have a value for every key");
  check.that(within(values, 0.0, high), name, "has a value out of its domain");
}

void checkLight(Check& check, const format::Light& light, const char* name) {
  const auto* path = light.path();
  if (!check.that(path != nullptr, name, "has no path")) return;
  if (const char* fault = format::faultOf(*path); !check.that(fault == nullptr, name, fault)) return;
  check.that(within(light.disc_radius_rad(), 0.0, f64::kHalfPi), name, "has a disc radius out of [0, pi/2]");
  checkCurve(check, light.illuminance(), 1, kAny, name);
  checkCurve(check, light.colour(), 3, kAny, name);
  if (check.result != WELKIN_OK) return;
  const auto colour = spanOf(light.colour()->value());
  for (std::size_t i = 0; i < colour.size(); i += 3)
    check.that(f64::luminanceOf({colour[i], colour[i + 1], colour[i + 2]}) > kDarkestColour, name,
               "has a black colour");
}

/// Checks that the luminance of the normalising direction, by which the dome divides, is positive at every minute.
void checkNorm(Check& check, const format::Sky& sky) {
  const auto model = luminanceModel(*sky.luminance());
  const LightPath sun(*sky.sun()->path());
  for (int minute = 0; minute < 1440; ++minute) {
    const double norm =
        f64::luminanceNorm(model, sun.directionAt(minute / 60.0), sky.luminance()->normalise_to_sun() != 0);
    if (!check.that(within(norm, kLeastDivisor, kAny), "luminance",
                    "must be positive in the direction that it is relative to"))
      return;
  }
}

void checkGradient(Check& check, const format::Gradient* gradient, const char* name) {
  if (!check.that(gradient != nullptr && (gradient->rgb() != nullptr) != (gradient->rgb9e5() != nullptr), name,
                  "is missing"))
    return;
  const auto rgb = spanOf(gradient->rgb());
  const std::uint64_t texels = std::uint64_t{gradient->width()} * gradient->height();
  const std::size_t numbers = gradient->rgb() != nullptr ? rgb.size() : 3 * spanOf(gradient->rgb9e5()).size();
  check.that(texels > 0 && gradient->width() <= 65536 && gradient->height() <= 65536 && numbers == texels * 3, name,
             "must have three numbers for every texel");
  check.that(within(rgb, 0.0, kAny), name, "has a value out of its domain");
}

/// Largest stored magnitude; NaN or infinity if one is stored. Scales are not applied; another check multiplies them
/// in.
double largestStored(const format::Day& day) {
  const std::uint8_t* numbers = day.numbers()->data();
  const std::size_t count = day.numbers()->size() / format::bytesOf(day.encoding());
  double largest = 0.0;
  format::visitEncoding(day.encoding(), [&](auto encoding) {
    for (std::size_t i = 0; i < count && std::isfinite(largest); ++i)
      if (const double v = std::abs(format::storedNumber<encoding()>(numbers, i)); !(v <= largest)) largest = v;
  });
  return largest;
}

double largestScale(const flatbuffers::Vector<float>* scale) {
  double largest = scale == nullptr ? 1.0 : 0.0;
  for (const float s : spanOf(scale)) largest = std::max(largest, double{s});
  return largest;
}

void checkModes(Check& check, const format::Modes& modes, std::size_t bands) {
  const std::size_t count = modes.count();
  const std::size_t columns = modes.columns();
  const std::size_t rows = modes.rows();
  if (!check.that(count >= 1 && count <= kMostModes, "the modes", "must be 1 to 12") ||
      !check.that(columns >= 2 && columns <= 256 && rows >= 2 && rows <= 256, "the modes' map",
                  "must be 2 to 256 texels along an edge") ||
      !check.that(modes.texels() != nullptr && modes.polar_sh() != nullptr, "the modes", "have no map or no SH"))
    return;
  const auto texels = spanOf(modes.texels());
  const auto sh = spanOf(modes.polar_sh());
  check.that(texels.size() == columns * rows * count && sh.size() == count * format::polarCount(bands), "the modes",
             "must have every texel and coefficient");
  check.that(std::all_of(texels.begin(), texels.end(), format::isFiniteHalf) && within(sh, -1e6, 1e6), "the modes",
             "have a value out of their domain");
}

void checkDay(Check& check, const format::Sky& sky) {
  constexpr const char* kName = "the day's table";
  const auto* day = sky.day();
  if (!check.that(day != nullptr && day->numbers() != nullptr, kName, "is missing")) return;
  const std::size_t bands = day->bands();
  if (!check.that(bands >= 2 && bands <= WELKIN_MAX_BANDS, "bands", "must be 2 to 5") ||
      !check.that(day->channels() == 1 || day->channels() == 3, kName, "must have 1 or 3 channels") ||
      !check.that(day->encoding() <= format::Encoding::MAX, kName, "has an encoding that is not known") ||
      !check.that(aligned(day->key_time_h()), kName, "has misaligned key times"))
    return;
  const auto times = spanOf(day->key_time_h());
  if (!check.that(format::areKeyTimes(times), kName, "must have ascending key times in [0, 24)")) return;
  if (day->modes() != nullptr) checkModes(check, *day->modes(), bands);
  if (check.result != WELKIN_OK) return;
  const std::size_t coefficients = format::polarCount(bands);
  const std::size_t rows = day->rows();
  check.that(day->modes() != nullptr ? rows == day->modes()->count() : rows == coefficients || rows == coefficients + 1,
             kName, "must have a row for every coefficient or mode");
  const auto* albedo = sky.ground_albedo();
  const bool has_ground = albedo != nullptr && (albedo->r() > 0.0F || albedo->g() > 0.0F || albedo->b() > 0.0F);
  check.that(!has_ground || day->modes() != nullptr || rows == coefficients + 1, kName,
             "must have the horizontal irradiance, for the ground is not black");
  const std::size_t numbers = rows * day->channels();
  const bool has_row_scale = format::hasRowScale(day->encoding());
  check.that(day->numbers()->size() == times.size() * numbers * format::bytesOf(day->encoding()) &&
                 spanOf(day->key_scale()).size() == (format::hasKeyScale(day->encoding()) ? times.size() : 0) &&
                 spanOf(day->row_scale()).size() == (has_row_scale ? numbers : 0),
             kName, "must have a number and a scale for every key, row and channel");
  if (check.result != WELKIN_OK) return;
  check.that(within(spanOf(day->key_scale()), 0.0, kAny) && within(spanOf(day->row_scale()), 0.0, kAny), kName,
             "has a scale out of its domain");
  check.that(largestStored(*day) * largestScale(has_row_scale ? day->row_scale() : nullptr) *
                     largestScale(format::hasKeyScale(day->encoding()) ? day->key_scale() : nullptr) <=
                 kAny,
             kName, "has a value out of its domain");
}

void checkCertificate(Check& check, const format::Certificate& c) {
  constexpr const char* kName = "the certificate";
  if (!check.that(c.normal() != nullptr, kName, "has no normal")) return;
  const double numbers[] = {c.max_error(),     c.mean_error(),       c.quadrature(),    c.truncation(),
                            c.time(),          c.encoding(),         c.cubemap_error(), c.cubemap_resolution(),
                            c.cubemap_blend(), c.cubemap_encoding(), c.dome_error(),    c.blend_error()};
  check.that(within(std::span<const double>(numbers), 0.0, kAny), kName, "has an error out of its domain");
  const double normal[] = {c.normal()->x(), c.normal()->y(), c.normal()->z()};
  check.that(within(std::span<const double>(normal), -1.0, 1.0) && c.channel() <= 2 && c.time_h() >= 0.0 &&
                 c.time_h() < 24.0 && c.cubemap_time_h() >= 0.0 && c.cubemap_time_h() < 24.0 &&
                 c.blend_time_h() >= 0.0 && c.blend_time_h() < 24.0 && (c.method() == 1 || c.method() == 2),
             kName, "has a value out of its domain");
}

/// `bytes`: size of the file. It bounds the number of cubemaps. No writer lets cubemaps share texels, but if they did,
/// a small file could hold any number of them.
void checkCubemaps(Check& check, const format::Sky& sky, std::size_t bytes) {
  if (!check.that(sky.cubemap_format() < format::kCubemapFormats, "cubemap_format", "must be 0 to 2")) return;
  if (sky.cubemaps() == nullptr || sky.cubemaps()->size() == 0) return;
  const std::uint64_t size = sky.cubemap_size();
  if (!check.that(size >= 1 && size <= 16384, "cubemap_size", "must be 1 to 16384")) return;
  const auto texel_format = static_cast<format::CubemapFormat>(sky.cubemap_format());
  const std::uint64_t texels = format::texelsOfCubemap(size);
  const std::uint64_t texel_bytes = format::bytesOfCubemaps(texel_format, size);
  if (!check.that(sky.cubemaps()->size() <= bytes / texel_bytes, "a cubemap", "must have six faces of its own")) return;
  double before = -1.0;
  for (const auto* cubemap : *sky.cubemaps()) {
    check.that(cubemap->time_h() > before && cubemap->time_h() < 24.0, "the cubemaps",
               "must have ascending times in [0, 24)");
    before = cubemap->time_h();
    if (!check.that(cubemap->texels() != nullptr && cubemap->texels()->size() == texel_bytes, "a cubemap",
                    "must have six faces of texels of its format"))
      return;
    check.that(format::hasOnlyLight(texel_format, cubemap->texels()->data(), texels), "a cubemap",
               "has a texel that is negative or not finite");
  }
}

void checkStars(Check& check, const format::Stars& stars) {
  const std::uint64_t texels = std::uint64_t{stars.width()} * stars.height();
  if (!check.that(stars.rgba8() != nullptr, "stars", "have no texels")) return;
  check.that(texels > 0 && stars.width() <= 16384 && stars.height() <= 16384 && stars.rgba8()->size() == texels * 4,
             "stars", "must have four bytes for every texel");
  check.that(within(stars.intensity(), 0.0, kAny) && within(stars.latitude_rad(), -f64::kHalfPi, f64::kHalfPi) &&
                 within(stars.north_offset_rad(), -kAny, kAny) && within(stars.midnight_h(), 0.0, 24.0),
             "stars", "have a value out of its domain");
}

}  // namespace

WelkinResult checkContent(const format::File& file, std::size_t bytes, WelkinMessage* message) {
  Check check{message};
  const auto* sky = file.sky();
  if (!check.that(sky != nullptr, "sky", "is missing")) return check.result;
  check.that(file.settings() != nullptr, "settings", "are missing");
  const auto* l = sky->luminance();
  if (check.that(l != nullptr, "luminance", "is missing")) {
    check.that(within(l->a(), -kAny, kAny) && within(l->c(), -kAny, kAny) && within(l->e(), -kAny, kAny) &&
                   within(l->k(), -kAny, kAny) && l->b() < 0.0 && l->d() < 0.0 && within(l->b(), -kAny, 0.0) &&
                   within(l->d(), -kAny, 0.0) && l->normalise_to_sun() <= 1,
               "luminance", "has a coefficient out of its domain");
    const auto m = luminanceModel(*l);
    check.that(f64::gradation(m, 1.0) > 0.0 && f64::indicatrix(m, 0.0) > 0.0, "luminance",
               "must be positive at the zenith and the sun");
  }
  if (check.that(sky->ground_albedo() != nullptr, "ground_albedo", "is missing")) {
    const auto* a = sky->ground_albedo();
    check.that(within(double{a->r()}, 0, 1) && within(double{a->g()}, 0, 1) && within(double{a->b()}, 0, 1),
               "ground_albedo", "must be 0 to 1");
  }
  check.that(within(sky->luminance_unit(), kLeastDivisor, kAny), "luminance_unit", "must be positive");
  check.that(within(sky->gradient_delta(), kLeastDivisor, kAny), "gradient_delta", "must be positive");
  checkCurve(check, sky->intensity(), 1, kAny, "intensity");
  checkCurve(check, sky->ambient_saturation(), 1, 1.0, "ambient_saturation");
  checkCurve(check, sky->polarising_tint(), 3, kAny, "polarising_tint");
  if (check.that(sky->sun() != nullptr, "sun", "is missing")) checkLight(check, *sky->sun(), "sun");
  if (sky->stars() != nullptr) checkStars(check, *sky->stars());
  if (sky->moon() != nullptr) checkLight(check, *sky->moon(), "moon");
  if (check.result == WELKIN_OK) checkNorm(check, *sky);
  checkGradient(check, sky->gradient_sun(), "gradient_sun");
  checkGradient(check, sky->gradient_anti(), "gradient_anti");
  checkDay(check, *sky);
  if (sky->certificate() != nullptr) checkCertificate(check, *sky->certificate());
  checkCubemaps(check, *sky, bytes);
  return check.result;
}

}  // namespace welkin::core
