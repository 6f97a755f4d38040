// SPDX-License-Identifier: Apache-2.0
// The part of the C interface that makes a volume and gives its texels.
#include <welkin/volume.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "probes/volume.h"

using namespace welkin::core;
using namespace welkin::probes;

WelkinResult welkin_volume_create(const WelkinVolumeSettings* settings, WelkinVolume** volume) {
  if (volume != nullptr) *volume = nullptr;
  if (const auto r = nonNull(__func__, {{"volume", volume}})) return r;
  if (const auto r = sized(__func__, "settings", settings)) return r;
  const WelkinVolumeSettings s = take(*settings);
  if (s.format != WELKIN_VOLUME_RGBA16F && s.format != WELKIN_VOLUME_RGBA8 && s.format != WELKIN_VOLUME_DEVICE)
    return refuse(__func__, "settings->format is %d, must be one of WelkinVolumeFormat", static_cast<int>(s.format));
  WelkinVolume made;
  constexpr std::uint32_t kUsual[3] = {96, 16, 96};
  for (std::size_t a = 0; a < 3; ++a) {
    made.count[a] = s.texels[a] == 0 ? kUsual[a] : s.texels[a];
    if (made.count[a] < 2 || made.count[a] > 512)
      return refuse(__func__, "settings->texels[%zu] is %u, must be 0 or 2 to 512", a, s.texels[a]);
  }
  const float height = s.texel_height_m == 0.0F ? 4.0F : s.texel_height_m;
  if (!(height >= 0.5F && height <= 1e4F))
    return refuse(__func__, "settings->texel_height_m is %g, must be 0 or 0.5 to 10000", double{s.texel_height_m});
  constexpr std::uint32_t kUsualBricks = 4096, kMostBricks = 32760;
  if (s.bricks > kMostBricks && s.bricks != WELKIN_VOLUME_NO_BRICKS)
    return refuse(__func__, "settings->bricks is %u, must be 0 to %u or WELKIN_VOLUME_NO_BRICKS", s.bricks,
                  kMostBricks);
  constexpr std::uint32_t kUsualFar = 256;
  const std::uint32_t far_texels = s.far_texels == 0 ? kUsualFar : s.far_texels;
  if (far_texels < 2 * kTileEdge || far_texels > FarMap::kMostTiles * kTileEdge || far_texels % kTileEdge != 0)
    return refuse(__func__, "settings->far_texels is %u, must be 0 or a multiple of 16 in 32 to 1024", s.far_texels);
  const float fade = s.far_fade_m == 0.0F ? 16.0F : s.far_fade_m;
  if (!(fade >= 1.0F && fade <= 1e4F))
    return refuse(__func__, "settings->far_fade_m is %g, must be 0 or 1 to 10000", double{s.far_fade_m});
  if (s.allocator != nullptr) {
    if (const auto r = sized(__func__, "settings->allocator", s.allocator)) return r;
    if (const auto r = nonNull(__func__, {{"settings->allocator->allocate", asPointer(s.allocator->allocate)},
                                          {"settings->allocator->free", asPointer(s.allocator->free)}}))
      return r;
    made.memory = HostMemory(take(*s.allocator));
  }
  made.format = s.format;
  made.texel_m = {welkin::format::kCellWidth_m, double{height}, welkin::format::kCellWidth_m};
  made.texel_bytes = s.format == WELKIN_VOLUME_RGBA16F ? 8 : 4;
  if (s.format == WELKIN_VOLUME_DEVICE) {
    made.channels = 1;
    // A row of texels touches one sector more than it fills, and bricks see one more on either side.
    for (std::size_t a = 0; a < 2; ++a) made.slots[a] = made.count[2 * a] / welkin::format::kCellsAcross + 4;
  }
  const std::uint32_t bricks = s.bricks == WELKIN_VOLUME_NO_BRICKS ? 0 : s.bricks == 0 ? kUsualBricks : s.bricks;
  bool room = made.slice.allocate(made.memory, made.count[2]) &&
              made.cuts.allocate(made.memory, made.count, double{height}, bricks) &&
              made.far_map.allocate(made.memory, far_texels / kTileEdge, double{fade});
  made.depth = made.count[2] + 1 + 3 * made.cuts.layers();
  const std::size_t texels = std::size_t{made.count[0]} * made.count[1] * made.depth;
  for (std::size_t c = 0; c < made.channels; ++c)
    room = room && made.texels[c].allocate(made.memory, texels * made.texel_bytes);
  void* place = room ? made.memory.allocate(sizeof(WelkinVolume), alignof(WelkinVolume)) : nullptr;
  if (place == nullptr) return WELKIN_ERROR_MEMORY;
  for (std::size_t c = 0; c < made.channels; ++c)
    std::fill_n(made.texels[c].get(), texels * made.texel_bytes, std::byte{0});
  std::fill_n(made.slice.get(), made.count[2], std::uint64_t{0});
  *volume = new (place) WelkinVolume(std::move(made));
  return WELKIN_OK;
}

void welkin_volume_destroy(WelkinVolume* volume) {
  if (volume == nullptr) return;
  const HostMemory memory = volume->memory;
  volume->~WelkinVolume();
  memory.free(volume, sizeof(WelkinVolume));
}

WelkinResult welkin_volume_texels(const WelkinVolume* volume, uint32_t channel, const void** texels, size_t* bytes) {
  if (const auto r = nonNull(__func__, {{"volume", volume}, {"texels", texels}, {"bytes", bytes}})) return r;
  if (channel > 2) return refuse(__func__, "channel is %u, must be 0 to 2", channel);
  if (volume->format == WELKIN_VOLUME_DEVICE)
    return refuse(__func__, "the volume's format is WELKIN_VOLUME_DEVICE, so only the device has its texels");
  *texels = volume->texels[channel].get();
  *bytes = std::size_t{volume->count[0]} * volume->count[1] * volume->depth * volume->texel_bytes;
  return WELKIN_OK;
}

WelkinResult welkin_volume_cuts(const WelkinVolume* volume, const void** words, size_t* bytes) {
  if (const auto r = nonNull(__func__, {{"volume", volume}, {"words", words}, {"bytes", bytes}})) return r;
  *words = volume->cuts.words().data();
  *bytes = volume->cuts.words().size_bytes();
  return WELKIN_OK;
}

WelkinResult welkin_volume_extent(const WelkinVolume* volume, uint32_t extent[3]) {
  if (const auto r = nonNull(__func__, {{"volume", volume}, {"extent", extent}})) return r;
  extent[0] = volume->count[0];
  extent[1] = volume->count[1];
  extent[2] = volume->depth;
  return WELKIN_OK;
}
