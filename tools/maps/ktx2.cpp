// SPDX-License-Identifier: Apache-2.0
#include "maps/ktx2.h"

#include <bit>
#include <numeric>
#include <string>
#include <utility>

#include "sky/base/little_endian.h"

namespace welkin::maps {
namespace {

/// A sample of the Khronos data format: bits of a texel block that hold one quantity.
struct Sample {
  std::uint32_t offset, bits, channel, low, high;  // low and high stand for 0 (or -1) and 1
};

constexpr std::uint32_t kFloat = 0x80, kSigned = 0x40, kExponent = 0x20;  // qualifiers of a channel
constexpr std::uint32_t kAlpha = 15;
constexpr std::uint32_t kModelRgb = 1, kModelBc6h = 133;
constexpr std::uint32_t kRec709 = 1, kLinear = 1;

std::vector<Sample> samplesOf(Format format) {
  const std::uint32_t one = std::bit_cast<std::uint32_t>(1.0F);
  const std::uint32_t minus_one = std::bit_cast<std::uint32_t>(-1.0F);
  if (format == Format::bc6h) return {{0, 128, kFloat, 0, one}};
  std::vector<Sample> samples;
  if (format == Format::rgba16f)
    for (const std::uint32_t c : {0U, 1U, 2U, 3U})
      samples.push_back({16 * c, 16, (c == 3 ? kAlpha : c) | kFloat | kSigned, minus_one, one});
  else  // 8448 is the mantissa of 1 for the exponent 15, if a mantissa could have more than 9 bits
    for (const std::uint32_t c : {0U, 1U, 2U}) {
      samples.push_back({9 * c, 9, c, 0, 8448});
      samples.push_back({27, 5, c | kExponent, 15, 31});
    }
  return samples;
}

/// The data format descriptor: its size, then one basic block.
void appendDescriptor(base::LittleEndian& file, Format format) {
  const FormatFacts& facts = factsOf(format);
  const std::vector<Sample> samples = samplesOf(format);
  const auto block = static_cast<std::uint32_t>(24 + 16 * samples.size());
  const std::uint32_t model = format == Format::bc6h ? kModelBc6h : kModelRgb;
  const std::uint32_t last = facts.block_texels - 1;
  file.append32(
      {4 + block, 0, 2U | block << 16, model | kRec709 << 8 | kLinear << 16, last | last << 8, facts.block_bytes, 0});
  for (const Sample& s : samples) file.append32({s.offset | (s.bits - 1) << 16 | s.channel << 24, 0, s.low, s.high});
}

void appendKeyAndValue(base::LittleEndian& file, const std::string& key, const std::string& value) {
  file.append32({static_cast<std::uint32_t>(key.size() + value.size() + 2)});
  file.appendText(key + '\0' + value + '\0');
  file.align(4);
}

}  // namespace

std::vector<std::byte> encodeKtx2(const EncodedCube& cube) {
  constexpr std::size_t kHeader = 80, kIndexEntry = 24;
  const FormatFacts& facts = factsOf(cube.format);
  const std::size_t descriptor_start = kHeader + kIndexEntry * cube.levels.size();
  base::LittleEndian descriptor, metadata;
  appendDescriptor(descriptor, cube.format);
  appendKeyAndValue(metadata, "KTXorientation", "rd");  // rows go down in every face
  appendKeyAndValue(metadata, "KTXwriter", "Welkin");
  const std::size_t metadata_start = descriptor_start + descriptor.bytes.size();

  // The smallest mip comes first, so that a reader can show it while the others are loaded.
  const std::size_t alignment = std::lcm(std::size_t{facts.block_bytes}, std::size_t{4});
  std::vector<std::size_t> start(cube.levels.size());
  std::size_t end = metadata_start + metadata.bytes.size();
  for (std::size_t level = cube.levels.size(); level-- > 0;) {
    start[level] = (end + alignment - 1) / alignment * alignment;
    end = start[level] + cube.levels[level].size();
  }

  base::LittleEndian file;
  file.appendText("\xABKTX 20\xBB\r\n\x1A\n");
  const auto size = static_cast<std::uint32_t>(cube.size);
  file.append32({facts.vulkan, facts.scalar_bytes, size, size, 0, 0, 6, static_cast<std::uint32_t>(start.size()), 0});
  file.append32({static_cast<std::uint32_t>(descriptor_start), static_cast<std::uint32_t>(descriptor.bytes.size()),
                 static_cast<std::uint32_t>(metadata_start), static_cast<std::uint32_t>(metadata.bytes.size())});
  file.append64(0);  // no global data of a supercompression
  file.append64(0);
  for (std::size_t level = 0; level < start.size(); ++level) {
    file.append64(start[level]);
    file.append64(cube.levels[level].size());
    file.append64(cube.levels[level].size());
  }
  file.bytes.insert(file.bytes.end(), descriptor.bytes.begin(), descriptor.bytes.end());
  file.bytes.insert(file.bytes.end(), metadata.bytes.begin(), metadata.bytes.end());
  for (std::size_t level = start.size(); level-- > 0;) {
    file.align(alignment);
    file.bytes.insert(file.bytes.end(), cube.levels[level].begin(), cube.levels[level].end());
  }
  return std::move(file.bytes);
}

}  // namespace welkin::maps
