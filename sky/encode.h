// SPDX-License-Identifier: Apache-2.0
// A baked sky as the bytes of a .welkin file.
#pragma once

#include <cstddef>
#include <vector>

#include "format/container.h"
#include "sky/certificate.h"
#include "sky/cubemap.h"
#include "sky/day_encoding.h"
#include "sky/sky_file.h"

namespace welkin::sky {

/// `cubemaps` are of the settings' times, in their order, all of one size and format. `certificate`: of these very
/// numbers, or null when nothing was measured.
std::vector<std::byte> encodeSky(const SkyFile& file, const DayTable& table, const std::vector<Cubemap>& cubemaps,
                                 Encoding encoding = Encoding::float32, const Certificate* certificate = nullptr);

/// A path as table LightPath, into a file that is being built.
flatbuffers::Offset<format::LightPath> encodePath(flatbuffers::FlatBufferBuilder& builder, const LightPath& path);

}  // namespace welkin::sky
