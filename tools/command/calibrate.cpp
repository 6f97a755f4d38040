// SPDX-License-Identifier: Apache-2.0
// welkin calibrate: albedo from a photograph that holds a colour chart.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include "calibrate/albedo_file.h"
#include "calibrate/photo.h"
#include "calibrate/report.h"
#include "command/arguments.h"
#include "command/commands.h"
#include "command/shared_options.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::command {
namespace {

struct Options {
  std::string photo, folder, corners, reference;
  std::string edition = "after-2014", input = "auto", model = "auto", format = "exr";
  ThreadsOption threads;
  bool json = false;
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
  fmt::print("CIEDE2000     mean     95%   worst\n");
  printLine("before", c.before);
  printLine("fit", c.errors().fit);
  printLine("left out", c.errors().left_out);
}

/// The output, which is none of the inputs.
std::filesystem::path albedoPath(const Options& options) {
  const std::string stem = std::filesystem::path(options.photo).stem().string();
  std::filesystem::path path = std::filesystem::path(options.folder) / fmt::format("{}.{}", stem, options.format);
  base::requireNoInput(path, std::array<std::filesystem::path, 2>{options.photo, options.reference});
  return path;
}

void run(const Options& options) {
  const calibrate::PhotoOptions photo_options = photoOptions(options);
  const std::filesystem::path albedo = albedoPath(options);
  const auto limit = options.threads.limit();
  const calibrate::CalibratedPhoto photo = calibrate::calibratePhoto(options.photo, photo_options);
  for (const std::string& warning : photo.warnings)
    std::fputs(fmt::format("welkin: warning: {}: {}\n", base::oneLine(options.photo), base::oneLine(warning)).c_str(),
               stderr);
  base::makeFolder(albedo.parent_path());
  calibrate::writeAlbedo(albedo, calibrate::albedoOf(photo.image, photo.calibration.model));
  nlohmann::ordered_json report = {{"photo", base::oneLine(std::filesystem::path(options.photo).filename().string())},
                                   {"albedo", base::oneLine(albedo.filename().string())}};
  report.update(calibrate::reportJson(photo, photo_options.reference));
  base::writeFile(albedo.parent_path() / "report.json", report.dump(2) + "\n");
  if (options.json)
    fmt::print("{}\n", calibrate::summaryJson(photo).dump(2));
  else
    print(photo);
}

}  // namespace

void addCalibrate(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("calibrate", "Turn a photograph with a colour chart into diffuse albedo");
  command
      ->add_option("PHOTO", options->photo, "A picture that holds a ColorChecker Classic: PNG, JPEG, TIFF or OpenEXR")
      ->required();
  command->add_option("-o,--output", options->folder, "Folder for the albedo and report.json")->required();
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
  command->add_option("--format", options->format, "Format of the albedo: linear OpenEXR, or PNG of 16 bits in sRGB")
      ->check(CLI::IsMember({"exr", "png"}))
      ->capture_default_str();
  options->threads.addTo(*command, "The result is the same for any number");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { run(*options); });
}

}  // namespace welkin::command
