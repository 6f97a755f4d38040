// SPDX-License-Identifier: Apache-2.0
#include "gloss/report.h"

#include <cmath>

#include "sky/base/message.h"

namespace welkin::gloss {
namespace {

double rounded(double value, double digits) {
  return std::round(value * digits) / digits;
}

nlohmann::ordered_json errorJson(const BlockError& error) {
  return {{"y_rms", rounded(error.y_rms, 1e6)},
          {"normal_rms_deg", rounded(error.angle_rms, 1e4)},
          {"normal_most_deg", rounded(error.angle_most, 1e4)},
          {"gloss_rms", rounded(error.gloss_rms, 1e6)}};
}

nlohmann::ordered_json blocksJson(const BlockReport& report) {
  if (!report.bc3) return {{"format", "bc5"}, {"error", errorJson(report.apart)}};
  return {{"format", "bc3"},
          {"red", report.holds_map ? "map" : "average"},
          {"with_map", errorJson(report.with_map)},
          {"with_average", errorJson(report.with_average)}};
}

}  // namespace

nlohmann::ordered_json reportOf(const Result& result) {
  nlohmann::ordered_json report;
  report["normal"] = base::oneLine(result.normal_name);
  report["gloss"] = base::oneLine(result.gloss_name);
  report["coding"] = nameOf(result.coding);
  report["mean_stored_length"] = rounded(result.mean_stored_length, 1e6);
  report["green"] = {{"correlation", rounded(result.green.correlation, 1e4)},
                     {"certainty", rounded(result.green.certainty, 1e4)},
                     {"direction", result.green.points_up()     ? "up"
                                   : result.green.points_down() ? "down"
                                                                : "unknown"}};
  report["average_toksvig"] = {{"gloss", rounded(result.average.gloss, 1e6)},
                               {"factor", rounded(result.average.factor, 1e6)}};
  if (result.blocks) report["blocks"] = blocksJson(*result.blocks);
  for (const Mip& mip : result.mips)
    report["mips"].push_back({{"width", mip.width},
                              {"height", mip.height},
                              {"mean_gloss", rounded(mip.mean_gloss, 1e6)},
                              {"mean_toksvig_factor", rounded(mip.mean_factor, 1e6)},
                              {"least_normal_length", rounded(mip.least_length, 1e6)}});
  report["warnings"] = nlohmann::json::array();
  for (const Warning& w : result.warnings)
    report["warnings"].push_back({{"id", w.id}, {"count", w.count}, {"message", base::oneLine(w.message)}});
  for (const WrittenFile& file : result.files)
    report["files"].push_back({{"name", base::oneLine(file.name)}, {"bytes", file.bytes}, {"xxh3_128", file.xxh3_128}});
  return report;
}

}  // namespace welkin::gloss
