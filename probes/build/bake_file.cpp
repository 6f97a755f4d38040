// SPDX-License-Identifier: Apache-2.0
#include "probes/build/bake_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "probes/build/bake_sectors.h"
#include "probes/build/certify_bake.h"
#include "probes/build/level_files.h"
#include "probes/build/merged_report.h"
#include "sky/bake/bake_sky.h"
#include "sky/bake/sky_domain.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/folder_lock.h"

namespace welkin::build {
namespace {

using Json = nlohmann::ordered_json;

/// A path in a make rule.
std::string escaped(const std::filesystem::path& path) {
  std::string out;
  for (const char c : path.string()) {
    if (c == ' ' || c == '#') out += '\\';
    if (c == '$') out += '$';
    out += c;
  }
  return out;
}

void requireInDomain(const char* key, const std::optional<double>& budget) {
  const base::Range& range = base::parameterOf(bake::skyDomain(), "bake", key).range;
  if (budget && !range.contains(*budget))
    throw base::Error(base::ExitStatus::usage,
                      fmt::format("{}: {} is not in {} to {}", key, *budget, range.low, range.high));
}

void requireLevel(const BakeRequest& request) {
  for (const auto& [name, given] :
       {std::pair("--shard", request.shard.has_value()), {"--sectors", !request.sectors.empty()}})
    if (given)
      throw base::Error(base::ExitStatus::usage,
                        fmt::format("{}: {} is no level file: it has no sectors", name, request.file.string()));
}

/// The output whose date says that the bake ran to its end: of a level its index, or a shard's part of it.
std::filesystem::path ruleTarget(const std::filesystem::path& folder, const std::optional<Shard>& shard,
                                 bool of_level) {
  if (shard) return partPath(folder, *shard);
  return of_level ? indexPath(folder) : folder / "sky.welkin";
}

void writeRule(const BakeRequest& request, const BakeInput& read) {
  std::vector<std::filesystem::path> inputs;
  for (const auto& input : read.inputs) inputs.push_back(input.path);
  if (read.level)
    for (const auto& file : read.level->surfaces().file)
      if (std::find(inputs.begin(), inputs.end(), file) == inputs.end()) inputs.push_back(file);
  std::string rule = escaped(ruleTarget(request.folder, request.shard, read.level.has_value()));
  rule += ':';
  for (const auto& input : inputs) rule.append(1, ' ').append(escaped(input));
  rule += '\n';
  base::writeFile(request.depfile, rule);
}

}  // namespace

BakeInput readInput(const BakeRequest& request, const base::Progress& progress) {
  requireInDomain("max_error", request.max_error);
  if (request.cubemap_error != 0.0) requireInDomain("cubemap_error", request.cubemap_error);
  Subject subject = readSubject(request.file);
  if (request.max_error) subject.sky.bake.max_error = request.max_error;
  if (!request.target.empty()) bake::setTarget(subject.sky.bake, request.target);
  if (request.cubemap_error) bake::setCubemapError(subject.sky.bake, *request.cubemap_error);
  BakeInput read{std::move(subject.sky), std::move(subject.inputs), std::nullopt};
  if (!subject.level) requireLevel(request);
  if (!subject.level) return read;
  try {
    read.level.emplace(std::move(subject.level->surfaces), subject.level->section, read.sky.sky,
                       read.sky.bake.max_error, progress);
  } catch (const base::Error& e) {  // it does not know the file
    if (e.status() != base::ExitStatus::content) throw;
    throw base::Error(e.status(), fmt::format("{}: {}", request.file.string(), e.what()));
  }
  return read;
}

std::string reportText(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json bakeFile(const BakeRequest& request, const base::Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const BakeInput read = readInput(request, progress);
  LevelOptions wanted{request.folder, request.shard, {}, request.force};
  if (!request.sectors.empty()) wanted.sectors = parseSectors(request.sectors, read.level->sectors());
  base::makeFolder(request.folder);
  const base::FolderLock lock(request.folder, request.shard ? std::optional(request.shard->index) : std::nullopt);
  if (!request.shard) removeTemporaries(request.folder);  // those of shards may be at work
  // A bake may end at any of these writes. The rule is there before its target has a new date; the report, which has
  // the checksums of all outputs, comes last: a set that it does not fit is half of an old bake and half of a new one.
  if (!request.depfile.empty()) writeRule(request, read);
  Json timing;
  Json report = {{"warnings", Json::array()}};
  if (!request.shard || request.shard->index == 0)  // else another shard bakes it
    report = bake::bakeSky(read.sky, read.inputs, request.folder, {request.certify, request.force, request.warn},
                           progress, timing);
  if (read.level)
    if (const auto index = bakeSectors(*read.level, wanted, progress, report, timing))
      certifyBake(*read.level, read.sky.sky, request.folder, *index, request.certify, progress, report);
  timing["total_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (report.contains("outputs"))
    for (const Json& output : report["outputs"])
      base::requireSize(request.folder / output.at("file").get<std::string>(), output.at("bytes").get<std::uint64_t>());
  if (!lock.readOnly()) base::writeFile(timingPath(request.folder, request.shard), reportText(timing));
  base::writeFile(request.report.empty() ? reportPath(request.folder, request.shard) : request.report,
                  reportText(report));
  return report;
}

}  // namespace welkin::build
