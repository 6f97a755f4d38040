// SPDX-License-Identifier: Apache-2.0
// The contact factors of a baked level as files: DIR/contact.bin, a record of 16 bytes a vertex, and DIR/contact.json,
// which tells the record numbers of each placed piece. A build step takes the bytes into its own vertex buffers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "probes/contact/contact_check.h"
#include "sky/base/hash.h"

namespace welkin::contact {

/// A vertex of contact.bin, little-endian. Importers that order vertices anew find theirs by place and normal.
struct ContactRecord {
  float position[3];      ///< metres, world
  std::int8_t normal[3];  ///< unit, world, times 127
  std::uint8_t factor;    ///< fitContact's byte
};
static_assert(sizeof(ContactRecord) == 16);

/// Writes both files. `of` is the hash of the level's index, whose probes the factors are for. Throws Error(file).
void writeContact(const std::filesystem::path& folder, const level::Scene& scene, const PlacedVertices& vertices,
                  const std::vector<std::uint8_t>& bytes, const ContactCheck& check, const base::Hash128& of);

/// The factors of a folder, by vertex of `vertices`; nothing where there are none. Throws Error: content where they are
/// not of the index `of` or not of these vertices, or where a file is damaged.
std::optional<std::vector<std::uint8_t>> readContact(const std::filesystem::path& folder,
                                                     const PlacedVertices& vertices, const base::Hash128& of);

/// The error that a folder's factors leave, of the index `of`: {"vertices":, "error": {"points":, "probes":,
/// "contact":, "interval":, "hours": [..]}}, as contact.json has it. Nothing where there are none. Throws Error as
/// readContact does.
std::optional<nlohmann::ordered_json> readContactError(const std::filesystem::path& folder, const base::Hash128& of);

/// Puts a folder's factors into a scene that is to be drawn. Returns whether there were any. Throws as readContact
/// does.
bool addContact(level::Scene& scene, const std::filesystem::path& folder, const base::Hash128& of);

}  // namespace welkin::contact
