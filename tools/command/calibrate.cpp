// SPDX-License-Identifier: Apache-2.0
// welkin calibrate: albedo from photographs that hold a colour chart, or of a chart's light.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

#include "calibrate/batch.h"
#include "calibrate/report.h"
#include "command/arguments.h"
#include "command/check_albedo.h"
#include "command/commands.h"
#include "command/progress.h"
#include "command/shared_options.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/folder_lock.h"
#include "sky/base/message.h"

namespace welkin::command {
namespace {

struct Options {
  std::string photo, folder, corners, reference, apply, parallel;
  std::string edition = "after-2014", input = "auto", model = "auto", format = "exr";
  ThreadsOption threads;
  ProgressOption progress;
  bool json = false, force = false, check = false, flatten = false;
  double allowed = 5.0;  ///< percent
};

[[noreturn]] void refuseUsage(const std::string& why) {
  throw base::Error(base::ExitStatus::usage, why);
}

calibrate::Corners cornersOf(const std::string& text) {
  const auto numbers = parseNumbers(text);
  if (!numbers || numbers->size() != 8)
    refuseUsage(
        fmt::format("--corners {}: eight numbers x,y,x,y,x,y,x,y in pixels are wanted, next to the patches "
                    "dark skin, bluish green, black and white",
                    text));
  calibrate::Corners corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = {(*numbers)[2 * i], (*numbers)[2 * i + 1]};
  return corners;
}

calibrate::PhotoOptions photoOptions(const Options& options) {
  using calibrate::Encoding;
  calibrate::PhotoOptions result;
  result.encoding = options.input == "auto"     ? Encoding::choose
                    : options.input == "linear" ? Encoding::linear
                                                : Encoding::srgb;
  if (!options.corners.empty()) result.corners = cornersOf(options.corners);
  if (options.model != "auto" && calibrate::modelNamed(options.model) == nullptr)
    refuseUsage(fmt::format("--model {}: auto, {} are allowed", options.model, calibrate::modelNames()));
  result.model = options.model;
  result.flatten = options.flatten;
  result.reference = options.reference.empty()
                         ? calibrate::referenceChart(options.edition == "before-2014" ? calibrate::Edition::before_2014
                                                                                      : calibrate::Edition::after_2014)
                         : calibrate::readReferenceChart(options.reference);
  return result;
}

void printLine(const char* what, const std::vector<double>& differences) {
  const calibrate::DifferenceSummary s = calibrate::summaryOf(differences);
  fmt::print("{:10} {:7.2f} {:7.2f} {:7.2f}\n", what, s.mean, s.p95, s.worst);
}

void print(const calibrate::CalibratedPhoto& photo) {
  const calibrate::Calibration& c = photo.calibration;
  for (const calibrate::FoundChart& chart : photo.charts) {
    fmt::print("chart at");
    for (const calibrate::Point& p : chart.place.corners()) fmt::print(" ({:.1f}, {:.1f})", p.x(), p.y());
    fmt::print(", confidence {:.3f}\n", chart.confidence);
  }
  fmt::print("model {}, codes read as {}, {} patches, sum of squares {:.4f} in encoded sRGB, {:.4f} in xyY\n",
             c.model.kind->name, photo.linear_codes ? "linear" : "sRGB", c.used.size(), c.rss_srgb, c.rss_xyY);
  if (photo.light)
    fmt::print("light of the right edge by the left {:.3f}, of the bottom by the top {:.3f}\n",
               std::exp(photo.light->along), std::exp(photo.light->down));
  fmt::print("CIEDE2000     mean     95%   worst\n");
  printLine("before", c.before);
  printLine("fit", c.errors().fit);
  printLine("left out", c.errors().left_out);
  for (const calibrate::ChartError& other : photo.others) {
    const calibrate::Point& at = other.chart.place.corners()[0];
    fmt::print("on the chart at ({:.1f}, {:.1f}), which the model was not fitted to\n", at.x(), at.y());
    printLine("before", other.before);
    printLine("after", other.after);
  }
}

/// One line of a photograph, from its report: the model and its errors on charts that it was not fitted to.
std::string lineOf(const nlohmann::ordered_json& r, bool up_to_date) {
  std::string text = fmt::format("{}: {}", std::string(r["photo"]), std::string(r["model"]));
  const bool is_fit = r.contains("de2000");
  if (is_fit) text += fmt::format(", CIEDE2000 left out {:.2f}", double{r["de2000"]["left_out"]["mean"]});
  const char* which = is_fit ? "another" : r.contains("fitted_here") ? "the fit's own" : "its";
  for (const auto& chart : r["charts"])
    if (chart.contains("de2000"))
      text += fmt::format(", CIEDE2000 on {} chart {:.2f}, before {:.2f}", which,
                          double{chart["de2000"]["after"]["mean"]}, double{chart["de2000"]["before"]["mean"]});
  return text + (up_to_date ? ", up to date" : "") + "\n";
}

void warn(const std::string& photo, const nlohmann::ordered_json& warnings) {
  for (const std::string warning : warnings)
    std::fputs(fmt::format("welkin: warning: {}: {}\n", base::oneLine(photo), warning).c_str(), stderr);
}

bool isFolder(const std::string& path) {
  std::error_code none;
  return std::filesystem::is_directory(path, none);
}

/// The profile of --apply: a file of one, or that of a photograph with a chart.
calibrate::Profile appliedProfile(const Options& options, const calibrate::PhotoOptions& photo_options) {
  if (std::filesystem::path(options.apply).extension() == ".json") return calibrate::readProfile(options.apply);
  const calibrate::CalibratedPhoto chart = calibrate::calibratePhoto(options.apply, photo_options);
  for (const std::string& warning : chart.warnings)
    std::fputs(fmt::format("welkin: warning: {}: {}\n", base::oneLine(options.apply), base::oneLine(warning)).c_str(),
               stderr);
  return calibrate::profileOf(chart);
}

calibrate::Batch batchOf(const Options& options) {
  calibrate::Batch batch;
  batch.photo = photoOptions(options);
  batch.format = options.format;
  batch.folder = options.folder;
  batch.parallel = options.parallel;
  if (!options.apply.empty()) batch.profile = appliedProfile(options, batch.photo);
  return batch;
}

void runOne(const Options& options, const calibrate::Batch& batch) {
  const calibrate::Job job = calibrate::singleJob(options.photo, batch);
  for (const char* input : {options.apply.c_str(), options.reference.c_str()})
    for (const std::string& output : {job.albedo, job.report, job.profile, job.picture, job.specular})
      base::requireNoInput(batch.folder / output, std::array<std::filesystem::path, 1>{input});
  const calibrate::Made made = calibrate::make(job, batch, false);
  warn(options.photo, made.report["warnings"]);
  if (options.json)
    fmt::print("{}\n", (made.calibrated ? calibrate::summaryJson(*made.calibrated) : made.report).dump(2));
  else if (made.calibrated)
    print(*made.calibrated);
  else
    fmt::print("{}", lineOf(made.report, false));
}

/// One line a photograph, or all reports.
void printAll(const Options& options, const calibrate::BatchResult& result) {
  if (options.json) {
    nlohmann::ordered_json all = {{"photographs", nlohmann::ordered_json::array()},
                                  {"failed", nlohmann::ordered_json::array()}};
    for (const calibrate::Made& made : result.made)
      if (!made.report.is_null()) all["photographs"].push_back(made.report);
    for (const auto& failure : result.failed)
      all["failed"].push_back(
          {{"photo", base::oneLine(failure.photo)}, {"message", base::oneLine(failure.error.what())}});
    return fmt::print("{}\n", all.dump(2));
  }
  for (const calibrate::Made& made : result.made) {
    if (!made.report.is_null()) fmt::print("{}", lineOf(made.report, made.up_to_date));
  }
}

void runFolder(const Options& options, const calibrate::Batch& batch) {
  if (!options.parallel.empty()) refuseUsage("--parallel: it belongs to one photograph, and a folder is given");
  if (!options.corners.empty() && options.apply.empty())
    refuseUsage("--corners: they are those of one photograph, and a folder is given");
  const std::vector<calibrate::Job> jobs = calibrate::jobsIn(options.photo, batch);
  catchInterrupts();
  ProgressReport shown(options.progress.style());
  const base::FolderLock lock(batch.folder);
  const calibrate::BatchResult result = calibrate::makeAll(jobs, batch, !options.force, shown.progress());
  for (const calibrate::Made& made : result.made)
    if (!made.report.is_null()) warn(made.report["photo"], made.report["warnings"]);
  printAll(options, result);
  if (result.failed.empty()) return;
  for (const auto& failure : result.failed)
    std::fputs(fmt::format("welkin: {}\n", base::oneLine(failure.error.what())).c_str(), stderr);
  throw base::Error(result.failed[0].error.status(),
                    fmt::format("{} of {} photographs failed", result.failed.size(), jobs.size()));
}

/// --check: the worst albedo first, and exit status 3 where one is past what is allowed.
void runCheck(const Options& options, const calibrate::ReferenceChart& reference) {
  const calibrate::Gamut gamut(reference);
  const auto checked = checkedAlbedo(options.photo, gamut);
  const nlohmann::ordered_json json = calibrate::checkJson(checked, options.allowed / 100.0);
  if (options.json) {
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("   dark  bright outside  percent of texels\n");
    for (const calibrate::CheckedAlbedo& c : checked)
      fmt::print("{:7.2f} {:7.2f} {:7.2f}  {}\n", 100.0 * c.shares.dark, 100.0 * c.shares.bright,
                 100.0 * c.shares.outside, base::oneLine(c.name));
  }
  if (!json["passed"])
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{}: {}: more than {} % of the texels are no likely albedo of a dielectric",
                                  options.photo, checked.front().name, options.allowed));
}

void run(const Options& options) {
  if (options.check) return runCheck(options, photoOptions(options).reference);
  if (options.folder.empty()) refuseUsage("-o is required: the folder for the albedo");
  const auto limit = options.threads.limit();
  const calibrate::Batch batch = batchOf(options);
  const bool many = isFolder(options.photo);
  if (!many) calibrate::singleJob(options.photo, batch);  // refuses before the folder is made
  base::makeFolder(batch.folder);
  many ? runFolder(options, batch) : runOne(options, batch);
}

}  // namespace

void addCalibrate(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("calibrate", "Turn a photograph with a colour chart into diffuse albedo");
  command
      ->add_option("PHOTO", options->photo,
                   "A picture that holds a ColorChecker Classic: PNG, JPEG, TIFF or OpenEXR; or a folder of them")
      ->required();
  command->add_option("-o,--output", options->folder, "Folder for the albedo, report.json and profile.json");
  command->add_option("--corners", options->corners,
                      "x,y,x,y,x,y,x,y: corners of the area of patches, in pixels from the upper left of the upright "
                      "picture, next to the "
                      "patches dark skin, bluish green, black and white; without it the chart is searched");
  command
      ->add_option("--model", options->model,
                   fmt::format("auto, the least error on patches left out, or {}", calibrate::modelNames()))
      ->capture_default_str();
  command
      ->add_option(
          "--input", options->input,
          "What the codes are: srgb, as the file says; linear light; auto, whichever leaves clearly less error")
      ->check(CLI::IsMember({"auto", "srgb", "linear"}))
      ->capture_default_str();
  command->add_option("--edition", options->edition, "Edition of the chart, by the pigments' change in November 2014")
      ->check(CLI::IsMember({"before-2014", "after-2014"}))
      ->capture_default_str();
  command->add_option("--reference", options->reference,
                      "A file of the chart's measured colours: 24 lines \"NAME L a b\" under D50");
  command
      ->add_option("--format", options->format,
                   "Format of the albedo: linear OpenEXR, or PNG or TIFF of 16 bits in sRGB")
      ->check(CLI::IsMember({"exr", "png", "tif"}))
      ->capture_default_str();
  command->add_option("--apply", options->apply,
                      "Calibrate by another photograph of the same camera and light: its profile.json, or the "
                      "photograph with the chart itself");
  command->add_option("--parallel", options->parallel,
                      "PHOTO is through a polariser across the light's: the same photograph through one along it. "
                      "Writes the specular light, STEM.specular.exr, too");
  command->add_flag("--flatten", options->flatten,
                    "Estimate how the light falls off over the chart, by its colours, and take that out of the fit");
  command->add_flag("--check", options->check,
                    "Calibrate nothing: tell how much of an albedo lies outside the chart's gamut or is too dark or "
                    "bright for a dielectric, of a picture, a folder, a glTF or OBJ model or a level.toml");
  command
      ->add_option("--allowed", options->allowed,
                   "--check ends with status 3 where more than so many percent of an albedo's texels are so")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  command->add_flag("--force", options->force, "Make photographs of a folder that are up to date, too");
  options->progress.addTo(*command);
  options->threads.addTo(*command, "The result is the same for any number");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run(*options); });
}

}  // namespace welkin::command
