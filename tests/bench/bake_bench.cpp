// SPDX-License-Identifier: Apache-2.0
// The cost of baking, beside its physical limits: the evaluations of the sky alone, and one read of the texels.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <array>
#include <cmath>

#include "sh/environment.h"
#include "sky/base/toml_table.h"
#include "sky/cubemap/cubemap.h"
#include "sky/table/day_table.h"

namespace {

using namespace welkin;

/// A clear tropical day with gradients of 96 x 32 texels.
model::Sky exampleSky() {
  model::Sky sky;
  sky.sun.path = model::sunPathFromPlace(17.0, 0.0, 0.0, 2012, 172);
  for (model::Gradient* gradient : {&sky.gradient_sun, &sky.gradient_anti}) {
    gradient->width = 96;
    gradient->height = 32;
    gradient->rgb.clear();
    for (int j = 0; j < 32; ++j)
      for (int i = 0; i < 96; ++i)
        for (int c = 0; c < 3; ++c)
          gradient->rgb.push_back(
              static_cast<float>(0.5 + 0.4 * std::sin(0.1 * i + 0.05 * j + c + (gradient == &sky.gradient_sun))));
  }
  return sky;
}

void dayTable(benchmark::State& state) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(state.range(2)));
  const model::Sky sky = exampleSky();
  const auto hours = base::evenHours(static_cast<int>(state.range(0)));
  std::size_t evaluations = 0;
  for (auto _ : state) {
    const auto table = table::bakeDayTable(sky, static_cast<int>(state.range(1)), hours, {});
    benchmark::DoNotOptimize(table.number.data());
    evaluations = table.evaluations;
  }
  const auto keys = static_cast<double>(hours.size());
  state.counters["us_per_key"] =
      benchmark::Counter(keys * 1e-6, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["evaluations_per_key"] = static_cast<double>(evaluations) / keys;
}
BENCHMARK(dayTable)
    ->ArgNames({"keys", "bands", "threads"})
    ->Args({96, 2, 1})
    ->Args({96, 3, 1})
    ->Args({96, 5, 1})
    ->Args({384, 3, 1})
    ->Args({1536, 3, 1})
    ->Args({1536, 3, 2})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// The sky's radiance alone, direction by direction: the least work of a cubemap.
void evaluations(benchmark::State& state) {
  const model::Sky sky = exampleSky();
  const model::SkyInstant instant(sky, 8.0);
  const int size = static_cast<int>(state.range(0));
  std::vector<det::Number3> direction;
  for (int row = 0; row < 6 * size; ++row)
    for (int column = 0; column < size; ++column)
      direction.push_back(cubemap::directionOfTexel(cubemap::Layout::vulkan_cube, size, column, row));
  const model::IndicatrixTable table(sky.luminance.d);
  for (auto _ : state) {
    det::Number3 sum(0.0);
    for (const auto& d : direction) sum += instant.dome(d, det::Number3(0.0), &table);
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(evaluations)->ArgName("size")->Arg(128)->UseRealTime()->Unit(benchmark::kMillisecond);

void cubemap(benchmark::State& state) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(state.range(1)));
  const model::Sky sky = exampleSky();
  const model::SkyInstant instant(sky, 8.0);
  for (auto _ : state) {
    const auto image =
        cubemap::renderDome(instant, det::Number3(0.0), cubemap::Layout::vulkan_cube, static_cast<int>(state.range(0)));
    benchmark::DoNotOptimize(image.rgb_half.data());
  }
}
BENCHMARK(cubemap)
    ->ArgNames({"size", "threads"})
    ->Args({128, 1})
    ->Args({512, 1})
    ->Args({512, 2})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

std::vector<float> picture(int size) {
  std::vector<float> rgb(18 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = static_cast<float>((i * 2654435761U >> 8) % 1000);
  return rgb;
}

std::array<sh::CubeFace, 6> facesOf(const std::vector<float>& rgb, int size) {
  std::array<sh::CubeFace, 6> faces;
  for (std::size_t f = 0; f < 6; ++f) {
    faces[f] = {rgb.data() + f * rgb.size() / 6, std::ptrdiff_t{3} * size, {}, {}, {}};
    faces[f].right[f / 2 == 0 ? 2 : 0] = 1.0;
    faces[f].down[f / 2 == 1 ? 2 : 1] = 1.0;
    faces[f].normal[static_cast<int>(f) / 2] = f % 2 == 0 ? 1.0 : -1.0;
  }
  return faces;
}

void project(benchmark::State& state) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(state.range(3)));
  const int size = static_cast<int>(state.range(0));
  const auto rgb = picture(size);
  const auto faces = facesOf(rgb, size);
  const auto rule = state.range(2) == 0 ? sh::TexelRule::half_texel : sh::TexelRule::edge_centres;
  for (auto _ : state)
    benchmark::DoNotOptimize(sh::projectCube(faces, size, rule, static_cast<int>(state.range(1))).data());
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(rgb.size() * sizeof(float)));
}
BENCHMARK(project)
    ->ArgNames({"size", "bands", "openexr", "threads"})
    ->Args({256, 3, 0, 1})
    ->Args({1024, 2, 0, 1})
    ->Args({1024, 3, 0, 1})
    ->Args({1024, 3, 0, 2})
    ->Args({1024, 3, 1, 1})
    ->Args({1024, 5, 0, 1})
    ->Args({2048, 3, 0, 1})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void projectLatlong(benchmark::State& state) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  const int height = static_cast<int>(state.range(0));
  const std::vector<float> rgb(6 * static_cast<std::size_t>(height) * static_cast<std::size_t>(height), 1.0F);
  for (auto _ : state)
    benchmark::DoNotOptimize(sh::projectLatlong(rgb.data(), 2 * height, height, sh::TexelRule::half_texel, 3).data());
}
BENCHMARK(projectLatlong)->ArgName("height")->Arg(1024)->UseRealTime()->Unit(benchmark::kMillisecond);

/// The least work of a projection: every texel's three floats are read once.
void readTexels(benchmark::State& state) {
  const auto rgb = picture(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    float sum[8] = {};
    for (std::size_t i = 0; i + 8 <= rgb.size(); i += 8)
      for (std::size_t k = 0; k < 8; ++k) sum[k] += rgb[i + k];
    benchmark::DoNotOptimize(sum);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(rgb.size() * sizeof(float)));
}
BENCHMARK(readTexels)->ArgName("size")->Arg(256)->Arg(1024)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
