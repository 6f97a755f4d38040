// SPDX-License-Identifier: Apache-2.0
// Bakes and plans two skies and projects pictures with 1, 2 and 8 threads, and prints a checksum of every product. The
// lines are the same from any compiler, at any optimisation, on any x86-64 or ARM64 processor.
//   same_bytes [FILE [THREADS]]      FILE: compares the lines with this file; THREADS: only with so many threads
#include <tbb/global_control.h>
#include <xxhash.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "sh/arithmetic.h"
#include "sh/environment.h"
#include "sky/bake/encode.h"
#include "sky/cubemap/exr.h"
#include "sky/table/plan.h"

namespace welkin::tests {

using det::Number3;
namespace {

constexpr const char* kHeader =
    "# XXH3-128 of what is baked in memory; after a deliberate change of that:\n"
    "#   build/release/tests/sky/same_bytes > tests/golden/same_bytes.txt\n";

/// Lines "NAME CHECKSUM". Products that depend on the version of a library are kept apart.
struct Products {
  std::string lines, others;
};

template <typename Range>
std::string checksum(const Range& values) {
  const XXH128_hash_t hash = XXH3_128bits(values.data(), values.size() * sizeof(*values.data()));
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return text;
}

template <typename Range>
void add(std::string& lines, const std::string& name, const Range& values) {
  lines += name + " " + checksum(values) + "\n";
}

/// Numbers in [0, 1) from a linear congruence (Knuth, MMIX): 24 bits, exact in float.
class Numbers {
 public:
  float next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<float>(state_ >> 40U) * 0x1p-24F;
  }
  std::vector<float> list(std::size_t count, float largest) {
    std::vector<float> values(count);
    for (float& v : values) v = next() * largest;
    return values;
  }

 private:
  std::uint64_t state_ = 2012;
};

model::Gradient gradient(Numbers& numbers, int width, int height, float largest) {
  return {width, height, numbers.list(static_cast<std::size_t>(width * height) * 3, largest)};
}

std::vector<double> spread(int count) {
  std::vector<double> time_h;
  for (int i = 0; i < count; ++i) time_h.push_back(24.0 * i / count);
  return time_h;
}

/// A sky with every setting in use and colours that change all day.
bake::SkyFile colourful() {
  bake::SkyFile file;
  Numbers numbers;
  model::Sky& sky = file.sky;
  sky.intensity = {1, {4.5, 6.5, 12.0, 18.9}, {0.004, 0.8, 2.0, 0.08}};
  sky.gradient_sun = gradient(numbers, 7, 5, 1.0F);
  sky.gradient_anti = gradient(numbers, 4, 9, 0.3F);
  model::normalise(sky.gradient_sun, sky.gradient_anti);
  sky.polarising_tint = {3, {6.0, 15.0}, {0.9, 1.0, 1.1, 1.0, 0.95, 0.8}};
  sky.ambient_saturation = {1, {3.0, 14.0}, {0.4, 0.9}};
  sky.ground_albedo = {0.1, 0.12, 0.07};
  sky.luminance_unit = 4000.0;
  sky.sun.path = model::sunPathFromPlace(17.0, -3.5, 1.0, 2012, 172);
  sky.sun.path.north_offset_rad = 0.3;
  sky.sun.illuminance = {1, {5.4, 12.0, 18.8}, {0.0, 3.0, 0.0}};
  sky.sun.colour = {3, {7.0, 18.0}, {1.0, 0.8, 0.6, 1.0, 0.7, 0.45}};
  sky.sun.disc_radius_rad = 0.00465;
  model::Light moon;
  moon.path.key_time_h = {0.0, 6.0, 12.0, 18.5};
  moon.path.key_azimuth_rad = {3.1, 4.7, 0.0, 1.6};
  moon.path.key_elevation_rad = {1.1, -0.1, -1.0, -0.05};
  moon.illuminance = {1, {4.0, 20.5}, {0.012, 0.008}};
  moon.colour = base::Curve::constant(Number3(0.75, 0.85, 1.0));
  sky.moon = moon;
  file.bake = {5, spread(24), 16, {6.25, 19.0}};
  return file;
}

/// A sky for the other branches: a standard type normalised to the zenith, gradients that fade out, a sun drawn by
/// hand.
bake::SkyFile faded() {
  bake::SkyFile file;
  Numbers numbers;
  model::Sky& sky = file.sky;
  sky.luminance = *model::findLuminance("cie-12");
  sky.normalise_to_sun = false;
  sky.gradient_sun = gradient(numbers, 3, 6, 1e-4F);
  sky.gradient_sun.rgb[0] = 1.0F;  // The only bright texel; elsewhere colours are below kGradientDelta.
  sky.gradient_anti = gradient(numbers, 5, 3, 3e-5F);
  model::normalise(sky.gradient_sun, sky.gradient_anti);
  sky.sun.path.key_time_h = {2.0, 9.0, 13.0, 21.0};
  sky.sun.path.key_azimuth_rad = {0.4, 2.0, 3.9, 5.5};
  sky.sun.path.key_elevation_rad = {-0.9, 0.02, 1.5, -0.3};
  sky.sun.illuminance = base::Curve::constant(1.0);
  file.bake = {5, spread(23), 8, {9.0, 13.0}};
  return file;
}

void bake(bake::SkyFile file, const std::string& name, Products& products) {
  file.settings = "{}";
  file.inputs = {{name + ".toml", {}, 1, 2}};
  const table::DayTable table = table::bakeDayTable(file.sky, file.bake.bands, file.bake.key_time_h, {});
  add(products.lines, name + ".day", table.number);
  for (const table::Encoding encoding : format::kEncodings)
    add(products.lines, name + "." + nameOf(encoding), table::encodeNumbers(table, encoding).numbers);
  const model::SkyProjector projector(file.sky.luminance, 1);
  std::vector<cubemap::Cubemap> cubemaps;
  for (const double time_h : file.bake.cubemap_time_h) {
    const model::SkyInstant instant(file.sky, time_h);
    const Number3 ground = instant.groundRadiance(projector.project(instant).horizontal_irradiance);
    const std::string at = name + "." + std::to_string(static_cast<int>(time_h)) + "h.";
    for (const auto& [layout, layout_name] : {std::pair(cubemap::Layout::vulkan_cube, "vulkan_cube"),
                                              {cubemap::Layout::exr_cube, "exr_cube"},
                                              {cubemap::Layout::exr_latlong, "exr_latlong"}}) {
      const cubemap::DomeImage image = cubemap::renderDome(instant, ground, layout, file.bake.cubemap_size);
      add(products.lines, at + layout_name, image.rgb_half);
      if (layout != cubemap::Layout::vulkan_cube)
        add(products.others, at + layout_name, cubemap::encodeExr(image, layout, file.sky.luminance_unit));
    }
    for (const auto packed : {format::CubemapFormat::rgb9e5, format::CubemapFormat::b10g11r11})
      add(products.lines, at + format::nameOf(packed),
          cubemap::renderCubemap(instant, ground, file.bake.cubemap_size, packed).texels);
    cubemaps.push_back(cubemap::renderCubemap(instant, ground, file.bake.cubemap_size, file.bake.cubemap_format));
  }
  add(products.lines, name + ".welkin", bake::encodeSky(file, table, cubemaps));
}

/// Plans for a budget, from samples every hour.
void plan(const model::Sky& sky, const std::string& name, Products& products) {
  const table::DayFields fields = table::sampleDay(sky, table::hoursOfInterest(sky, 1.0), table::brightestOf(sky), {});
  const table::ErrorGrid grid;
  table::PlanRequest request;
  for (const auto& [reconstruction, of, budget] :
       {std::tuple(table::Reconstruction::fitted, "fitted", 0.1), {table::Reconstruction::modes, "modes", 0.03}}) {
    request.reconstruction = reconstruction;
    request.max_error = budget;
    const table::DayPlan chosen = table::planDay(table::DayValues(fields, grid), request);
    const std::string at = name + ".plan." + of;
    add(products.lines, at + ".keys", chosen.table.key_time_h);
    add(products.lines, at + ".numbers", chosen.table.number);
    add(products.lines, at + ".stored", table::encodeNumbers(chosen.table, chosen.encoding).numbers);
    if (!chosen.table.modes) continue;
    add(products.lines, at + ".map", chosen.table.modes->texels);
    add(products.lines, at + ".polar_sh", chosen.table.modes->polar_sh);
  }
}

void project(Products& products) {
  constexpr int kSize = 24;
  Numbers numbers;
  const auto cube = numbers.list(std::size_t{6} * kSize * kSize * 3, 10.0F);
  const auto latlong = numbers.list(std::size_t{48} * 24 * 3, 10.0F);
  for (const auto& [rule, name] :
       {std::pair(sh::TexelRule::half_texel, "half_texel"), {sh::TexelRule::edge_centres, "edge_centres"}}) {
    std::array<sh::CubeFace, 6> faces;
    for (int f = 0; f < 6; ++f) {
      const cubemap::FaceAxes axes = cubemap::faceAxes(cubemap::Layout::exr_cube, f);
      faces[static_cast<std::size_t>(f)] = {cube.data() + f * kSize * kSize * 3, kSize * 3, axes.right, axes.down,
                                            axes.normal};
    }
    add(products.lines, std::string("cube.") + name, sh::projectCube(faces, kSize, rule, sh::kMostBands));
    add(products.lines, std::string("latlong.") + name,
        sh::projectLatlong(latlong.data(), 48, 24, rule, sh::kMostBands));
  }
}

Products make(std::size_t threads) {
  const tbb::global_control most(tbb::global_control::max_allowed_parallelism, threads);
  Products products;
  bake(colourful(), "colourful", products);
  bake(faded(), "faded", products);
  plan(colourful().sky, "colourful", products);
  plan(faded().sky, "faded", products);
  project(products);
  return products;
}

/// Reports the lines that differ. Returns false when any does.
bool same(const std::string& got, const std::string& want, const char* of) {
  if (got == want) return true;
  std::istringstream a(got), b(want);
  for (std::string x, y; std::getline(a, x), std::getline(b, y), a || b; x.clear(), y.clear())
    if (x != y) std::fprintf(stderr, "%s:\n  %s\n  %s here\n", of, y.c_str(), x.c_str());
  return false;
}

int run(const char* golden, const std::vector<std::size_t>& threads) {
  if (const char* why = sh::whyArithmeticDiffers()) return std::fprintf(stderr, "%s\n", why), 1;
  const Products first = make(threads.front());
  bool good = true;
  for (std::size_t i = 1; i < threads.size(); ++i) {
    const Products more = make(threads[i]);
    const std::string name = std::to_string(threads[i]) + " threads and " + std::to_string(threads.front());
    good = same(more.lines, first.lines, name.c_str()) && same(more.others, first.others, name.c_str()) && good;
  }
  const std::string text = kHeader + first.lines;
  std::fputs(text.c_str(), stdout);
  if (golden != nullptr) {
    std::ifstream file(golden);
    good = same(text, {std::istreambuf_iterator<char>(file), {}}, golden) && good;
  }
  return good ? 0 : 1;
}

}  // namespace
}  // namespace welkin::tests

int main(int argc, char** argv) {
  const long threads = argc > 2 ? std::strtol(argv[2], nullptr, 10) : 0;
  return welkin::tests::run(argc > 1 ? argv[1] : nullptr, threads > 0 ? std::vector{static_cast<std::size_t>(threads)}
                                                                      : std::vector<std::size_t>{1, 2, 8});
}
