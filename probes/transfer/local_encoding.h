// SPDX-License-Identifier: Apache-2.0
// Encoding of a sector's local transfer, in at most 210 KB.
//
// Each transfer takes 16 bytes, probe by probe, with lights ascending:
//
//     light         u16        index of its position
//     scale         u16        the upper 16 bits of a float32 >= 0
//     radiance     12 x i8     in scale / 127: [coefficient][channel]
//
// Each probe takes one byte:
//
//     count         u8         number of its transfers, 0..128
//
// Each virtual light that some probe keeps takes 12 bytes, also one in a neighbouring sector:
//
//     position      3 x f32    metres; in a sector's file, x and z count from the sector's corner
//
// If that is too much, the transfers of least influence in the whole sector are dropped.
#pragma once

#include <cstdint>
#include <vector>

#include "probes/transfer/local_transfer.h"

namespace welkin::transfer {

using f64::Number3;

inline constexpr std::size_t kMostLocalBytes = 210 * 1024;  ///< limit for one sector
inline constexpr std::size_t kLocalTransferBytes = 16;
inline constexpr std::size_t kVirtualLightBytes = 12;

/// Local transfer of a sector. LocalTransfer::light is an index into `light`.
struct SectorLocal {
  std::vector<Number3> light;  ///< positions, metres
  std::vector<std::vector<LocalTransfer>> probe;
};

/// Result of thinning.
struct LocalThinning {
  std::size_t kept = 0;
  std::size_t dropped = 0;
  double lost = 0.0;         ///< dropped share of the sector's influence, in [0, 1]
  double worst_probe = 0.0;  ///< the same for the probe that lost the largest share
};

/// Keeps the most influential transfers that fit into `most_bytes` of the file, and their lights in the order of
/// `lights`. Among equal ones the first probe wins, then the first light. Throws Error(content) if a light's index is
/// out of range or a number is not finite.
SectorLocal thinnedLocal(const std::vector<Number3>& lights, const std::vector<LocalProbe>& probes,
                         std::size_t most_bytes, LocalThinning& thinning);

/// Arrays as the file stores them, in the order above.
struct EncodedLocal {
  std::vector<float> position;
  std::vector<std::uint8_t> count;
  std::vector<std::uint16_t> light;
  std::vector<std::uint16_t> scale;
  std::vector<std::int8_t> radiance;

  std::size_t bytes() const;  ///< size of all arrays
};

/// Encodes the transfer. Throws Error(content) if a number is not finite, a coefficient 0 is negative, a probe has more
/// than 128 transfers, or there are more than 65536 lights.
EncodedLocal encodeLocal(const SectorLocal& local);

/// Decodes the transfer. Throws Error(content) if the sizes of the arrays do not match.
SectorLocal decodedLocal(const EncodedLocal& encoded);

/// The largest differences between local transfer and its decoded copy.
struct LocalEncodingError {
  double position_m = 0.0;  ///< of one coordinate
  double radiance = 0.0;    ///< of a coefficient, relative to the largest of its transfer
};
LocalEncodingError encodingError(const SectorLocal& local, const SectorLocal& decoded);

}  // namespace welkin::transfer
