// SPDX-License-Identifier: Apache-2.0
// A baked sky as the bytes of a .welkin file.
#pragma once

#include <cstddef>
#include <vector>

#include "format/container.h"
#include "sky/bake/sky_file.h"
#include "sky/cubemap/cubemap.h"
#include "sky/table/certificate.h"
#include "sky/table/day_encoding.h"

namespace welkin::bake {

/// `cubemaps` are of the settings' times, in their order, all of one size and format. `certificate`: of these very
/// numbers, or null when nothing was measured.
std::vector<std::byte> encodeSky(const SkyFile& file, const table::DayTable& table,
                                 const std::vector<cubemap::Cubemap>& cubemaps,
                                 table::Encoding encoding = table::Encoding::float32,
                                 const table::Certificate* certificate = nullptr);

/// A path as table LightPath, into a file that is being built.
flatbuffers::Offset<format::LightPath> encodePath(flatbuffers::FlatBufferBuilder& builder,
                                                  const model::LightPath& path);

}  // namespace welkin::bake
