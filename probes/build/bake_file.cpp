// SPDX-License-Identifier: Apache-2.0
#include "probes/build/bake_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "probes/build/bake_sectors.h"
#include "probes/build/certify_bake.h"
#include "probes/build/level_files.h"
#include "probes/build/merged_report.h"
#include "probes/level/level_domain.h"
#include "sky/bake/bake_family.h"
#include "sky/bake/family.h"
#include "sky/bake/sky_domain.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/folder_lock.h"
#include "sky/base/make_rule.h"

namespace welkin::build {
namespace {

using Json = nlohmann::ordered_json;

void requireInDomain(const base::Domain& domain, const char* key, const std::optional<double>& budget) {
  const base::Range& range = base::parameterOf(domain, "bake", key).range;
  if (budget && !range.contains(*budget))
    throw base::Error(base::ExitStatus::usage,
                      fmt::format("{}: {} is not in {} to {}", key, *budget, range.low, range.high));
}

void requireLevel(const BakeRequest& request) {
  for (const auto& [name, given] : {std::pair("--shard", request.shard.has_value()),
                                    {"--sectors", !request.sectors.empty()},
                                    {"--max-surface-error", request.max_surface_error.has_value()}})
    if (given)
      throw base::Error(base::ExitStatus::usage,
                        fmt::format("{}: {} is no level file: it has no surfaces", name, request.file.string()));
}

/// The outputs whose dates say that the bake ran to its end: of a level its index, or a shard's part of it.
std::string ruleTargets(const BakeRequest& request, const BakeInput& read) {
  if (request.shard) return base::inMakeRule(partPath(request.folder, *request.shard));
  if (read.level) return base::inMakeRule(indexPath(request.folder));
  std::string targets;
  for (const bake::SkyFile& sky : skiesOf(read)) {
    if (!targets.empty()) targets += ' ';
    targets += base::inMakeRule(request.folder / (sky.name + ".welkin"));
  }
  return targets;
}

/// Bakes one sky or a family. A level's report is that of its own sky, with the family's members beside.
Json bakeSkies(const BakeRequest& request, const BakeInput& read, const base::Progress& progress, Json& timing) {
  const bake::SkyRequest wanted{request.certify, request.force, request.warn};
  if (read.more.empty()) return bake::bakeSky(read.sky, read.inputs, request.folder, wanted, progress, timing);
  Json report = bake::bakeFamily(skiesOf(read), read.inputs, request.folder, wanted, progress, timing);
  if (!read.level) return report;
  Json own = report["skies"][read.sky.name];
  own.update(report);
  return own;
}

/// The outputs of all skies that a report is about.
std::vector<Json> skyOutputs(const Json& report) {
  if (!report.contains("skies")) return {report.value("outputs", Json::array())};
  std::vector<Json> outputs;
  for (const Json& sky : report["skies"]) outputs.push_back(sky["outputs"]);
  return outputs;
}

std::vector<std::string> skyNames(const BakeInput& read) {
  std::vector<std::string> names;
  for (const bake::SkyFile& sky : skiesOf(read)) names.push_back(sky.name);
  return names;
}

/// The budgets and the target of a request in place of those of a sky file.
void applyOptions(const BakeRequest& request, bake::BakeSettings& bake) {
  if (request.max_error) bake.max_error = request.max_error;
  if (!request.target.empty()) bake::setTarget(bake, request.target);
  if (request.cubemap_error) bake::setCubemapError(bake, *request.cubemap_error);
}

void writeRule(const BakeRequest& request, const BakeInput& read) {
  std::vector<std::filesystem::path> inputs;
  for (const auto& input : read.inputs) inputs.push_back(input.path);
  if (read.level)
    for (const auto& file : read.level->surfaces().file)
      if (std::find(inputs.begin(), inputs.end(), file) == inputs.end()) inputs.push_back(file);
  std::string rule = ruleTargets(request, read);
  rule += ':';
  for (const auto& input : inputs) rule.append(1, ' ').append(base::inMakeRule(input));
  rule += '\n';
  base::writeFile(request.depfile, rule);
}

}  // namespace

std::vector<bake::SkyFile> skiesOf(const BakeInput& read) {
  std::vector<bake::SkyFile> skies = {read.sky};
  skies.insert(skies.end(), read.more.begin(), read.more.end());
  return skies;
}

BakeInput readInput(const BakeRequest& request, const base::Progress& progress) {
  requireInDomain(bake::skyDomain(), "max_error", request.max_error);
  if (request.cubemap_error != 0.0) requireInDomain(bake::skyDomain(), "cubemap_error", request.cubemap_error);
  requireInDomain(level::levelDomain(), "max_surface_error", request.max_surface_error);
  Subject subject = readSubject(request.file, request.more);
  BakeInput read{std::move(subject.sky), std::move(subject.more), std::move(subject.inputs), std::nullopt,
                 std::nullopt};
  applyOptions(request, read.sky.bake);
  for (bake::SkyFile& sky : read.more) applyOptions(request, sky.bake);
  if (!read.more.empty()) {
    const std::vector<bake::SkyFile> family = skiesOf(read);
    bake::checkFamily(family);
    if (subject.level) bake::checkLevelFamily(family);
  }
  if (!subject.level) requireLevel(request);
  if (!subject.level) return read;
  if (request.max_surface_error) subject.level->section.max_surface_error = request.max_surface_error;
  try {
    read.level.emplace(std::move(subject.level->surfaces), subject.level->section, read.sky.sky,
                       read.sky.bake.max_error, progress);
    if (read.level->surfaceBudget()) read.choice = earlierChoice(*read.level, read.sky, request.folder);
    if (read.choice) read.level->setSpreads(read.choice->spread);
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
  BakeInput read = readInput(request, progress);
  LevelOptions wanted{request.folder, request.shard, {}, request.force};
  if (!request.sectors.empty()) wanted.sectors = parseSectors(request.sectors, read.level->sectors());
  base::makeFolder(request.folder);
  const base::FolderLock lock(request.folder, request.shard ? std::optional(request.shard->index) : std::nullopt);
  if (!request.shard) removeTemporaries(request.folder, skyNames(read));  // those of shards may be at work
  // A bake may end at any of these writes. The rule is there before its target has a new date; the report, which has
  // the checksums of all outputs, comes last: a set that it does not fit is half of an old bake and half of a new one.
  if (!request.depfile.empty()) writeRule(request, read);
  Json timing;
  Json report = {{"warnings", Json::array()}};
  if (!request.shard || request.shard->index == 0)  // else another shard bakes it
    report = bakeSkies(request, read, progress, timing);
  if (read.level && read.level->surfaceBudget()) {
    const bool part = wanted.shard || !wanted.sectors.empty();
    if (!read.choice || (request.force && !part)) {
      read.choice = chooseSpreads(*read.level, read.sky, part, progress);
      wanted.ready = std::move(read.choice->file);
    }
    read.level->setSpreads(read.choice->spread);
    report["surface_budget"] = choiceJson(*read.level, *read.choice);
  }
  if (read.level) {
    if (const auto index = bakeSectors(*read.level, wanted, progress, report, timing))
      certifyBake(*read.level, read.sky.sky, request.folder, *index, request.certify, progress, report);
    std::error_code error;
    timing["level"] = std::filesystem::proximate(request.file, request.folder, error).generic_string();
  }
  timing["total_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (const Json& outputs : skyOutputs(report))
    for (const Json& output : outputs)
      base::requireSize(request.folder / output.at("file").get<std::string>(), output.at("bytes").get<std::uint64_t>());
  if (!lock.readOnly()) base::writeFile(timingPath(request.folder, request.shard), reportText(timing));
  base::writeFile(request.report.empty() ? reportPath(request.folder, request.shard) : request.report,
                  reportText(report));
  if (read.choice) requireKept(request.file, *read.level, report);
  return report;
}

}  // namespace welkin::build
