// SPDX-License-Identifier: Apache-2.0
#include "gloss/batch.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cctype>
#include <mutex>
#include <optional>
#include <set>

#include "gloss/report.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/failure.h"
#include "sky/base/hash.h"
#include "sky/base/json_text.h"
#include "sky/base/message.h"

namespace welkin::gloss {
namespace {

using Json = nlohmann::ordered_json;

// Changes whenever the same inputs give other files, so that files of older versions are made again.
constexpr std::string_view kMaker = "gloss 1";

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool isPicture(const std::filesystem::path& path) {
  static const std::set<std::string> kEndings = {".png",  ".exr",  ".tif", ".tiff", ".jpg",
                                                 ".jpeg", ".webp", ".bmp", ".tga",  ".dds"};
  return kEndings.contains(lowered(path.extension().string()));
}

/// The name before _normal, _nrm or _n; nothing without such an end.
std::optional<std::string> surfaceOf(const std::filesystem::path& path) {
  const std::string stem = path.stem().string();
  for (const std::string end : {"_normal", "_nrm", "_n"})
    if (stem.size() > end.size() && lowered(stem).ends_with(end)) return stem.substr(0, stem.size() - end.size());
  return std::nullopt;
}

/// Regular files of a folder that end as pictures do, by name.
std::vector<std::filesystem::path> picturesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> pictures;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (std::error_code none; at->is_regular_file(none) && isPicture(at->path())) pictures.push_back(at->path());
  if (error) throw base::Error(base::ExitStatus::file, fmt::format("{}: {}", folder.string(), error.message()));
  std::sort(pictures.begin(), pictures.end());
  return pictures;
}

/// Hash of all that decides the files of a texture.
std::string inputHashOf(const Request& request) {
  base::Hasher hasher;
  hasher.add(kMaker);
  for (const int option : {static_cast<int>(request.format), static_cast<int>(request.wrap), int{request.roughness},
                           int{request.flip_green}, int{request.options.decode_srgb}, int{request.options.repair}})
    hasher.add(option);
  hasher.add(request.max_error_deg.value_or(-1.0));
  hasher.add(request.gloss);
  for (const std::filesystem::path& path : inputsOf(request)) {
    hasher.add(path.filename().string());
    const std::vector<std::byte> bytes = base::readFile(path);
    hasher.addAll(std::span<const std::byte>(bytes));
  }
  return base::textOf(hasher.digest());
}

/// Whether every file of a report is in the folder as it was written.
bool areThere(const Json& report, const std::filesystem::path& folder) {
  for (const Json& file : report["files"]) {
    const std::filesystem::path path = folder / std::filesystem::path(std::string(file["name"])).filename();
    std::error_code none;
    if (std::filesystem::file_size(path, none) != file["bytes"] || none) return false;
    if (base::textOf(base::hashOf(base::readFile(path))) != file["xxh3_128"]) return false;
  }
  return true;
}

}  // namespace

std::vector<std::filesystem::path> inputsOf(const Request& request) {
  std::vector<std::filesystem::path> inputs{request.normal};
  if (!isNumber(request.gloss)) inputs.push_back(request.gloss);
  return inputs;
}

std::vector<Request> texturesIn(const std::filesystem::path& folder, const Request& common) {
  const auto refuse = [](const std::filesystem::path& path, const std::string& why) {
    return base::Error(base::ExitStatus::content, fmt::format("{}: {}", path.string(), why));
  };
  const std::vector<std::filesystem::path> pictures = picturesIn(folder);
  std::vector<Request> requests;
  for (const std::filesystem::path& path : pictures) {
    const auto surface = surfaceOf(path);
    if (!surface) continue;
    if (!requests.empty() && requests.back().normal.stem() == path.stem())
      throw refuse(path, "another picture has the same name but for its ending");
    Request request = common;
    request.normal = path;
    for (const bool roughness : {true, false})
      for (const std::filesystem::path& other : pictures)
        if (lowered(other.stem().string()) == lowered(*surface + (roughness ? "_roughness" : "_gloss"))) {
          request.gloss = other.string();
          request.roughness = roughness;
        }
    if (request.gloss.empty())
      throw refuse(
          path, fmt::format("no {0}_gloss or {0}_roughness beside it, and neither --gloss nor --roughness", *surface));
    requests.push_back(std::move(request));
  }
  if (requests.empty()) throw refuse(folder, "no normal maps: pictures whose names end in _normal, _nrm or _n");
  return requests;
}

FormerReports::FormerReports(std::string_view text) {
  static const Json kForm = {{"normal", "a"},
                             {"inputs", "0"},
                             {"files", {{{"name", "a"}, {"bytes", 1}, {"xxh3_128", "0"}}}},
                             {"warnings", Json::array()}};
  const auto report = base::parseJson(text);
  if (!report || !report->is_object()) return;
  const Json all = report->value("textures", Json::array({*report}));
  if (!all.is_array()) return;
  for (const Json& texture : all)
    if (base::hasForm(texture, kForm)) textures_.push_back(texture);
}

Made FormerReports::make(const Request& request, const std::filesystem::path& folder,
                         const base::Progress& progress) const {
  const std::string hash = inputHashOf(request);
  for (const Json& texture : textures_)
    if (texture["inputs"] == hash && areThere(texture, folder)) return {texture, true};
  Json report = reportOf(writeGloss(request, folder, progress));
  report["inputs"] = hash;
  return {std::move(report), false};
}

BatchResult makeAll(const std::vector<Request>& requests, const std::filesystem::path& folder,
                    const FormerReports& former, const base::Progress& progress) {
  const base::Progress stage = progress.stage("textures", requests.size());
  std::vector<std::optional<base::Error>> error(requests.size());
  BatchResult result;
  result.made.resize(requests.size());
  tbb::parallel_for(std::size_t{0}, requests.size(), [&](std::size_t i) {
    try {
      // Isolated, so that a thread that waits for a texture does not begin another, whose memory would add up.
      tbb::this_task_arena::isolate([&] { result.made[i] = former.make(requests[i], folder, stage); });
    } catch (const std::exception& e) {
      error[i] = base::errorOf(e);
      if (error[i]->status() == base::ExitStatus::interrupted) throw;
    }
    stage.step();
  });
  for (std::size_t i = 0; i < requests.size(); ++i)
    if (error[i]) result.failed.push_back({requests[i].normal.filename().string(), *error[i]});
  return result;
}

}  // namespace welkin::gloss
