// SPDX-License-Identifier: Apache-2.0
#include "study/runtime_speed.h"

#include <fmt/format.h>
#include <welkin/welkin.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "sky/bake/encode.h"
#include "sky/base/error.h"
#include "sky/table/key_placement.h"

namespace welkin::study {
namespace {

constexpr int kCalls = 4000;
constexpr int kRounds = 5;

/// Nanoseconds of `call(i)`, i below kCalls.
template <typename Call>
double leastTime(const Call& call) {
  double least = 1e30;
  for (int round = 0; round < kRounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kCalls; ++i) call(i);
    const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
    least = std::min(least, elapsed.count() / kCalls);
  }
  return least;
}

void require(WelkinResult result, const std::string& name) {
  if (result != WELKIN_OK)
    throw base::Error(base::ExitStatus::internal, fmt::format("study: the runtime refuses the sky of {}", name));
}

}  // namespace

RuntimeSpeed measureRuntime(const bake::SkyFile& file, const StudyDay& day, const Candidate& candidate,
                            std::size_t keys) {
  const table::DayTable table = table::tableAt(day.values(), candidate.representation, evenKeys(day, keys));
  const auto bytes = bake::encodeSky(file, table, {});
  WelkinSky* opened = nullptr;
  WelkinMessage message{};
  require(welkin_sky_open_memory(bytes.data(), bytes.size(), &opened, &message), candidate.name + ": " + message.text);
  const std::unique_ptr<WelkinSky, void (*)(WelkinSky*)> owner(opened, welkin_sky_close);
  WelkinSkySample sample{};
  RuntimeSpeed speed;
  speed.file_bytes = bytes.size();
  speed.sample_ns = leastTime(
      [&](int i) { require(welkin_sky_sample(opened, format::kDay_h * i / kCalls, &sample), candidate.name); });
  require(welkin_sky_sample(opened, 12.0, &sample), candidate.name);
  std::vector<std::array<float, 3>> normals;
  for (std::size_t p = 0; p < day.grid().count(); ++p) {
    const det::Number3 n = day.grid().normal(p).inSunFrame();
    normals.push_back({static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
  }
  float irradiance[3] = {};
  speed.irradiance_ns = leastTime([&](int i) {
    require(welkin_sky_irradiance(opened, &sample, normals[static_cast<std::size_t>(i) % normals.size()].data(),
                                  irradiance),
            candidate.name);
  });
  return speed;
}

std::vector<std::size_t> evenKeys(const StudyDay& day, std::size_t count) {
  const auto& instants = day.fields().instant;
  std::vector<std::size_t> keys;
  for (std::size_t k = 0; k < count; ++k) {
    const double hour = format::kDay_h * static_cast<double>(k) / static_cast<double>(count);
    std::size_t i = 0;
    while (i + 1 < instants.size() && instants[i + 1].time_h <= hour) ++i;
    if (i + 1 < instants.size() && instants[i + 1].time_h - hour < hour - instants[i].time_h) ++i;
    if (keys.empty() || keys.back() < i) keys.push_back(i);
  }
  return keys;
}

}  // namespace welkin::study
