// SPDX-License-Identifier: Apache-2.0
#include "calibrate/batch.h"

#include <fmt/format.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "calibrate/albedo_file.h"
#include "calibrate/chart_picture.h"
#include "calibrate/polarised.h"
#include "calibrate/report.h"
#include "sky/base/atomic_file.h"
#include "sky/base/failure.h"
#include "sky/base/hash.h"
#include "sky/base/json_text.h"
#include "sky/base/message.h"

namespace welkin::calibrate {
namespace {

using Json = nlohmann::ordered_json;

// Changes whenever the same inputs give other files, so that files of older versions are made again.
constexpr std::string_view kMaker = "calibrate 3";

bool isPhotograph(const std::filesystem::path& path) {
  static const std::set<std::string> kEndings = {".png", ".exr", ".tif", ".tiff", ".jpg", ".jpeg"};
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return kEndings.contains(ending);
}

void requireOther(const Job& job, const Batch& batch) {
  for (const std::string& name : {job.albedo, job.report, job.profile, job.picture})
    base::requireNoInput(batch.folder / name, std::array{job.photo, batch.parallel});
  base::requireNoInput(batch.folder / job.specular, std::array{job.photo, batch.parallel});
  if (job.albedo == job.picture)
    throw base::Error(base::ExitStatus::usage,
                      fmt::format("{}: its albedo would have the name of the report's picture, "
                                  "{}; --format exr and tif have another",
                                  job.photo.string(), job.picture));
}

/// Hash of all that decides the files of a photograph.
std::string inputHashOf(std::span<const std::byte> photo, const Batch& batch) {
  base::Hasher hasher;
  hasher.add(kMaker);
  hasher.add(batch.format);
  hasher.add(batch.photo.model);
  hasher.add(static_cast<int>(batch.photo.encoding));
  hasher.add(int{batch.photo.flatten});
  for (const Colour& c : batch.photo.reference) hasher.addAll(std::span<const double>(c.data(), 3));
  if (batch.photo.corners)
    for (const Point& p : *batch.photo.corners) hasher.addAll(std::span<const double>(p.data(), 2));
  if (batch.profile) hasher.add(profileJson(*batch.profile).dump());
  hasher.addAll(photo);
  return base::textOf(hasher.digest());
}

/// The report of a former run, if it had this input and its albedo is as it wrote it.
std::optional<Json> formerReport(const Job& job, const Batch& batch, const std::string& inputs) {
  static const Json kForm = {{"inputs", "0"}, {"albedo", "a"}, {"albedo_xxh3_128", "0"}};
  std::error_code none;
  const std::filesystem::path path = batch.folder / job.report, albedo = batch.folder / job.albedo;
  if (!std::filesystem::is_regular_file(path, none) || !std::filesystem::is_regular_file(albedo, none))
    return std::nullopt;
  const std::vector<std::byte> bytes = base::readFile(path);
  auto report = base::parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!report || !base::hasForm(*report, kForm) || (*report)["inputs"] != inputs) return std::nullopt;
  if (base::textOf(base::hashOf(base::readFile(albedo))) != (*report)["albedo_xxh3_128"]) return std::nullopt;
  if (!batch.profile && !std::filesystem::is_regular_file(batch.folder / job.profile, none)) return std::nullopt;
  if ((*report).contains("picture") && !std::filesystem::is_regular_file(batch.folder / job.picture, none))
    return std::nullopt;
  return report;
}

/// The picture of a calibration, or of a profile on the first of a photograph's charts; empty without charts.
std::string pictureOf(const image::Image& photo, const std::optional<CalibratedPhoto>& calibrated,
                      const std::vector<ChartError>& others, const Profile& profile, const ReferenceChart& reference) {
  std::vector<ChartPlace> places;
  if (calibrated) places.push_back(calibrated->charts[0].place);
  for (const ChartError& other : others) places.push_back(other.chart.place);
  if (places.empty()) return "";
  if (!calibrated)
    return drawReport(photo, places,
                      {others[0].chart.patches, profile.model, others[0].used, others[0].before, others[0].after, {}},
                      reference);
  const Calibration& c = calibrated->calibration;
  return drawReport(photo, places,
                    {calibrated->charts[0].patches, c.model, c.used, c.before, c.errors().fit, c.errors().left_out},
                    reference);
}

image::Image readFor(const Profile& profile, const std::string& name, std::span<const std::byte> bytes) {
  image::ImageLimits limits = kPhotoLimits;
  limits.linear_codes = profile.linear_codes;
  limits.negative = true;  // as calibratePhoto() reads
  return image::readImage(name, bytes, limits);
}

/// The names with a prefix for those that do not tell of which photograph they are.
Job jobOf(const std::filesystem::path& photo, const Batch& batch, const std::string& prefix) {
  Job job{photo,
          fmt::format("{}.{}", photo.stem().string(), batch.format),
          prefix + "report.json",
          prefix + "profile.json",
          prefix + "report.png",
          fmt::format("{}.specular.{}", photo.stem().string(), batch.format)};
  requireOther(job, batch);
  return job;
}

}  // namespace

Job singleJob(const std::filesystem::path& photo, const Batch& batch) {
  return jobOf(photo, batch, "");
}

std::vector<std::filesystem::path> picturesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> photos;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (std::error_code none; at->is_regular_file(none) && isPhotograph(at->path())) photos.push_back(at->path());
  if (error) throw base::Error(base::ExitStatus::file, fmt::format("{}: {}", folder.string(), error.message()));
  if (photos.empty())
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: no pictures: png, jpg, jpeg, tif, tiff and exr are read", folder.string()));
  std::sort(photos.begin(), photos.end());
  return photos;
}

std::vector<Job> jobsIn(const std::filesystem::path& folder, const Batch& batch) {
  std::vector<Job> jobs;
  std::set<std::string> stems, names;
  for (const std::filesystem::path& photo : picturesIn(folder)) {
    const std::string stem = photo.stem().string();
    if (!stems.insert(stem).second)
      throw base::Error(base::ExitStatus::content,
                        fmt::format("{}: another picture has the same name but for its ending", photo.string()));
    Job job = jobOf(photo, batch, stem + ".");
    for (const std::string& name : {job.albedo, job.report, job.profile, job.picture})
      if (!names.insert(name).second)
        throw base::Error(base::ExitStatus::content,
                          fmt::format("{}: another picture's files hold {}, too", photo.string(), name));
    jobs.push_back(std::move(job));
  }
  return jobs;
}

Made make(const Job& job, const Batch& batch, bool resume) {
  const std::string name = job.photo.string();
  const std::vector<std::byte> bytes = base::readFile(job.photo);
  const std::string inputs = inputHashOf(bytes, batch);
  Made made;  // resume is for folders, which have no parallel photograph
  if (auto former = resume ? formerReport(job, batch, inputs) : std::nullopt) {
    made.report = std::move(*former);
    made.up_to_date = true;
    return made;
  }
  if (!batch.profile) made.calibrated = calibratePhoto(job.photo, batch.photo);
  const Profile profile = batch.profile ? *batch.profile : profileOf(*made.calibrated);
  const image::Image photo = batch.profile ? readFor(profile, name, bytes) : std::move(made.calibrated->image);
  const double past = partPastChart(photo, profile);
  std::vector<std::string> notes = batch.profile ? photo.notes : std::vector<std::string>{};
  if (past > kMuchPastChart)
    notes.push_back(
        fmt::format("{:.0f} % of the pixels are brighter than the chart, where the model is a guess", 100.0 * past));
  std::optional<Specular> specular;
  if (!batch.parallel.empty()) {
    const std::string parallel = batch.parallel.string();
    specular = specularOf(photo, readFor(profile, parallel, base::readFile(batch.parallel)), parallel, profile.model);
    if (specular->below > kMuchBelow)
      notes.push_back(
          fmt::format("{}: darker than the crossed photograph in {:.0f} % of the pixels: perhaps they are "
                      "exchanged, or of other exposure",
                      parallel, 100.0 * specular->below));
  }
  if (made.calibrated) made.calibrated->warnings.insert(made.calibrated->warnings.end(), notes.begin(), notes.end());
  const std::filesystem::path albedo = batch.folder / job.albedo;
  if (specular) writeAlbedo(batch.folder / job.specular, specular->image);
  writeAlbedo(albedo, albedoOf(photo, profile.model));
  made.report = {{"photo", base::oneLine(job.photo.filename().string())},
                 {"albedo", base::oneLine(job.albedo)},
                 {"albedo_xxh3_128", base::textOf(base::hashOf(base::readFile(albedo)))},
                 {"inputs", inputs},
                 {"past_chart", past}};
  std::vector<ChartError> others;
  if (made.calibrated)
    others = made.calibrated->others;
  else
    for (const FoundChart& chart : chartsIn(photo, profile.linear_codes, batch.photo.reference))
      others.push_back(errorOn(chart, profile.model, batch.photo.reference));
  const std::string picture = pictureOf(photo, made.calibrated, others, profile, batch.photo.reference);
  if (specular) made.report["specular"] = {{"file", base::oneLine(job.specular)}, {"below", specular->below}};
  if (!picture.empty()) {
    base::writeFile(batch.folder / job.picture, picture);
    made.report["picture"] = base::oneLine(job.picture);
  }
  if (made.calibrated) {
    made.report.update(reportJson(*made.calibrated, batch.photo.reference));
    base::writeFile(batch.folder / job.profile, profileJson(profile).dump(2) + "\n");
  } else {
    made.report["charts"] = Json::array();
    for (const ChartError& other : others) made.report["charts"].push_back(chartErrorJson(other));
    if (base::textOf(base::hashOf(bytes)) == profile.photo) made.report["fitted_here"] = true;
    made.report["model"] = profile.model.kind->name;
    made.report["warnings"] = Json::array();
    for (const std::string& note : notes) made.report["warnings"].push_back(base::oneLine(note));
  }
  base::writeFile(batch.folder / job.report, made.report.dump(2) + "\n");
  return made;
}

BatchResult makeAll(const std::vector<Job>& jobs, const Batch& batch, bool resume, const base::Progress& progress) {
  const base::Progress stage = progress.stage("photographs", jobs.size());
  std::vector<std::optional<base::Error>> error(jobs.size());
  BatchResult result;
  result.made.resize(jobs.size());
  const auto one = [&](std::size_t i) {
    try {
      // Isolated, so that a thread that waits for a photograph does not begin another, whose memory would add up.
      tbb::this_task_arena::isolate([&] { result.made[i] = make(jobs[i], batch, resume); });
    } catch (const std::exception& e) {
      error[i] = base::errorOf(e);
      if (error[i]->status() == base::ExitStatus::interrupted) throw;
    }
    stage.step();
  };
  std::size_t next = 0;
  tbb::parallel_pipeline(
      kMostAtOnce, tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& flow) {
                     if (next == jobs.size()) flow.stop();
                     return next == jobs.size() ? next : next++;
                   }) & tbb::make_filter<std::size_t, void>(tbb::filter_mode::parallel, one));
  for (std::size_t i = 0; i < jobs.size(); ++i)
    if (error[i]) result.failed.push_back({jobs[i].photo.filename().string(), *error[i]});
  return result;
}

}  // namespace welkin::calibrate
