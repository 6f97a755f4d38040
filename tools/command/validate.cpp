// SPDX-License-Identifier: Apache-2.0
// welkin validate: checks files.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "baked/welkin_file.h"
#include "command/arguments.h"
#include "command/certificate_text.h"
#include "command/commands.h"
#include "probes/build/bake_file.h"
#include "probes/build/folder_check.h"
#include "probes/build/level_files.h"
#include "probes/build/sector_warnings.h"
#include "probes/sectors/sector_file.h"
#include "sky/bake/sky_record.h"
#include "sky/bake/warnings.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/folder_lock.h"

namespace welkin::command {
namespace {

using Json = nlohmann::ordered_json;

void validateFile(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".toml") {
    build::BakeRequest request;
    request.file = path;
    const build::BakeInput read = build::readInput(request, {});
    Json warnings = Json::array();
    for (const bake::SkyFile& sky : build::skiesOf(read))
      for (Json& warning : bake::warningsJson(sky.warnings)) warnings.push_back(std::move(warning));
    if (read.level) build::addWarnings(*read.level, warnings);
    return printWarnings(warnings);
  }
  const format::Kind kind = baked::kindOfFile(path);
  if (kind == format::Kind::sector)
    sectors::decodeSector(base::readFile(path), path);
  else if (kind == format::Kind::level)
    build::readIndex(path);
  else
    baked::openSky(path);
}

/// Throws Error(content) if the folder has sectors. Called for a folder without an index, whose level is incomplete.
void requireNoSectors(const std::filesystem::path& folder) {
  std::error_code error;
  if (std::filesystem::is_directory(folder / "sectors", error) && !std::filesystem::is_empty(folder / "sectors", error))
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: holds sectors and no level.welkin: its bake did not end, or "
                                  "welkin merge is to come",
                                  folder.string()));
}

/// The skies of a folder, or the file itself.
std::vector<std::string> skiesAt(const std::string& path) {
  std::error_code error;
  std::vector<std::string> skies;
  if (std::filesystem::is_directory(path, error))
    for (const std::string& name : bake::recordedSkies(path))
      skies.push_back((std::filesystem::path(path) / (name + ".welkin")).string());
  if (skies.empty()) skies.push_back(baked::skyFileOf(path));
  return skies;
}

/// Checks a path. A folder stands for its skies and for all files that it records a checksum of.
void validatePath(const std::string& path) {
  if (!build::isLevelFolder(path)) requireNoSectors(path);
  for (const std::string& sky : skiesAt(path)) validateFile(sky);
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) build::checkFolder(path);
}

void validate(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    try {
      validatePath(path);
    } catch (const base::Error&) {
      base::requireUnused(path);  // a bake at work is why the files do not agree
      throw;
    }
    for (const std::string& sky : skiesAt(path)) fmt::print("{}: ok\n", sky);
  }
}

}  // namespace

void addValidate(CLI::App& app) {
  auto paths = std::make_shared<std::vector<std::string>>();
  auto* command = app.add_subcommand("validate", "Check .welkin files, folders of bakes and sky files");
  command->add_option("PATH", *paths, "Files and folders; the first that is wrong ends the check")->required();
  command->callback([paths] { validate(*paths); });
}

}  // namespace welkin::command
