// SPDX-License-Identifier: Apache-2.0
// The part of the C interface that keeps the volume filled as light, sectors and camera change.
#include "probes/volume.h"

#include <algorithm>
#include <cmath>

#include "core/floats.h"
#include "shared.h"

namespace welkin::probes {
namespace {

/// Light that no place has more of: the largest number of the resident probes and of the open sky.
float largestOf(const WelkinLevel& level, const float* open) {
  float largest = *std::max_element(open, open + kColours);
  for (std::uint32_t i = 0; i < level.count; ++i) {
    const WelkinSector& s = *level.resident.get()[i];
    for (std::size_t n = 0; n < kColours * s.probes; ++n) largest = std::max(largest, s.light.get()[n]);
  }
  return largest;
}

/// About the most light of any place, where the device relights and the processor does not know it. Halfs have digits
/// for light that is 30,000 times as much, or a thousandth of it.
float aboutLargestOf(const WelkinLevel& level, const float* open) {
  float largest = *std::max_element(open, open + kColours);
  for (const auto& light : level.light.light_irradiance)
    for (const double e : light) largest = std::max(largest, core::toFloat(e));
  for (std::uint32_t i = 0; i < level.count; ++i) {
    const WelkinSector& s = *level.resident.get()[i];
    if (s.fixed.get() == nullptr) continue;
    const float *start = s.fixed.get(), *end = start + kColours * s.probes;
    largest = std::max(largest, core::toFloat(level.light.local * double{*std::max_element(start, end)}));
  }
  return largest;
}

/// The scale for light up to `largest`, near the present one. Steps of RGBA8 are an eighth of an octave, so that slow
/// light seldom changes it; it falls only by two of them. Halfs need one only where they would overflow or lose digits.
float scaleFor(float largest, WelkinVolumeFormat format, float present) {
  if (!(largest > 0.0F) || !std::isfinite(largest)) return present;
  if (format != WELKIN_VOLUME_RGBA8)
    return largest > 1e-3F * present && largest < 30000.0F * present ? present
                                                                     : std::exp2(std::ceil(std::log2(largest)));
  if (largest <= present && largest > 0.8F * present) return present;
  return std::exp2(std::ceil(8.0F * std::log2(largest)) / 8.0F);
}

/// The open sky's irradiance in the directions of the basis, from the bands 0 to 2 of a sample, times a factor:
/// [channel][direction].
void openLight(const WelkinSkySample& sample, double factor, float* out) {
  const f64::TransferBasis basis = f64::transferBasis();
  for (std::size_t b = 0; b < kDirections; ++b) {
    const f64::ShBasis at = f64::shBasis(basis.v[b]);
    for (std::size_t c = 0; c < kChannels; ++c) {
      double sum = 0.0;
      for (std::uint32_t k = 0; k < std::min(sample.coefficient_count, 9U); ++k)
        sum += double{sample.ambient_sh[k][c]} * f64::cosineLobe(k == 0 ? 0 : k < 4 ? 1 : 2) * at.v[k];
      out[c * kDirections + b] = static_cast<float>(std::max(sum * factor, 0.0));
    }
  }
}

/// Packs the light of the resident probes as texels of the volume, unless it is packed so.
void packLight(WelkinLevel& level, const WelkinVolume& volume) {
  const PackedLight wanted{volume.version, volume.format, volume.scale};
  if (level.packed == wanted) return;
  level.packed = wanted;
  for (std::uint32_t i = 0; i < level.count; ++i) {
    WelkinSector& s = *level.resident.get()[i];
    for (std::size_t p = 0; p < s.probes; ++p)
      s.packed.get()[p] = packTexel(s.light.get() + kColours * p, volume.format, volume.scale);
  }
}

void addBox(WelkinVolumeUpdate& update, const std::array<std::uint32_t, 3>& first,
            const std::array<std::uint32_t, 3>& size) {
  WelkinVolumeBox& box = update.box[update.box_count++];
  std::copy(first.begin(), first.end(), box.first);
  std::copy(size.begin(), size.end(), box.size);
  update.filled += size[0] * size[1] * size[2];
}

/// Adds the copy of the first slice to a run of slices that begins with it.
void addFirstSlice(WelkinVolume& volume, std::uint32_t from, WelkinVolumeUpdate& update) {
  if (from != 0) return;
  copyFirstSlice(volume);
  addBox(update, {0, 0, volume.count[2]}, {volume.count[0], volume.count[1], 1});
}

void fillAll(WelkinVolume& volume, const WelkinLevel& level, WelkinVolumeUpdate& update) {
  Cells high = volume.first;
  for (std::size_t a = 0; a < 3; ++a) high[a] += volume.count[a];
  fillCells(volume, level, volume.first, high);
  std::fill_n(volume.slice.get(), volume.count[2], volume.version);
  copyFirstSlice(volume);
  addBox(update, {0, 0, 0}, {volume.count[0], volume.count[1], volume.count[2] + 1});
}

/// Fills the slab of cells that the volume enters along an axis. `first` is the new corner.
void enter(WelkinVolume& volume, const WelkinLevel& level, const Cells& first, std::size_t axis,
           WelkinVolumeUpdate& update) {
  const std::int64_t n = volume.count[axis];
  const std::int64_t moved = first[axis] - volume.first[axis];
  Cells low = first, high = first;
  for (std::size_t a = 0; a < 3; ++a) high[a] += volume.count[a];
  low[axis] = moved > 0 ? volume.first[axis] + n : first[axis];
  high[axis] = moved > 0 ? first[axis] + n : volume.first[axis];
  fillCells(volume, level, low, high);
  const auto start = static_cast<std::uint32_t>(((low[axis] % n) + n) % n);
  const auto width = static_cast<std::uint32_t>(high[axis] - low[axis]);
  const std::uint32_t until_end = std::min(width, volume.count[axis] - start);
  for (const auto& [from, size] : {std::pair(start, until_end), std::pair(0U, width - until_end)}) {
    if (size == 0) continue;
    std::array<std::uint32_t, 3> corner{}, edges = volume.count;
    edges[2] += 1;
    corner[axis] = from;
    edges[axis] = size;
    addBox(update, corner, edges);
    if (axis == 2) {
      std::fill_n(volume.slice.get() + from, size, volume.version);
      addFirstSlice(volume, from, update);
    }
  }
  copyFirstSlice(volume);
}

/// Fills slices along z that show earlier light: at most two runs of neighbours.
void refresh(WelkinVolume& volume, const WelkinLevel& level, std::uint32_t max_texels, WelkinVolumeUpdate& update) {
  const std::uint32_t texels = volume.count[0] * volume.count[1], slices = volume.count[2];
  std::uint32_t left = std::max(1U, max_texels / texels);
  std::uint32_t runs = 0, looked = 0;
  while (left > 0 && looked < slices && runs < 2) {
    std::uint32_t size = 0;
    const std::uint32_t from = volume.next;
    while (size < left && from + size < slices && looked < slices &&
           volume.slice.get()[from + size] != volume.version) {
      ++size;
      ++looked;
    }
    if (size == 0) {
      ++looked;
      volume.next = (from + 1) % slices;
      continue;
    }
    for (std::uint32_t s = from; s < from + size; ++s) {
      const std::int64_t n = slices;
      Cells low = volume.first, high = volume.first;
      low[2] += ((s - volume.first[2]) % n + n) % n;  // the cell of the window whose remainder is s
      high[0] += volume.count[0];
      high[1] += volume.count[1];
      high[2] = low[2] + 1;
      fillCells(volume, level, low, high);
      volume.slice.get()[s] = volume.version;
    }
    addBox(update, {0, 0, from}, {volume.count[0], volume.count[1], size});
    addFirstSlice(volume, from, update);
    left -= size;
    ++runs;
    volume.next = (from + size) % slices;
  }
  for (std::uint32_t s = 0; s < slices; ++s) update.remaining += volume.slice.get()[s] != volume.version ? texels : 0;
}

/// Follows the cells along walls, and fills bricks that are new or show earlier light. `anew`: all of them, as another
/// scale needs.
void updateCuts(WelkinVolume& volume, const WelkinLevel& level, std::uint32_t max_texels, bool anew,
                WelkinVolumeUpdate& out) {
  constexpr std::uint32_t kWord = sizeof(std::uint32_t);
  const CutChange change =
      volume.cuts.update(level, volume.first[0], volume.first[2], volume.version, anew ? UINT32_MAX : max_texels);
  out.cut_first = kWord * change.first_word;
  out.cut_bytes = kWord * change.words;
  out.bricks = volume.cuts.bricks();
  out.cuts_left = volume.cuts.left();
  out.remaining += volume.cuts.remaining();
  if (change.layers == 0) return;
  fillBricks(volume, change.first_layer, change.layers);
  addBox(out, {0, 0, volume.count[2] + 1 + 3 * change.first_layer},
         {volume.count[0], volume.count[1], 3 * change.layers});
}

void update(WelkinVolume& volume, WelkinLevel& level, const WelkinSkySample& sample, const Cells& first,
            std::uint32_t max_texels, WelkinVolumeUpdate& out) {
  const bool on_device = volume.format == WELKIN_VOLUME_DEVICE;
  const std::uint64_t version = on_device ? level.residents + 1 : level.changes + level.instant;
  const bool changed = !volume.filled || version != volume.version;
  // The words of sectors that have gone must not outlive them, as another sector takes their slot.
  bool whole = !volume.filled || (on_device && changed);
  if (changed || on_device) {
    float* open = volume.open_light.data();
    openLight(sample, level.light.sky_factor, open);
    const float largest = on_device ? aboutLargestOf(level, open) : largestOf(level, open);
    const float scale = scaleFor(largest, volume.format, volume.scale);
    whole = whole || (!on_device && scale != volume.scale);
    volume.scale = scale;
    volume.open = on_device ? TexelWords{kOpenTexel} : packTexel(open, volume.format, scale);
    volume.version = version;
  }
  volume.level = &level;
  if (!on_device) packLight(level, volume);
  for (std::size_t a = 0; a < 3; ++a) whole = whole || std::abs(first[a] - volume.first[a]) >= volume.count[a];
  if (whole) {
    volume.first = first;
    volume.filled = true;
    fillAll(volume, level, out);
    return updateCuts(volume, level, max_texels, true, out);
  }
  for (std::size_t a = 0; a < 3; ++a) {
    if (first[a] == volume.first[a]) continue;
    enter(volume, level, first, a, out);
  }
  volume.first = first;
  refresh(volume, level, max_texels, out);
  updateCuts(volume, level, max_texels, false, out);
}

}  // namespace
}  // namespace welkin::probes

using namespace welkin::core;
using namespace welkin::probes;

WelkinResult welkin_volume_update(WelkinVolume* volume, WelkinLevel* level, const WelkinSkySample* sample,
                                  const float camera[3], uint32_t max_texels, WelkinVolumeUpdate* update) {
  if (const auto r = nonNull(__func__, {{"volume", volume}, {"level", level}, {"camera", camera}})) return r;
  if (const auto r = sized(__func__, "update", update)) return r;
  if (const auto r = checkSample(__func__, "sample", sample)) return r;
  Cells first;
  for (std::size_t a = 0; a < 3; ++a) {
    if (!(std::abs(camera[a]) <= 1e7F))
      return refuse(__func__, "camera[%zu] is %g, must be within 1e7 m", a, double{camera[a]});
    first[a] = static_cast<std::int64_t>(std::floor(double{camera[a]} / volume->texel_m[a])) - volume->count[a] / 2;
  }
  for (std::size_t a = 0; a < 3; ++a) volume->camera[a] = double{camera[a]};
  WelkinVolumeUpdate out{};
  welkin::probes::update(*volume, *level, take(*sample), first, max_texels, out);
  volume->far_map.update(*level, volume->camera[0], volume->camera[2], out);
  give(out, update);
  return WELKIN_OK;
}
