// SPDX-License-Identifier: Apache-2.0
// Encodes a baked sky as the bytes of a .welkin file.
#pragma once

#include <cstddef>
#include <vector>

#include "format/container.h"
#include "sky/bake/sky_file.h"
#include "sky/cubemap/cubemap.h"
#include "sky/table/certificate.h"
#include "sky/table/day_encoding.h"

namespace welkin::bake {

/// `cubemaps` follow the order of the settings' times and share one size and format. `certificate` belongs to these
/// very numbers; null when nothing was measured.
std::vector<std::byte> encodeSky(const SkyFile& file, const table::DayTable& table,
                                 const std::vector<cubemap::Cubemap>& cubemaps,
                                 table::Encoding encoding = table::Encoding::float32,
                                 const table::Certificate* certificate = nullptr);

/// Adds a path, as table LightPath, to a file that is being built.
flatbuffers::Offset<format::LightPath> encodePath(flatbuffers::FlatBufferBuilder& builder,
                                                  const model::LightPath& path);

}  // namespace welkin::bake
