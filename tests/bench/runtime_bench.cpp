// SPDX-License-Identifier: Apache-2.0
// What the runtime costs a frame, and what opening costs beside reading the same bytes.
#include <benchmark/benchmark.h>

#include <cstring>
#include <numeric>
#include <welkin/welkin.hpp>

#include "sky/bake/encode.h"

namespace {

/// A day of 288 keys and 8 cubemaps of 128: the default bake.
const std::vector<std::byte>& bakedSky(int bands) {
  static std::vector<std::byte> baked[6];
  auto& bytes = baked[bands];
  if (!bytes.empty()) return bytes;
  welkin::bake::SkyFile file;
  file.sky.sun.path.latitude_rad = 0.3;
  file.sky.moon = file.sky.sun;
  file.settings = "{}";
  for (int i = 0; i < 288; ++i) file.bake.key_time_h.push_back(i / 12.0);
  file.bake.cubemap_size = 128;
  std::vector<welkin::cubemap::Cubemap> cubemaps;
  for (int i = 0; i < 8; ++i) {
    file.bake.cubemap_time_h.push_back(3.0 * i);
    cubemaps.push_back(welkin::cubemap::renderCubemap(welkin::model::SkyInstant(file.sky, 3.0 * i),
                                                      welkin::det::Number3(0.0), 128, file.bake.cubemap_format));
  }
  bytes = welkin::bake::encodeSky(
      file, welkin::table::bakeDayTable(file.sky, bands, file.bake.key_time_h, [] { return true; }), cubemaps);
  return bytes;
}

void sample(benchmark::State& state) {
  const auto& bytes = bakedSky(static_cast<int>(state.range(0)));
  welkin::Sky sky;
  sky.open(bytes.data(), bytes.size());
  WelkinSkySample s{};
  double time_h = 0.0;
  for (auto _ : state) {
    time_h += 0.01;
    sky.sample(time_h, s);
    benchmark::DoNotOptimize(s);
  }
}
BENCHMARK(sample)->Arg(2)->Arg(3)->Arg(5);

void open(benchmark::State& state) {
  const auto& bytes = bakedSky(3);
  for (auto _ : state) {
    welkin::Sky sky;
    sky.open(bytes.data(), bytes.size());
    benchmark::DoNotOptimize(sky);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * bytes.size()));
}
BENCHMARK(open);

/// The physical limit of opening: every byte is read once.
void readBytes(benchmark::State& state) {
  const auto& bytes = bakedSky(3);
  for (auto _ : state) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i + 8 <= bytes.size(); i += 8) {
      std::uint64_t word;
      std::memcpy(&word, bytes.data() + i, 8);
      sum += word;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * bytes.size()));
}
BENCHMARK(readBytes);

}  // namespace

BENCHMARK_MAIN();
