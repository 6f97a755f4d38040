// SPDX-License-Identifier: Apache-2.0
// welkin contact: fits factors of the probes' light at the vertices of a baked level.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "baked/level_source.h"
#include "command/arguments.h"
#include "command/commands.h"
#include "command/shared_options.h"
#include "probes/build/level_bake.h"
#include "probes/build/level_files.h"
#include "probes/build/subject.h"
#include "probes/contact/contact_file.h"
#include "probes/loader/read_scene.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/folder_lock.h"
#include "sky/base/message.h"

namespace welkin::command {
namespace {

struct Options {
  std::string folder, level;
  ProgressOption progress;
  ThreadsOption threads;
};

std::vector<sectors::SectorFile> sectorsOf(const std::filesystem::path& folder) {
  std::vector<sectors::SectorFile> files;
  for (const sectors::SectorEntry& s : build::readIndex(build::indexPath(folder)).sector) {
    const std::filesystem::path path = build::sectorPath(folder, s.id);
    files.push_back(sectors::decodeSector(base::readFile(path), path.string()));
  }
  return files;
}

void print(const contact::ContactCheck& check, std::size_t vertices) {
  fmt::print("{} vertices, a byte each; rms errors on surfaces, of the open sky's light, at {} points\n", vertices,
             check.points);
  const auto line = [](const std::string& hour, const contact::ContactError& e) {
    fmt::print("{:>5}  probes {:5.1f} %  with contact {:5.1f} +- {:.1f} %\n", hour, 100.0 * e.probes, 100.0 * e.contact,
               100.0 * e.interval);
  };
  for (const auto& [time_h, error] : check.hour) line(fmt::format("{} h", time_h), error);
  line("all", check.all);
}

void runContact(const Options& options) {
  catchInterrupts();
  const auto limit = options.threads.limit();
  const std::filesystem::path folder = options.folder;
  if (!build::isLevelFolder(folder))
    throw base::Error(base::ExitStatus::file,
                      fmt::format("{}: holds no level.welkin: bake the level first", folder.string()));
  const baked::LevelSource source = baked::levelSource(folder, options.level);
  if (!source.warning.empty()) throw base::Error(base::ExitStatus::content, source.warning);
  const base::FolderLock lock(folder);
  const build::Subject subject = build::readLevel(source.file);
  const level::Scene scene = loader::readScene(level::levelFileOf(base::readToml(source.file)));
  const base::Hash128 of = base::hashOf(base::readFile(build::indexPath(folder)));
  const std::vector<sectors::SectorFile> sectors = sectorsOf(folder);
  const geometry::Tracer tracer(subject.level->surfaces);
  const contact::PlacedVertices vertices = contact::placedVertices(scene);
  const build::TransferSection& transfer = subject.level->section.transfer;
  contact::ContactCheck check;
  {
    ProgressReport shown(options.progress.style());
    contact::ContactSettings settings;
    settings.bounces = transfer.bounces;
    settings.reach_m = transfer.reach_m;
    const std::vector<std::uint8_t> bytes =
        contact::fitContact(tracer, subject.sky.sky, sectors, vertices, settings, shown.progress());
    check = contact::checkContact(tracer, subject.sky.sky, sectors, vertices, bytes, {.bounces = transfer.bounces},
                                  shown.progress());
    contact::writeContact(folder, scene, vertices, bytes, check, of);
  }
  print(check, vertices.position.size());
}

}  // namespace

void addContact(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand(
      "contact", "Fit a factor of the probes' light to every vertex of a baked level: contact.bin and contact.json");
  command->add_option("LEVEL_DIR", options->folder, "The folder of a baked level")->required();
  command->add_option("--level", options->level, "The level.toml that was baked, where it is not found");
  options->threads.addTo(*command, "The result does not depend on it");
  options->progress.addTo(*command);
  command->callback([options] { runContact(*options); });
}

}  // namespace welkin::command
