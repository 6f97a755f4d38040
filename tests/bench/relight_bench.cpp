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

WelkinVolume* usualVolume(WelkinVolumeFormat format) {
  WelkinVolumeSettings settings{};
  settings.format = format;
  WelkinVolume* volume = nullptr;
  welkin_volume_create(&settings, &volume);
  return volume;
}

void fillVolume(benchmark::State& state, WelkinVolumeFormat format) {
  OpenedLevel& opened = talkLevel();
  WelkinVolume* volume = usualVolume(format);
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
BENCHMARK_CAPTURE(fillVolume, words, WELKIN_VOLUME_DEVICE)->Unit(benchmark::kMicrosecond);

/// What a change of the light costs the processor: relighting and filling, or nothing of the two.
void changeLight(benchmark::State& state, WelkinVolumeFormat format) {
  OpenedLevel& opened = talkLevel();
  WelkinVolume* volume = usualVolume(format);
  WelkinVolumeUpdate update{};
  WelkinRelight relit{};
  const float camera[3] = {1600, 20, 32};
  int turn = 0;
  for (auto _ : state) {
    WelkinLevelLight light{};
    light.sample = &sampleOfTurn(turn++);
    light.sky = light.sun_bounce = light.local = 1.0F;
    welkin_level_set_light(opened.level, &light);
    if (format != WELKIN_VOLUME_DEVICE) welkin_level_relight(opened.level, UINT32_MAX, &relit);
    welkin_volume_update(volume, opened.level, light.sample, camera, UINT32_MAX, &update);
  }
  welkin_volume_destroy(volume);
}
BENCHMARK_CAPTURE(changeLight, halfs, WELKIN_VOLUME_RGBA16F)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(changeLight, words, WELKIN_VOLUME_DEVICE)->Unit(benchmark::kMicrosecond);

OpenedLevel& localLevel() {
  static const RandomLevel baked = [] {
    RandomLevel level(51, 70, 10, transfer::SunTransfer::directional, false);
    level.addLocal(70, 128);  // 64 transfers a probe on average, 72 KB a sector
    return level;
  }();
  static OpenedLevel opened(baked);
  return opened;
}

std::vector<WelkinPointLight> eightLamps() {
  std::vector<WelkinPointLight> lights(8);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    lights[i].position[0] = static_cast<float>(300 * i);
    lights[i].position[1] = 3.0F;
    lights[i].position[2] = 30.0F;
    lights[i].intensity[0] = 1.0F;
  }
  return lights;
}

/// Lights of 8 lamps of which `change` changes some before each call: their shares, and the local light of the sectors
/// that they reach.
template <typename Change>
void setLamps(benchmark::State& state, const Change& change) {
  std::vector<WelkinPointLight> lights = eightLamps();
  std::size_t tests = 0;
  const auto sees = [](void* user, const float*, const float*) {
    return ++*static_cast<std::size_t*>(user) != 0 ? 1 : 0;
  };
  WelkinLightsResult result{};
  welkin_level_set_lights(localLevel().level, 8, lights.data(), sees, &tests, nullptr);
  tests = 0;
  bool odd = false;
  for (auto _ : state) {
    odd = !odd;
    const auto count = static_cast<std::uint32_t>(change(lights, odd));
    welkin_level_set_lights(localLevel().level, count, lights.data(), sees, &tests, &result);
  }
  state.counters["sectors"] = result.sectors;
  state.counters["probes"] = result.probes;
  state.counters["tests"] = benchmark::Counter(static_cast<double>(tests), benchmark::Counter::kAvgIterations);
}

void sameLamps(benchmark::State& state) {
  setLamps(state, [](auto&, bool) { return 8; });
}
BENCHMARK(sameLamps)->Unit(benchmark::kMicrosecond);

void moveLamp(benchmark::State& state) {
  setLamps(state, [](auto& lights, bool odd) {
    lights[5].position[0] += odd ? 0.01F : -0.01F;
    return 8;
  });
}
BENCHMARK(moveLamp)->Unit(benchmark::kMicrosecond);

void addOrRemoveLamp(benchmark::State& state) {
  setLamps(state, [](auto&, bool odd) { return odd ? 7 : 8; });
}
BENCHMARK(addOrRemoveLamp)->Unit(benchmark::kMicrosecond);

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
