// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <Eigen/LU>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "calibrate_peers.h"
#include "tests/folder.h"

namespace welkin::bench {
namespace {

using calibrate::Colour;

struct ArgyllSetting {
  const char* name;
  const char* algorithm;
};

constexpr ArgyllSetting kArgyllSettings[] = {
    {"colprof matrix", "m"}, {"colprof gamma and matrix", "g"}, {"colprof shaper and matrix", "s"}};

/// XYZ under D50, in percent, by way of L*a*b*.
Colour xyzD50(const Colour& rgb) {
  const Colour lab = calibrate::labOfRgb(rgb);
  const double y = (lab.x() + 16.0) / 116.0;
  const auto inverse = [](double f) { return f > 6.0 / 29.0 ? f * f * f : 3.0 * 36.0 / 841.0 * (f - 4.0 / 29.0); };
  return 100.0 * Colour(0.9642 * inverse(y + lab.y() / 500.0), inverse(y), 0.8249 * inverse(y - lab.z() / 200.0));
}

/// Argyll's table of device values and colours (CGATS).
std::string ti3Of(std::span<const CodedPatch> patches) {
  std::string text =
      "CTI3\n\nDESCRIPTOR \"patches\"\nORIGINATOR \"bench\"\nDEVICE_CLASS \"INPUT\"\nCOLOR_REP \"XYZ_RGB\"\n\n"
      "NUMBER_OF_FIELDS 7\nBEGIN_DATA_FORMAT\nSAMPLE_ID XYZ_X XYZ_Y XYZ_Z RGB_R RGB_G RGB_B\nEND_DATA_FORMAT\n\n";
  text += fmt::format("NUMBER_OF_SETS {}\nBEGIN_DATA\n", patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Colour xyz = xyzD50(patches[i].wanted), code = 100.0 * patches[i].code;
    text += fmt::format("{} {:.6f} {:.6f} {:.6f} {:.6f} {:.6f} {:.6f}\n", i + 1, xyz.x(), xyz.y(), xyz.z(), code.x(),
                        code.y(), code.z());
  }
  return text + "END_DATA\n";
}

std::string printedBy(const std::string& command) {
  std::string text;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"), &::pclose);
  if (!pipe) return text;
  std::array<char, 4096> part{};
  while (std::fgets(part.data(), part.size(), pipe.get()) != nullptr) text += part.data();
  return text;
}

std::optional<Colour> argyllCorrected(const ArgyllSetting& setting, std::span<const CodedPatch> patches,
                                      const Colour& code) {
  const tests::Folder folder;
  folder.write("chart.ti3", ti3Of(patches));
  const std::string base = folder / "chart";
  printedBy(fmt::format("colprof -q m -u -a {} '{}' 2>&1", setting.algorithm, base));
  const std::string profile = std::filesystem::exists(base + ".icc") ? base + ".icc" : base + ".icm";
  const std::string text = printedBy(fmt::format("echo {:.6f} {:.6f} {:.6f} | xicclu -v0 -ff -ia -pl '{}' 2>/dev/null",
                                                 code.x(), code.y(), code.z(), profile));
  Colour lab;
  // xicclu prints the code, the name of the lookup and the colour, or with -v0 the colour alone.
  if (std::sscanf(text.c_str(), "%lf %lf %lf", &lab.x(), &lab.y(), &lab.z()) != 3) return std::nullopt;
  return calibrate::rgbOfLab(lab);
}

}  // namespace

std::vector<Peer> argyllPeers() {
  std::vector<Peer> peers;
  if (printedBy("command -v colprof && command -v xicclu").empty()) return peers;
  for (const ArgyllSetting& setting : kArgyllSettings)
    peers.push_back({setting.name, [&setting](std::span<const CodedPatch> patches, const Colour& code) {
                       return argyllCorrected(setting, patches, code);
                     }});
  return peers;
}

}  // namespace welkin::bench
