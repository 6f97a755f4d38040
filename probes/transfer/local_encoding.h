// SPDX-License-Identifier: Apache-2.0
// The local transfer of a sector in at most 210 KB. 16 bytes a transfer, probe by probe, lights ascending:
//
//     light         u16        index of its position
//     scale         u16        the first 16 bits of a float32 >= 0
//     radiance     12 x i8     in scale / 127: [coefficient][channel]
//
// a byte a probe:
//
//     count         u8         its transfers, 0..128
//
// and 12 bytes for each virtual light that some probe keeps, those of neighbouring sectors too:
//
//     position      3 x f32    metres, world
//
// Where that is too much, the transfers of least influence in the whole sector go.
#pragma once

#include <cstdint>
#include <vector>

#include "probes/transfer/local_transfer.h"

namespace welkin::transfer {

using f64::Number3;

inline constexpr std::size_t kMostLocalBytes = 210 * 1024;  ///< of a sector
inline constexpr std::size_t kLocalTransferBytes = 16;
inline constexpr std::size_t kVirtualLightBytes = 12;

/// Local transfer of a sector; LocalTransfer::light is of `light`.
struct SectorLocal {
  std::vector<Number3> light;  ///< positions, metres
  std::vector<std::vector<LocalTransfer>> probe;
};

/// What thinning took.
struct LocalThinning {
  std::size_t kept = 0;
  std::size_t dropped = 0;
  double lost = 0.0;         ///< share of the sector's influence that was dropped, in [0, 1]
  double worst_probe = 0.0;  ///< of the probe that lost the largest share
};

/// The most influential transfers of the sector that fit `most_bytes` in file, and their lights, in the order of
/// `lights`. Of equal ones the first probe's, then the first light's. Throws Error(content) for a light that is not
/// there and numbers that are not finite.
SectorLocal thinnedLocal(const std::vector<Number3>& lights, const std::vector<LocalProbe>& probes,
                         std::size_t most_bytes, LocalThinning& thinning);

/// Arrays as a file holds them, in the order above.
struct EncodedLocal {
  std::vector<float> position;
  std::vector<std::uint8_t> count;
  std::vector<std::uint16_t> light;
  std::vector<std::uint16_t> scale;
  std::vector<std::int8_t> radiance;

  std::size_t bytes() const;  ///< of all arrays
};

/// Throws Error(content) for numbers that are not finite, a negative coefficient 0, more than 128 transfers a probe and
/// more than 65536 lights.
EncodedLocal encodeLocal(const SectorLocal& local);

/// Throws Error(content) where arrays do not fit each other.
SectorLocal decodedLocal(const EncodedLocal& encoded);

/// The worst difference between local transfer and what became of it.
struct LocalEncodingError {
  double position_m = 0.0;  ///< of a component
  double radiance = 0.0;    ///< of a coefficient, over its transfer's largest
};
LocalEncodingError encodingError(const SectorLocal& local, const SectorLocal& decoded);

}  // namespace welkin::transfer
