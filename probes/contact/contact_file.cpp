// SPDX-License-Identifier: Apache-2.0
#include "probes/contact/contact_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/json_text.h"

namespace welkin::contact {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little);

constexpr int kVersion = 1;
constexpr std::size_t kLargestJson = std::size_t{1} << 28;

fs::path binPath(const fs::path& folder) {
  return folder / "contact.bin";
}

fs::path jsonPath(const fs::path& folder) {
  return folder / "contact.json";
}

ContactRecord recordOf(const PlacedVertices& v, std::size_t i, std::uint8_t factor) {
  ContactRecord record{};
  for (int axis = 0; axis < 3; ++axis) {
    record.position[axis] = static_cast<float>(v.position[i][axis]);
    record.normal[axis] = static_cast<std::int8_t>(std::floor(v.normal[i][axis] * 127.0 + 0.5));
  }
  record.factor = factor;
  return record;
}

std::vector<std::byte> bytesOf(const std::vector<ContactRecord>& records) {
  std::vector<std::byte> bytes(records.size() * sizeof(ContactRecord));
  if (!bytes.empty()) std::memcpy(bytes.data(), records.data(), bytes.size());
  return bytes;
}

Json errorJson(const ContactError& e) {
  return {{"probes", e.probes}, {"contact", e.contact}, {"interval", e.interval}};
}

Json errorsJson(const ContactCheck& check) {
  Json hours = Json::array();
  for (const auto& [time_h, error] : check.hour) {
    hours.push_back({{"time_h", time_h}});
    hours.back().update(errorJson(error));
  }
  Json errors = {{"points", check.points}};
  errors.update(errorJson(check.all));
  errors["hours"] = std::move(hours);
  return errors;
}

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw base::Error(base::ExitStatus::content, fmt::format("{}: {}", path.string(), why));
}

/// contact.json of the index `of`; nothing where the folder has no factors.
std::optional<Json> readList(const fs::path& folder, const base::Hash128& of) {
  std::error_code error;
  if (!fs::exists(jsonPath(folder), error) && !fs::exists(binPath(folder), error)) return std::nullopt;
  const std::vector<std::byte> text = base::readFile(jsonPath(folder), kLargestJson);
  auto json = base::parseJson({reinterpret_cast<const char*>(text.data()), text.size()});
  static const Json kForm = {
      {"welkin_contact", 1},
      {"level", ""},
      {"xxh3_128", ""},
      {"vertices", 1},
      {"error", {{"points", 1}, {"probes", 0.5}, {"contact", 0.5}, {"interval", 0.5}, {"hours", Json::array()}}}};
  if (!json || !base::hasForm(*json, kForm)) refuse(jsonPath(folder), "is no list of contact factors");
  if ((*json)["welkin_contact"] != kVersion)
    refuse(jsonPath(folder),
           fmt::format("welkin_contact is {}, must be {}", (*json)["welkin_contact"].dump(), kVersion));
  if ((*json)["level"] != base::textOf(of))
    refuse(jsonPath(folder), "is of another bake of the level: welkin contact makes it anew");
  return json;
}

}  // namespace

void writeContact(const fs::path& folder, const level::Scene& scene, const PlacedVertices& vertices,
                  const std::vector<std::uint8_t>& bytes, const ContactCheck& check, const base::Hash128& of) {
  std::vector<ContactRecord> records;
  for (std::size_t i = 0; i < bytes.size(); ++i) records.push_back(recordOf(vertices, i, bytes[i]));
  const std::vector<std::byte> bin = bytesOf(records);
  Json pieces = Json::array();
  for (const PlacedVertices::Piece& piece : vertices.piece)
    pieces.push_back({{"object", scene.objects[scene.placings[piece.instance].object].name},
                      {"first", piece.first},
                      {"count", piece.count}});
  const Json json = {
      {"welkin_contact", kVersion}, {"level", base::textOf(of)}, {"xxh3_128", base::textOf(base::hashOf(bin))},
      {"steps_of_1", kSteps},       {"vertices", bytes.size()},  {"error", errorsJson(check)},
      {"pieces", std::move(pieces)}};
  base::writeFile(binPath(folder), bin);
  base::writeFile(jsonPath(folder), json.dump(1) + "\n");
}

std::optional<std::vector<std::uint8_t>> readContact(const fs::path& folder, const PlacedVertices& vertices,
                                                     const base::Hash128& of) {
  const std::optional<Json> json = readList(folder, of);
  if (!json) return std::nullopt;
  if ((*json)["vertices"] != vertices.position.size())
    refuse(jsonPath(folder), fmt::format("vertices is {}, the level has {}: it is of another level.toml",
                                         (*json)["vertices"].dump(), vertices.position.size()));
  const std::vector<std::byte> bin = base::readFile(binPath(folder));
  if (bin.size() != vertices.position.size() * sizeof(ContactRecord) ||
      (*json)["xxh3_128"] != base::textOf(base::hashOf(bin)))
    refuse(binPath(folder), "is damaged, or not that of contact.json");
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < vertices.position.size(); ++i) {
    ContactRecord record;
    std::memcpy(&record, bin.data() + i * sizeof(record), sizeof(record));
    const ContactRecord own = recordOf(vertices, i, record.factor);
    if (std::memcmp(&record, &own, sizeof(record)) != 0)
      refuse(binPath(folder), fmt::format("vertex {} lies elsewhere in the level: it is of another level.toml", i));
    bytes.push_back(record.factor);
  }
  return bytes;
}

std::optional<Json> readContactError(const fs::path& folder, const base::Hash128& of) {
  const std::optional<Json> json = readList(folder, of);
  if (!json) return std::nullopt;
  return Json{{"vertices", (*json)["vertices"]}, {"error", (*json)["error"]}};
}

bool addContact(level::Scene& scene, const fs::path& folder, const base::Hash128& of) {
  const PlacedVertices vertices = placedVertices(scene);
  auto bytes = readContact(folder, vertices, of);
  if (!bytes) return false;
  scene.contact = std::move(*bytes);
  scene.first_contact.assign(scene.instances.size(), level::kNoContact);
  for (const PlacedVertices::Piece& piece : vertices.piece) scene.first_contact[piece.instance] = piece.first;
  return true;
}

}  // namespace welkin::contact
