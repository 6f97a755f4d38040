// SPDX-License-Identifier: Apache-2.0
// Costs of probes in a frame, for the talk's 51 sectors of 70 probes: relighting beside reading the bytes that it
// reads, and look-ups.
#include <benchmark/benchmark.h>
#include <hwy/highway.h>
#include <welkin/volume.h>

#include <cstdlib>
#include <cstring>
#include <ctime>
#include <random>
#include <utility>
#include <vector>

#include "tests/runtime/random_level.h"

namespace welkin::tests {
namespace {

/// Memory of a level, so that the bytes can be put out of the caches.
class Memory {
 public:
  WelkinAllocator allocator() {
    WelkinAllocator out{};
    out.user = this;
    out.allocate = [](void* user, std::size_t size, std::size_t) {
      void* block = std::aligned_alloc(kLine, (size + kLine - 1) / kLine * kLine);
      static_cast<Memory*>(user)->block_.emplace_back(static_cast<const char*>(block), size);
      return block;
    };
    out.free = [](void*, void* block, std::size_t) { std::free(block); };
    return out;
  }
  /// As after a frame's other work: every byte comes from memory again.
  void evict() const {
    for (const auto& [block, size] : block_) evictBytes(block, size);
  }
  static void evictBytes([[maybe_unused]] const char* bytes, [[maybe_unused]] std::size_t size) {
#ifdef __x86_64__
    for (std::size_t at = 0; at < size; at += kLine) __builtin_ia32_clflush(bytes + at);
    __builtin_ia32_mfence();
#endif
  }

 private:
  static constexpr std::size_t kLine = 64;
  std::vector<std::pair<const char*, std::size_t>> block_;
};

Memory& talkMemory() {
  static Memory memory;
  return memory;
}

OpenedLevel& talkLevel() {
  static const RandomLevel baked(51, 70, 10, transfer::SunTransfer::directional, false);
  static const WelkinAllocator allocator = talkMemory().allocator();
  static OpenedLevel opened(baked, &allocator);
  return opened;
}

WelkinSkySample& sampleOfTurn(int turn) {
  static WelkinSkySample samples[2] = {talkLevel().sampleAt(9.0), talkLevel().sampleAt(9.001)};
  return samples[turn % 2];
}

/// Calls `evict`, if the caches are to be cold, and `work`, of which the thread's own time counts.
template <typename Evict, typename Work>
void timed(benchmark::State& state, bool is_cold, const Evict& evict, const Work& work) {
  const auto now_s = [] {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  };
  for (auto _ : state) {
    if (is_cold) evict();
    const double start_s = now_s();
    work();
    state.SetIterationTime(now_s() - start_s);
  }
}

/// Relights the level. At 9 h sun and moon are up, at 12 h the sun alone. `targets`: of Highway, 0 for the best.
void relightAll(benchmark::State& state, double hour, bool is_cold, std::int64_t targets) {
  OpenedLevel& opened = talkLevel();
  const WelkinSkySample samples[2] = {opened.sampleAt(hour), opened.sampleAt(hour + 0.001)};
  hwy::SetSupportedTargetsForTest(targets);
  int turn = 0;
  WelkinRelight result{};
  timed(
      state, is_cold, [] { talkMemory().evict(); },
      [&] {
        WelkinLevelLight light{};
        light.sample = &samples[turn++ % 2];
        light.sky = light.sun_bounce = light.local = 1.0F;
        welkin_level_set_light(opened.level, &light);
        welkin_level_relight(opened.level, UINT32_MAX, &result);
      });
  hwy::SetSupportedTargetsForTest(0);
  state.SetItemsProcessed(state.iterations() * result.relit);
}
#define WELKIN_RELIGHT(name, ...) \
  BENCHMARK_CAPTURE(relightAll, name, __VA_ARGS__)->Unit(benchmark::kMicrosecond)->UseManualTime()
WELKIN_RELIGHT(sunAndMoon, 9.0, false, 0);
WELKIN_RELIGHT(sun, 12.0, false, 0);
WELKIN_RELIGHT(sunAndMoonCold, 9.0, true, 0);
WELKIN_RELIGHT(sunCold, 12.0, true, 0);
#ifdef __x86_64__
WELKIN_RELIGHT(sunAndMoonAvx2, 9.0, false, HWY_AVX2);
WELKIN_RELIGHT(sunAvx2, 12.0, false, HWY_AVX2);
WELKIN_RELIGHT(sunAndMoonColdAvx2, 9.0, true, HWY_AVX2);
#endif
#undef WELKIN_RELIGHT

/// The limit: as many bytes as relighting reads and writes, copied.
void copyBytes(benchmark::State& state, bool is_cold) {
  constexpr std::size_t kRead = 3570 * 102, kWritten = 3570 * 48;
  std::vector<char> from(kRead, 1), to(kRead);
  const auto evict = [&] {
    Memory::evictBytes(from.data(), kRead);
    Memory::evictBytes(to.data(), kRead);
  };
  timed(state, is_cold, evict, [&] {
    std::memcpy(to.data(), from.data(), kRead);
    benchmark::DoNotOptimize(to.data());
    std::memset(to.data(), static_cast<int>(state.iterations()), kWritten);
    benchmark::ClobberMemory();
  });
}
BENCHMARK_CAPTURE(copyBytes, warm, false)->Unit(benchmark::kMicrosecond)->UseManualTime();
BENCHMARK_CAPTURE(copyBytes, cold, true)->Unit(benchmark::kMicrosecond)->UseManualTime();

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
