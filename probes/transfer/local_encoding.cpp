// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/local_encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "probes/transfer/fixed_point.h"
#include "sky/base/error.h"

namespace welkin::transfer {
namespace {

constexpr std::size_t kNumbers = 4 * 3;  ///< numbers per transfer
constexpr double kLargestLocal = 3e38;
constexpr double kFarthest_m = 1e7;
constexpr std::size_t kMostLights = std::size_t{1} << 16;

[[noreturn]] void refuseNumber(const std::string& what) {
  throw base::Error(base::ExitStatus::content, "local transfer: " + what);
}

std::array<double, kNumbers> numbersOf(const LocalTransfer& t) {
  std::array<double, kNumbers> number;
  for (std::size_t k = 0; k < 4; ++k)
    for (int c = 0; c < 3; ++c) number[k * 3 + static_cast<std::size_t>(c)] = t.radiance[k][c];
  return number;
}

double largestOf(const LocalTransfer& t) {
  double largest = 0.0;
  for (const double x : numbersOf(t)) largest = std::max(largest, std::abs(x));
  return largest;
}

void check(const LocalTransfer& t, std::size_t probe, std::size_t lights) {
  if (t.light >= lights) refuseNumber(fmt::format("probe {}: light {}; allowed: less than {}", probe, t.light, lights));
  const auto number = numbersOf(t);
  for (std::size_t i = 0; i < kNumbers; ++i)
    if (!(number[i] >= (i < 3 ? 0.0 : -kLargestLocal) && number[i] <= kLargestLocal))
      refuseNumber(fmt::format("probe {}: light {}: coefficient {}: {}; allowed: {} to {}", probe, t.light, i / 3,
                               number[i], i < 3 ? 0.0 : -kLargestLocal, kLargestLocal));
}

static_assert(kLocalTransferBytes == 2 * sizeof(std::uint16_t) + kNumbers * sizeof(std::int8_t));
static_assert(kVirtualLightBytes == 3 * sizeof(float));

struct Entry {
  double influence;
  std::size_t probe;
  LocalTransfer transfer;
};

/// The share, clamped to 1: sums of the same numbers in two orders may exceed 1 by rounding.
double shareOf(double part, double whole) {
  return std::min(part / whole, 1.0);
}

}  // namespace

SectorLocal thinnedLocal(const std::vector<Number3>& lights, const std::vector<LocalProbe>& probes,
                         std::size_t most_bytes, LocalThinning& thinning) {
  std::vector<Entry> entry;
  std::vector<double> whole(probes.size(), 0.0);
  for (std::size_t i = 0; i < probes.size(); ++i)
    for (const LocalTransfer& t : probes[i].transfer) {
      check(t, i, lights.size());
      entry.push_back({t.influence(), i, t});
      whole[i] += t.influence();
    }
  std::stable_sort(entry.begin(), entry.end(),
                   [](const Entry& a, const Entry& b) { return a.influence > b.influence; });
  std::vector<bool> used(lights.size(), false);
  std::vector<std::vector<LocalTransfer>> kept(probes.size());
  std::vector<double> lost(probes.size(), 0.0);
  std::size_t bytes = probes.size() * sizeof(std::uint8_t);
  thinning = {};
  for (const Entry& e : entry) {
    const std::size_t more = kLocalTransferBytes + (used[e.transfer.light] ? 0 : kVirtualLightBytes);
    // Once a transfer does not fit, no transfer of less influence takes its place.
    if (thinning.dropped > 0 || bytes + more > most_bytes) {
      ++thinning.dropped;
      lost[e.probe] += e.influence;
      continue;
    }
    ++thinning.kept;
    bytes += more;
    used[e.transfer.light] = true;
    kept[e.probe].push_back(e.transfer);
  }
  double all_lost = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    all_lost += lost[i];
    all += whole[i];
    if (lost[i] > 0.0) thinning.worst_probe = std::max(thinning.worst_probe, shareOf(lost[i], whole[i]));
  }
  if (all_lost > 0.0) thinning.lost = shareOf(all_lost, all);

  SectorLocal local;
  std::vector<std::uint32_t> index(lights.size(), 0);
  for (std::size_t l = 0; l < lights.size(); ++l) {
    index[l] = static_cast<std::uint32_t>(local.light.size());
    if (used[l]) local.light.push_back(lights[l]);
  }
  for (auto& transfers : kept) {
    for (LocalTransfer& t : transfers) t.light = index[t.light];
    std::sort(transfers.begin(), transfers.end(),
              [](const LocalTransfer& a, const LocalTransfer& b) { return a.light < b.light; });
  }
  local.probe = std::move(kept);
  return local;
}

std::size_t EncodedLocal::bytes() const {
  return position.size() * sizeof(float) + count.size() + light.size() * sizeof(std::uint16_t) +
         scale.size() * sizeof(std::uint16_t) + radiance.size() * sizeof(std::int8_t);
}

EncodedLocal encodeLocal(const SectorLocal& local) {
  if (local.light.size() > kMostLights)
    refuseNumber(fmt::format("{} lights; allowed: at most {}", local.light.size(), kMostLights));
  EncodedLocal encoded;
  for (const Number3& p : local.light)
    for (int c = 0; c < 3; ++c) {
      if (!(std::abs(p[c]) <= kFarthest_m))
        refuseNumber(fmt::format("a light's coordinate: {}; allowed: {} to {}", p[c], -kFarthest_m, kFarthest_m));
      encoded.position.push_back(static_cast<float>(p[c]));
    }
  for (std::size_t i = 0; i < local.probe.size(); ++i) {
    const auto& transfers = local.probe[i];
    if (transfers.size() > kMostLocalLights)
      refuseNumber(fmt::format("probe {}: {} lights; allowed: at most {}", i, transfers.size(), kMostLocalLights));
    encoded.count.push_back(static_cast<std::uint8_t>(transfers.size()));
    for (const LocalTransfer& t : transfers) {
      check(t, i, local.light.size());
      encoded.light.push_back(static_cast<std::uint16_t>(t.light));
      encoded.scale.push_back(scaleFor(largestOf(t)));
      for (const double x : numbersOf(t))
        encoded.radiance.push_back(toFixed<std::int8_t>(x, scaleOf(encoded.scale.back())));
    }
  }
  return encoded;
}

SectorLocal decodedLocal(const EncodedLocal& e) {
  std::size_t transfers = 0;
  for (const std::uint8_t count : e.count) transfers += count;
  const std::size_t lights = e.position.size() / 3;
  const bool counts = std::all_of(e.count.begin(), e.count.end(), [](std::uint8_t n) { return n <= kMostLocalLights; });
  const bool fits = counts && e.position.size() == 3 * lights && e.light.size() == transfers &&
                    e.scale.size() == transfers && e.radiance.size() == kNumbers * transfers;
  if (!fits || std::any_of(e.light.begin(), e.light.end(), [&](std::uint16_t l) { return l >= lights; }))
    refuseNumber("its arrays do not fit each other");
  SectorLocal local;
  for (std::size_t l = 0; l < lights; ++l)
    local.light.emplace_back(double{e.position[3 * l]}, double{e.position[3 * l + 1]}, double{e.position[3 * l + 2]});
  std::size_t next = 0;
  for (const std::uint8_t count : e.count) {
    auto& probe = local.probe.emplace_back();
    for (std::size_t i = 0; i < count; ++i, ++next) {
      LocalTransfer& t = probe.emplace_back();
      t.light = e.light[next];
      for (std::size_t k = 0; k < 4; ++k)
        for (int c = 0; c < 3; ++c)
          t.radiance[k][c] =
              fromFixed(e.radiance[kNumbers * next + k * 3 + static_cast<std::size_t>(c)], scaleOf(e.scale[next]));
    }
  }
  return local;
}

LocalEncodingError encodingError(const SectorLocal& local, const SectorLocal& decoded) {
  LocalEncodingError error;
  for (std::size_t l = 0; l < local.light.size(); ++l)
    for (int c = 0; c < 3; ++c)
      error.position_m = std::max(error.position_m, std::abs(local.light[l][c] - decoded.light[l][c]));
  for (std::size_t i = 0; i < local.probe.size(); ++i)
    for (std::size_t j = 0; j < local.probe[i].size(); ++j) {
      const double largest = largestOf(local.probe[i][j]);
      const auto a = numbersOf(local.probe[i][j]);
      const auto b = numbersOf(decoded.probe[i][j]);
      for (std::size_t n = 0; n < kNumbers; ++n)
        if (largest > 0.0) error.radiance = std::max(error.radiance, std::abs(a[n] - b[n]) / largest);
    }
  return error;
}

}  // namespace welkin::transfer
