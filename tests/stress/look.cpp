// SPDX-License-Identifier: Apache-2.0
#include "look.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "draw.h"
#include "sensitivity.h"
#include "sky/bake/sky_file.h"
#include "sky/base/error.h"
#include "steps.h"

namespace welkin::stress {
namespace {

using det::Number3;
using model::SkyInstant;
using tests::Baked;
using tests::Fault;

constexpr double kFloat = 1e-6;  ///< relative error of a radiance in floats

/// `d` rounded to floats. Not inlined, because GCC 12 drops the two conversions then.
[[gnu::noinline]] Number3 rounded(const Number3& d) {
  return {double{float(d.x)}, double{float(d.y)}, double{float(d.z)}};
}

/// The sky under test and everything that is drawn for it.
class Look {
 public:
  Look(Random& random, bake::SkyFile file, Outcome& outcome)
      : random_(random), file_(std::move(file)), outcome_(outcome), keys_(keysOf(file_)) {
    if (random_.once(2)) drawGradients();
    baked_.emplace(file_.sky, file_.bake.bands, keys_);
  }

  /// Checks everything, until the first fault.
  Fault run(const Effort& effort) {
    for (int i = 0; i < effort.instants; ++i)
      if (const Fault fault = instant(drawTime(), effort.directions); !fault.empty()) return fault;
    if (const Fault fault = stepInTime(); !fault.empty()) return fault;
    if (const Fault fault = stepInDirection(); !fault.empty()) return fault;
    if (random_.once(4))
      if (const Fault fault = cubemap(); !fault.empty()) return fault;
    return random_.once(32) ? bakeError() : Fault();
  }

 private:
  static std::vector<double> keysOf(const bake::SkyFile& file) {
    constexpr std::size_t kMost = 6;
    std::vector<double> keys = file.bake.key_time_h;
    if (keys.size() > kMost) keys = {keys[0], keys[keys.size() / 2]};
    return keys;
  }

  void drawGradients() {
    file_.sky.gradient_sun = drawGradient(random_);
    file_.sky.gradient_anti = drawGradient(random_);
    for (const auto* g : {&file_.sky.gradient_sun, &file_.sky.gradient_anti})
      outcome_.gradients += fmt::format("a gradient of {} x {}: {}\n", g->width, g->height, fmt::join(g->rgb, " "));
    normalise(file_.sky.gradient_sun, file_.sky.gradient_anti);
  }

  double drawTime() {
    if (random_.once(4)) {
      const auto& times =
          random_.once(2) || file_.sky.sun.path.key_time_h.empty() ? keys_ : file_.sky.sun.path.key_time_h;
      const double key = times[static_cast<std::size_t>(random_.below(static_cast<int>(times.size())))];
      return random_.once(2) ? key : std::nextafter(key, random_.between(-1.0, 25.0));
    }
    return random_.between(0.0, 24.0);
  }

  Fault instant(double time_h, int directions) {
    const SkyInstant instant(file_.sky, time_h);
    WelkinSkySample sample{};
    if (!baked_->sky.sample(time_h, sample)) return fmt::format("no sample at {} h", time_h);
    if (const Fault fault = tests::faultOfSample(sample); !fault.empty()) return at(time_h) + fault;
    std::vector<Number3> looked = tests::specialDirections(instant.sunDirection());
    while (static_cast<int>(looked.size()) < directions) looked.push_back(drawDirection(random_));
    for (const Number3& d : looked) {
      ++outcome_.evaluations;
      Fault fault = tests::faultOfModel(instant, d);
      if (fault.empty()) fault = tests::faultOfDirection(baked_->sky, sample, d);
      if (fault.empty()) fault = domeError(instant, sample, rounded(d));
      if (!fault.empty()) return at(time_h) + fmt::format("direction ({}, {}, {}): ", d.x, d.y, d.z) + fault;
    }
    return {};
  }

  /// Compares the runtime's dome, in floats, with the model's.
  Fault domeError(const SkyInstant& instant, const WelkinSkySample& sample, const Number3& d) {
    if (d.y < 0.0) return {};
    const Number3 wanted = instant.dome(d, Number3(0.0));
    const double allowed = kFloat + kFloatDirection * sensitivityAt(instant, d);
    if (allowed > 0.1) return {};  // too steep for a direction in floats
    const float f[3] = {float(d.x), float(d.y), float(d.z)};
    float got[3];
    welkin_dome_radiance(baked_->sky.get(), &sample, f, got);
    const double size = tests::domeOf(instant, d).size;
    for (int c = 0; c < 3; ++c) {
      const double expected = std::min(wanted[c], double{std::numeric_limits<float>::max()});
      const double error = std::abs(double{got[c]} - expected) / (allowed * size + 1e-36);
      outcome_.dome_error = std::max(outcome_.dome_error, error);
      if (!(error <= 1.0))
        return fmt::format("the runtime's dome is {}, the model's {}, {} of {} apart", got[c], expected, allowed, size);
    }
    return {};
  }

  Fault stepInTime() {
    const double middle = drawTime();
    const Number3 direction = rounded(det::directionOf(random_.between(0, 6.28), 0.7));
    return note(searchTime(file_.sky, baked_->sky, middle - random_.magnitude(1e-7, 0.1), middle + 0.03, direction));
  }

  /// Searches the sun's vertical plane, or any other.
  Fault stepInDirection() {
    const double time_h = drawTime();
    const Number3 sun = SkyInstant(file_.sky, time_h).sunDirection();
    const double azimuth = random_.once(2) ? std::atan2(sun.x, -sun.z) : random_.between(0.0, 6.28);
    return note(searchArc(file_.sky, baked_->sky, time_h, azimuth, random_.magnitude(1e-6, 1.0)));
  }

  Fault note(const Searched& searched) {
    outcome_.step_measured = outcome_.step_measured || searched.measured;
    return searched.fault;
  }

  Fault cubemap() {
    constexpr int kSize = 4;
    const SkyInstant instant(file_.sky, drawTime());
    const auto image =
        cubemap::renderDome(instant, instant.groundRadiance(Number3(1.0)), cubemap::Layout::vulkan_cube, kSize);
    for (const std::uint16_t half : image.rgb_half)
      if (half >= 0x7c00) return at(instant.time_h()) + fmt::format("a texel's half float is {:#x}", half);
    return {};
  }

  Fault bakeError() {
    const SkyInstant instant(file_.sky, keys_[0]);
    WelkinSkySample sample{};
    if (instant.intensity() < 1e-12 || !baked_->sky.sample(keys_[0], sample)) return {};
    const auto exact = model::SkyProjector(file_.sky.luminance, file_.bake.bands, 1e-12).project(instant);
    const Number3 c0 = exact.radiance_sh[0] * instant.intensity();
    if (std::max({c0.x, c0.y, c0.z}) > 1e37) return {};
    const float* g = sample.ground_radiance;
    const Number3 ground(double{g[0]}, double{g[1]}, double{g[2]});
    const auto up = det::shBasis({0, 1, 0});
    for (std::size_t i = 0; i < exact.radiance_sh.size(); ++i) {
      const int band = i < 1 ? 0 : i < 4 ? 1 : i < 9 ? 2 : i < 16 ? 3 : 4;
      const Number3 wanted = exact.radiance_sh[i] * instant.intensity() + ground * (det::groundLobe(band) * up.v[i]);
      for (int c = 0; c < 3; ++c) {
        const double error =
            std::abs(double{sample.radiance_sh[i][c]} - wanted[c]) / (std::max({c0.x, c0.y, c0.z}) + ground[c] + 1e-30);
        outcome_.bake_error = std::max(outcome_.bake_error, error);
      }
    }
    if (outcome_.bake_error < model::kTolerance) return {};
    return fmt::format("the key at {} h is {} of c0 off, more than {}", keys_[0], outcome_.bake_error,
                       model::kTolerance);
  }

  static std::string at(double time_h) { return fmt::format("{} h: ", time_h); }

  Random& random_;
  bake::SkyFile file_;
  Outcome& outcome_;
  std::vector<double> keys_;
  std::optional<Baked> baked_;
};

}  // namespace

std::string skyFileOf(std::uint64_t seed, std::uint64_t index) {
  Random random(seed, index);
  return drawSkyFile(random);
}

Outcome lookAt(std::uint64_t seed, std::uint64_t index, const Effort& effort, const tests::Folder& folder) {
  Outcome outcome;
  Random random(seed, index);
  const std::string path = folder.write("sky.toml", drawSkyFile(random));
  std::optional<bake::SkyFile> file;
  try {
    file = bake::readSkyFile(path);
  } catch (const base::Error& e) {
    outcome.refused = true;
    // Numbers are drawn inside their ranges. The loader may still refuse coefficients that make no sky, black light, or
    // cubemaps that are too large.
    const std::string why = e.what();
    const bool expected =
        why.find("makes the luminance") != std::string::npos || why.find("must not be black") != std::string::npos ||
        why.find("bytes; at most") != std::string::npos || why.find("cubemap_size") != std::string::npos;
    if (!expected || e.status() != base::ExitStatus::content) outcome.fault = "refused: " + why;
    return outcome;
  }
  try {
    outcome.fault = Look(random, *std::move(file), outcome).run(effort);
  } catch (const std::exception& e) {
    outcome.fault = e.what();
  }
  return outcome;
}

}  // namespace welkin::stress
