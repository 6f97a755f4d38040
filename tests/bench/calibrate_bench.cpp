// SPDX-License-Identifier: Apache-2.0
// CIEDE2000 left out, one patch at a time, of Welkin's models, OpenCV's ccm and Argyll's colprof on the same patches of
// the same photographs. Each line is one program's setting: the mean of each photograph, then the mean of these.
//   calibrate_bench FOLDER     photographs, of which those without a chart are named and passed over
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>

#include "calibrate/left_out.h"
#include "calibrate/photo.h"
#include "calibrate_peers.h"
#include "sky/base/error.h"

namespace welkin::bench {
namespace {

using calibrate::CalibratedPhoto;
using calibrate::Pair;

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(1, values.size()));
}

std::vector<CodedPatch> codedPatches(const CalibratedPhoto& photo, const calibrate::ReferenceChart& reference) {
  std::vector<CodedPatch> patches;
  for (const std::size_t i : photo.calibration.used) {
    const calibrate::Colour& light = photo.charts[0].patches[i].mean;
    const calibrate::Colour code = photo.linear_codes ? light : calibrate::srgbOfRgb(light);
    patches.push_back({code, reference[i], i >= 3 * calibrate::kColumns});
  }
  return patches;
}

std::optional<double> leftOut(const Peer& peer, const std::vector<CodedPatch>& patches) {
  std::vector<double> differences;
  for (std::size_t out = 0; out < patches.size(); ++out) {
    std::vector<CodedPatch> others = patches;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(out));
    const auto colour = peer.correct(others, patches[out].code);
    if (!colour || !colour->allFinite()) return std::nullopt;
    differences.push_back(calibrate::ciede2000(calibrate::labOfRgb(*colour), calibrate::labOfRgb(patches[out].wanted)));
  }
  return meanOf(differences);
}

struct Table {
  std::vector<std::string> photos;
  std::vector<std::pair<std::string, std::vector<std::optional<double>>>> lines;

  void add(const std::string& name, std::optional<double> value) {
    auto line = std::find_if(lines.begin(), lines.end(), [&](const auto& l) { return l.first == name; });
    if (line == lines.end()) line = lines.insert(lines.end(), {name, {}});
    line->second.resize(photos.size() - 1);
    line->second.push_back(value);
  }

  void print() const {
    for (std::size_t i = 0; i < photos.size(); ++i) fmt::print("{}: {}\n", i + 1, photos[i]);
    fmt::print("{:32}", "mean CIEDE2000 left out");
    for (std::size_t i = 0; i < photos.size(); ++i) fmt::print(" {:>6}", i + 1);
    fmt::print(" {:>6}\n", "mean");
    for (const auto& [name, values] : lines) {
      fmt::print("{:32}", name);
      std::vector<double> known;
      for (const auto& value : values) {
        fmt::print(" {:>6}", value ? fmt::format("{:.2f}", *value) : "-");
        if (value) known.push_back(*value);
      }
      fmt::print(" {:>6}\n", known.size() == photos.size() ? fmt::format("{:.2f}", meanOf(known)) : "-");
    }
  }
};

void measure(const std::filesystem::path& photo, const std::vector<Peer>& peers, Table& table) {
  calibrate::PhotoOptions options;
  options.reference = calibrate::referenceChart(calibrate::Edition::after_2014);
  const CalibratedPhoto result = calibrate::calibratePhoto(photo, options);
  table.photos.push_back(photo.filename().string());
  const std::vector<CodedPatch> patches = codedPatches(result, options.reference);
  table.add("before", meanOf(result.calibration.before));
  table.add("Welkin auto", meanOf(result.calibration.errors().left_out));
  for (const calibrate::ModelErrors& tried : result.calibration.tried)
    table.add(fmt::format("Welkin {}", tried.kind->name), meanOf(tried.left_out));
  for (const Peer& peer : peers) table.add(peer.name, leftOut(peer, patches));
}

int run(const std::filesystem::path& folder) {
  std::vector<Peer> peers = openCvPeers();
  const std::vector<Peer> argyll = argyllPeers();
  if (argyll.empty()) fmt::print("Argyll's colprof and xicclu are not on PATH: they are left out\n");
  peers.insert(peers.end(), argyll.begin(), argyll.end());
  std::vector<std::filesystem::path> photos;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".jpg" || ending == ".png" || ending == ".tif" || ending == ".exr") photos.push_back(entry.path());
  }
  std::sort(photos.begin(), photos.end());
  Table table;
  for (const auto& photo : photos) try {
      measure(photo, peers, table);
    } catch (const base::Error& e) {
      fmt::print("passed over: {}\n", e.what());
    }
  table.print();
  return table.photos.empty() ? 1 : 0;
}

}  // namespace
}  // namespace welkin::bench

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "calibrate_bench FOLDER\n");
    return 1;
  }
  try {
    return welkin::bench::run(argv[1]);
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
  }
}
