// SPDX-License-Identifier: Apache-2.0
// Reads level.toml.
#include "probes/level/level_file.h"

#include <fmt/format.h>

#include "probes/level/level_domain.h"
#include "sky/base/toml_table.h"

namespace welkin::level {
namespace {

using base::Range;
using base::TomlTable;
using f64::Number3;

const Range& rangeOf(std::string_view key) {
  return base::parameterOf(levelDomain(), "[geometry]", key).range;
}

std::string requiredName(TomlTable& table, const std::string& key) {
  const std::string name = table.string(key, {}, "");
  if (name.empty()) table.refuse(key, table.node(key), "is missing or empty; it must be the name of a file");
  return name;
}

/// One name, or a list of names.
std::vector<std::string> requiredNames(TomlTable& table, const std::string& key) {
  const toml::node* n = table.node(key);
  if (n == nullptr || !n->is_array()) return {requiredName(table, key)};
  constexpr const char* kMust = "must be the name of a file, or a list of one or more names";
  std::vector<std::string> names;
  for (const toml::node& entry : *n->as_array()) {
    const auto name = entry.value<std::string>();
    if (!entry.is_string() || name->empty()) table.refuse(key, &entry, kMust);
    names.push_back(*name);
  }
  if (names.empty()) table.refuse(key, n, kMust);
  return names;
}

Number3 readScale(TomlTable& table) {
  const toml::node* n = table.node("scale");
  if (n == nullptr || n->is_array()) return table.colour("scale", rangeOf("scale"), Number3(1.0));
  return Number3(table.number("scale", rangeOf("scale"), 1.0));
}

std::vector<std::string> readPatterns(TomlTable& table, const char* key) {
  std::vector<std::string> patterns;
  const toml::node* n = table.node(key);
  if (n == nullptr) return patterns;
  if (!n->is_array()) table.refuse(key, n, "must be a list of node names, * for any characters");
  for (const toml::node& entry : *n->as_array()) {
    const auto name = entry.value<std::string>();
    if (!name) table.refuse(key, &entry, "must be a node name, * for any characters");
    patterns.push_back(*name);
  }
  return patterns;
}

GeometryEntry readGeometry(TomlTable table, const std::filesystem::path& folder) {
  GeometryEntry entry;
  entry.path = folder / requiredName(table, "file");
  const Number3 translation = table.colour("translation", rangeOf("translation"), Number3(0.0));
  const Number3 rotation_deg = table.colour("rotation_deg", rangeOf("rotation_deg"), Number3(0.0));
  entry.transform = geometry::fromEuler(translation, rotation_deg * f64::kDegree, readScale(table));
  entry.role = *roleOf(table.string("role", {"static", "vegetation", "ignore"}, "static"));
  entry.vegetation_nodes = readPatterns(table, "vegetation_nodes");
  entry.ignore_nodes = readPatterns(table, "ignore_nodes");
  entry.albedo = table.colour("albedo", rangeOf("albedo"), entry.albedo);
  table.finish();
  return entry;
}

}  // namespace

std::optional<geometry::Role> roleOf(const std::string& name) {
  if (name == "static") return geometry::Role::fixed;
  if (name == "vegetation") return geometry::Role::vegetation;
  if (name == "water") return geometry::Role::water;
  if (name == "ignore") return geometry::Role::ignored;
  return std::nullopt;
}

LevelFile levelFileOf(const base::TomlFile& toml) {
  const std::string name = toml.path.string();
  const std::filesystem::path folder = toml.path.parent_path();
  TomlTable top(name, &toml.root, "");
  LevelFile file;
  TomlTable level = top.table("level");
  file.folder = folder.empty() ? "." : folder;
  const std::vector<std::string> skies = requiredNames(level, "sky");
  file.sky = folder / skies.front();
  for (std::size_t i = 1; i < skies.size(); ++i) file.more_skies.push_back(folder / skies[i]);
  const std::string outside = level.string("outside_files", {"warn", "allow", "refuse"}, "warn");
  file.outside_files = outside == "warn"    ? OutsideFiles::warn
                       : outside == "allow" ? OutsideFiles::allow
                                            : OutsideFiles::refuse;
  level.finish();
  for (const char* of_the_bake : {"probes", "transfer", "bake", "scale"}) top.table(of_the_bake);
  top.has("room");
  const toml::node* geometry = top.node("geometry");
  if (geometry == nullptr || !geometry->is_array_of_tables())
    top.refuse("geometry", geometry, "must be one or more tables, [[geometry]]");
  for (const toml::node& entry : *geometry->as_array())
    file.geometry.push_back(
        readGeometry(TomlTable(name, entry.as_table(), fmt::format("geometry[{}].", file.geometry.size())), folder));
  top.finish();
  return file;
}

}  // namespace welkin::level
