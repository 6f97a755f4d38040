// SPDX-License-Identifier: Apache-2.0
// The cost of the runtime a frame, and of opening a file beside reading the same bytes.
#include <benchmark/benchmark.h>

#include <cstring>
#include <numeric>
#include <welkin/welkin.hpp>

#include "sky/bake/encode.h"

namespace {

/// A day of 288 keys and 8 cubemaps of 128 texels a side: the default bake. With `modes`, 8 modes of arbitrary numbers
/// replace the sky's coefficients.
std::vector<std::byte> bakedSky(int bands, bool modes) {
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
  if (!modes)
    return welkin::bake::encodeSky(file, welkin::table::bakeDayTable(file.sky, bands, file.bake.key_time_h, {}),
                                   cubemaps);
  welkin::table::DayTable table;
  table.bands = bands;
  table.rows = 8;
  table.key_time_h = file.bake.key_time_h;
  table.number.assign(table.key_time_h.size() * table.numbersOfKey(), 0.5);
  constexpr std::size_t kCoefficients[] = {0, 1, 3, 6, 10, 15};
  constexpr std::uint16_t kHalf = 0x3800;
  table.modes = {8, 9, 9, std::vector<std::uint16_t>(9 * 9 * 8, kHalf),
                 std::vector<float>(8 * kCoefficients[bands], 0.125F)};
  return welkin::bake::encodeSky(file, table, cubemaps);
}

const std::vector<std::byte>& skyOfBands(int bands) {
  static std::vector<std::byte> baked[6];
  if (baked[bands].empty()) baked[bands] = bakedSky(bands, false);
  return baked[bands];
}

void sampleOf(benchmark::State& state, const std::vector<std::byte>& bytes) {
  welkin::Sky sky;
  if (const welkin::Status status = sky.open(bytes.data(), bytes.size()); !status)
    return state.SkipWithError(status.message.c_str());
  WelkinSkySample s{};
  double time_h = 0.0;
  for (auto _ : state) {
    time_h += 0.01;
    sky.sample(time_h, s);
    benchmark::DoNotOptimize(s);
  }
}
void sample(benchmark::State& state) {
  sampleOf(state, skyOfBands(static_cast<int>(state.range(0))));
}
BENCHMARK(sample)->Arg(2)->Arg(3)->Arg(5);

void sampleModes(benchmark::State& state) {
  static const std::vector<std::byte> bytes = bakedSky(3, true);
  sampleOf(state, bytes);
}
BENCHMARK(sampleModes);

void open(benchmark::State& state) {
  const auto& bytes = skyOfBands(3);
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
  const auto& bytes = skyOfBands(3);
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
