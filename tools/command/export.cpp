// SPDX-License-Identifier: Apache-2.0
// welkin export: writes maps of a baked sky in the formats and the orientation that an engine reads.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "baked/welkin_file.h"
#include "command/arguments.h"
#include "command/commands.h"
#include "command/shared_options.h"
#include "maps/prefiltered.h"
#include "maps/write_maps.h"
#include "sky/bake/sky_outputs.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::command {
namespace {

constexpr int kSizeWithoutCubemaps = 256;

struct Options {
  std::string path, to, target, format, output;
  std::vector<std::string> times;
  int size = 0;
  bool mips = false, prefilter = false;
  ThreadsOption threads;
};

base::Error usage(const std::string& message) {
  return base::Error(base::ExitStatus::usage, message);
}

void say(const std::string& message) {
  std::fputs(fmt::format("welkin: {}\n", message).c_str(), stderr);  // fmt::print throws when stderr is full
}

/// --to, --format and --target.
maps::Request requestOf(const Options& options) {
  maps::Request request;
  request.mips = options.mips;
  request.prefilter = options.prefilter;
  request.container = options.to == "ktx2"    ? maps::Container::ktx2
                      : options.to == "dds"   ? maps::Container::dds
                      : options.to == "faces" ? maps::Container::faces
                                              : maps::Container::latlong;
  if (!options.target.empty() && !(request.engine = maps::orientationOf(options.target)))
    throw usage(fmt::format("--target: \"{}\" is not an engine; those are {}", options.target, maps::engineNames()));
  const bool cube = maps::holdsTexels(request.container);
  if (request.mips && !cube) throw usage(fmt::format("--mips: {} has no mips; ktx2 and dds have", options.to));
  if (request.mips && request.prefilter) throw usage("--mips and --prefilter: mips are one or the other, not both");
  if (request.prefilter && options.size != 0 && (options.size < 2 || options.size > maps::kLargestPrefiltered))
    throw usage(
        fmt::format("--size: a prefiltered chain has 2 to {} texels, not {}: its sharpest lobe is 1.3 degrees wide",
                    maps::kLargestPrefiltered, options.size));
  if (cube) {
    const auto format = maps::formatOf(options.format.empty() ? "rgba16f" : options.format);
    if (!format)
      throw usage(fmt::format("--format: {} takes rgba16f, rgb9e5 or bc6h, not \"{}\"", options.to, options.format));
    request.format = *format;
  } else {
    const std::string format = !options.format.empty() ? options.format : options.to == "faces" ? "exr" : "hdr";
    if (format != "exr" && format != "hdr")
      throw usage(fmt::format("--format: {} takes exr or hdr, not \"{}\"", options.to, options.format));
    request.picture = format == "exr" ? maps::PictureFormat::exr : maps::PictureFormat::hdr;
  }
  return request;
}

/// Hours of --time. Two that give files of one name are refused.
std::vector<double> timesOf(const Options& options, const Sky& sky) {
  std::vector<double> times;
  std::set<std::string> names;
  for (const std::string& text : options.times) {
    WelkinSkySample sample{};
    sky.sample(parseTime(text), sample);
    if (!names.insert(bake::cubemapName(sample.time_h)).second)
      throw usage(fmt::format("--time: {} is within the same millisecond as another one", text));
    times.push_back(sample.time_h);
  }
  return times;
}

/// --size, or the size of the file's cubemaps.
int sizeOf(const Options& options, const maps::Request& request, const std::string& file, const Sky& sky) {
  int size = options.size;
  const int largest = request.prefilter ? maps::kLargestPrefiltered : maps::kLargestFace;
  if (size == 0) size = std::min(static_cast<int>(sky.info().cubemap_size), largest);
  if (size == 0) {
    size = kSizeWithoutCubemaps;
    say(fmt::format("{}: no cubemaps in it; faces get {} texels, from the formulas", base::oneLine(file), size));
  }
  if (request.prefilter) size = std::max(size, 2);
  if (maps::holdsTexels(request.container) && request.format == maps::Format::bc6h && size % 4 != 0)
    throw usage(fmt::format("--size: faces of {} texels have no whole blocks; bc6h takes multiples of 4", size));
  return size;
}

void runExport(const Options& options) {
  for (const std::string& time : options.times) parseTime(time);
  maps::Request request = requestOf(options);
  const auto limit = options.threads.limit();
  const std::string file = baked::skyFileOf(options.path);
  const Sky sky = baked::openSky(file);
  const std::vector<double> times = timesOf(options, sky);
  request.size = sizeOf(options, request, file, sky);
  const std::filesystem::path beside = std::filesystem::path(file).parent_path() / "export";
  const std::filesystem::path folder = options.output.empty() ? beside : std::filesystem::path(options.output);
  base::makeFolder(folder);
  for (const double time_h : times) {
    WelkinSkySample sample{};
    sky.sample(time_h, sample);
    for (const maps::WrittenFile& written : maps::writeMaps(sky.get(), sample, request, folder)) {
      const std::string path = base::oneLine(written.path.string());
      fmt::print("{} {} bytes{}\n", path, written.bytes,
                 written.error ? fmt::format(", error {:.2g} %", 100.0 * *written.error) : std::string());
      if (written.saturated > 0)
        say(fmt::format("warning: {}: {} components are past the format's largest number and became that", path,
                        written.saturated));
    }
  }
}

}  // namespace

void addExport(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("export", "Write a baked sky as the cubemaps and latlongs that engines read");
  command->add_option("PATH", options->path, "Folder of a bake, or a .welkin file")->required();
  command
      ->add_option("--to", options->to,
                   "ktx2, dds: a cubemap in one file; faces: six pictures; hdr: a latlong, four by two faces large")
      ->required()
      ->check(CLI::IsMember({"ktx2", "dds", "faces", "hdr"}));
  command->add_option("--time", options->times, "Hours; several give the files of each")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--target", options->target,
                      maps::engineNames() + ": the orientation of that engine (docs/export.md); default: Welkin's own");
  command->add_option("--format", options->format,
                      "ktx2, dds: rgba16f (the default), rgb9e5, bc6h; faces, hdr: exr (the default of faces), hdr");
  command
      ->add_option("--size", options->size, "Texels along a face's edge; default: that of the file's cubemaps, or 256")
      ->check(CLI::Range(1, maps::kLargestFace));
  command->add_flag("--mips", options->mips, "With box-filtered mips down to one texel: ktx2 and dds");
  command->add_flag("--prefilter", options->prefilter,
                    "Filtered for rough surfaces: mip k of n for gloss 1 - k/(n - 1); pictures are one a mip");
  command->add_option("-o,--output", options->output, "Folder to write to; default: export, beside the .welkin file");
  options->threads.addTo(*command, "The files do not depend on it");
  command->callback([options] { runExport(*options); });
}

}  // namespace welkin::command
