// SPDX-License-Identifier: Apache-2.0
// Costs of probes in a frame, for the talk's 51 sectors of 70 probes: relighting beside reading the bytes that it
// reads, and look-ups.
#include <benchmark/benchmark.h>
#include <welkin/volume.h>

#include <cstring>
#include <random>

#include "tests/runtime/random_level.h"

namespace welkin::tests {
namespace {

OpenedLevel& talkLevel() {
  static const RandomLevel baked(51, 70, 10, transfer::SunTransfer::directional, false);
  static OpenedLevel opened(baked);
  return opened;
}

WelkinSkySample& sampleOfTurn(int turn) {
  static WelkinSkySample samples[2] = {talkLevel().sampleAt(9.0), talkLevel().sampleAt(9.001)};
  return samples[turn % 2];
}

void relightAll(benchmark::State& state) {
  OpenedLevel& opened = talkLevel();
  int turn = 0;
  WelkinRelight result{};
  for (auto _ : state) {
    WelkinLevelLight light{};
    light.sample = &sampleOfTurn(turn++);
    light.sky = light.sun_bounce = light.local = 1.0F;
    welkin_level_set_light(opened.level, &light);
    welkin_level_relight(opened.level, UINT32_MAX, &result);
  }
  state.SetItemsProcessed(state.iterations() * result.relit);
}
BENCHMARK(relightAll)->Unit(benchmark::kMicrosecond);

/// The limit: as many bytes as relighting reads and writes, copied.
void copyBytes(benchmark::State& state) {
  constexpr std::size_t kRead = 3570 * 102, kWritten = 3570 * 48;
  std::vector<char> from(kRead, 1), to(kRead);
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), kRead);
    benchmark::DoNotOptimize(to.data());
    std::memset(to.data(), static_cast<int>(state.iterations()), kWritten);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(copyBytes)->Unit(benchmark::kMicrosecond);

void fillVolume(benchmark::State& state, WelkinVolumeFormat format) {
  OpenedLevel& opened = talkLevel();
  WelkinVolumeSettings settings{};
  settings.format = format;
  WelkinVolume* volume = nullptr;
  welkin_volume_create(&settings, &volume);
  WelkinVolumeUpdate update{};
  float camera[3] = {1600, 20, 32};
  for (auto _ : state) {
    camera[0] = 2400 - camera[0];  // 200 texels away
    welkin_volume_update(volume, opened.level, &sampleOfTurn(0), camera, UINT32_MAX, &update);
  }
  state.SetItemsProcessed(state.iterations() * update.filled);
  welkin_volume_destroy(volume);
}
BENCHMARK_CAPTURE(fillVolume, halfs, WELKIN_VOLUME_RGBA16F)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(fillVolume, bytes, WELKIN_VOLUME_RGBA8)->Unit(benchmark::kMicrosecond);

void query1000(benchmark::State& state) {
  OpenedLevel& opened = talkLevel();
  std::mt19937 random(1);
  const auto in = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
  std::vector<std::array<float, 3>> position, normal, irradiance(1000);
  for (int i = 0; i < 1000; ++i) {
    position.push_back({in(0, 2000), in(0, 40), in(2, 62)});
    normal.push_back({0, 1, 0});
  }
  using Rows = const float(*)[3];
  for (auto _ : state)
    welkin_level_irradiance(opened.level, 1000, reinterpret_cast<Rows>(position.data()),
                            reinterpret_cast<Rows>(normal.data()), reinterpret_cast<float(*)[3]>(irradiance.data()),
                            nullptr);
}
BENCHMARK(query1000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace welkin::tests
