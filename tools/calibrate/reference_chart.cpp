// SPDX-License-Identifier: Apache-2.0
#include "calibrate/reference_chart.h"

#include <fmt/format.h>

#include <sstream>

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::calibrate {
namespace {

struct Printed {
  const char* name;
  double before[3];
  double after[3];
};

constexpr std::array<Printed, kPatches> kPrinted = {{
    {"dark skin", {37.986, 13.555, 14.059}, {37.54, 14.37, 14.92}},
    {"light skin", {65.711, 18.130, 17.810}, {64.66, 19.27, 17.50}},
    {"blue sky", {49.927, -4.880, -21.905}, {49.32, -3.82, -22.54}},
    {"foliage", {43.139, -13.095, 21.905}, {43.46, -12.74, 22.72}},
    {"blue flower", {55.112, 8.844, -25.399}, {54.94, 9.61, -24.79}},
    {"bluish green", {70.719, -33.397, -0.199}, {70.48, -32.26, -0.37}},
    {"orange", {62.661, 36.067, 57.096}, {62.73, 35.83, 56.50}},
    {"purplish blue", {40.020, 10.410, -45.964}, {39.43, 10.75, -45.17}},
    {"moderate red", {51.124, 48.239, 16.248}, {50.57, 48.64, 16.67}},
    {"purple", {30.325, 22.976, -21.587}, {30.10, 22.54, -20.87}},
    {"yellow green", {72.532, -23.709, 57.255}, {71.77, -24.13, 58.19}},
    {"orange yellow", {71.941, 19.363, 67.857}, {71.51, 18.24, 67.37}},
    {"blue", {28.778, 14.179, -50.297}, {28.37, 15.42, -49.80}},
    {"green", {55.261, -38.342, 31.370}, {54.38, -39.72, 32.27}},
    {"red", {42.101, 53.378, 28.190}, {42.43, 51.05, 28.62}},
    {"yellow", {81.733, 4.039, 79.819}, {81.80, 2.67, 80.41}},
    {"magenta", {51.935, 49.986, -14.574}, {50.63, 51.28, -14.12}},
    {"cyan", {51.038, -28.631, -28.638}, {49.57, -29.71, -28.32}},
    {"white 9.5", {96.539, -0.425, 1.186}, {95.19, -1.03, 2.93}},
    {"neutral 8", {81.257, -0.638, -0.335}, {81.29, -0.57, 0.44}},
    {"neutral 6.5", {66.766, -0.734, -0.504}, {66.89, -0.75, -0.06}},
    {"neutral 5", {50.867, -0.153, -0.270}, {50.76, -0.13, 0.14}},
    {"neutral 3.5", {35.656, -0.421, -1.231}, {35.63, -0.46, -0.48}},
    {"black 2", {20.461, -0.079, -0.973}, {20.64, 0.07, -0.46}},
}};

[[noreturn]] void refuseLine(const std::string& name, std::size_t line, const std::string& why) {
  throw base::Error(
      base::ExitStatus::content,
      fmt::format("{}: line {}: {}; {} lines of \"NAME L a b\" are allowed, L* 0 to 100, a* and b* -128 to "
                  "128, under D50",
                  name, line, why, kPatches));
}

}  // namespace

const char* patchName(std::size_t patch) {
  return kPrinted[patch].name;
}

ReferenceChart referenceChart(Edition edition) {
  ReferenceChart chart;
  for (std::size_t i = 0; i < kPatches; ++i) {
    const auto& lab = edition == Edition::before_2014 ? kPrinted[i].before : kPrinted[i].after;
    chart[i] = rgbOfLab({lab[0], lab[1], lab[2]});
  }
  return chart;
}

ReferenceChart readReferenceChart(const std::filesystem::path& path) {
  constexpr std::size_t kMostBytes = 65536;
  const std::string name = path.string();
  const std::vector<std::byte> bytes = base::readFile(path, kMostBytes);
  std::istringstream text(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  ReferenceChart chart;
  std::size_t patch = 0, number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
    if (patch == kPatches) refuseLine(name, number, "a patch too many");
    std::istringstream fields(line);
    std::vector<std::string> word;
    for (std::string w; fields >> w;) word.push_back(w);
    if (word.size() < 4) refuseLine(name, number, fmt::format("{} fields", word.size()));
    Colour lab;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string& field = word[word.size() - 3 + i];
      std::istringstream one(field);
      one.imbue(std::locale::classic());
      double value = 0.0;
      const double least = i == 0 ? 0.0 : -128.0, most = i == 0 ? 100.0 : 128.0;
      if (!(one >> value) || !one.eof() || !(value >= least && value <= most))
        refuseLine(name, number, fmt::format("\"{}\" is no {}", field, i == 0 ? "L*" : i == 1 ? "a*" : "b*"));
      lab[static_cast<int>(i)] = value;
    }
    chart[patch++] = rgbOfLab(lab);
  }
  if (patch != kPatches) refuseLine(name, number, fmt::format("{} patches", patch));
  return chart;
}

}  // namespace welkin::calibrate
