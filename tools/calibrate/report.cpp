// SPDX-License-Identifier: Apache-2.0
#include "calibrate/report.h"

#include <algorithm>
#include <cmath>

#include "sky/base/message.h"

namespace welkin::calibrate {
namespace {

using Json = nlohmann::ordered_json;

Json listOf(const Colour& c) {
  return {c[0], c[1], c[2]};
}

Json summaryOfJson(const std::vector<double>& differences) {
  const DifferenceSummary s = summaryOf(differences);
  return {{"mean", s.mean}, {"p95", s.p95}, {"worst", s.worst}};
}

Json chartJson(const FoundChart& chart) {
  Json corners = Json::array();
  for (const Point& p : chart.place.corners()) corners.push_back({p.x(), p.y()});
  return {{"corners", corners}, {"type", "ColorChecker Classic 24"}, {"confidence", chart.confidence}};
}

Json differencesJson(const CalibratedPhoto& photo) {
  const ModelErrors& errors = photo.calibration.errors();
  return {{"before", summaryOfJson(photo.calibration.before)},
          {"fit", summaryOfJson(errors.fit)},
          {"left_out", summaryOfJson(errors.left_out)}};
}

Json patchJson(const CalibratedPhoto& photo, const ReferenceChart& reference, std::size_t i) {
  const Patch& patch = photo.charts[0].patches[i];
  const Calibration& calibration = photo.calibration;
  const auto found = std::find(calibration.used.begin(), calibration.used.end(), i);
  Json json = {{"name", patchName(i)},
               {"measured", listOf(patch.mean)},
               {"spread", listOf(patch.spread)},
               {"uneven", patch.uneven},
               {"clipped", patch.clipped},
               {"wanted", listOf(reference[i])},
               {"calibrated", listOf(calibration.model(patch.mean))},
               {"used", found != calibration.used.end()}};
  if (found != calibration.used.end()) {
    const auto k = static_cast<std::size_t>(found - calibration.used.begin());
    json["de2000"] = {{"before", calibration.before[k]},
                      {"fit", calibration.errors().fit[k]},
                      {"left_out", calibration.errors().left_out[k]}};
  }
  return json;
}

}  // namespace

Json chartErrorJson(const ChartError& error) {
  Json json = chartJson(error.chart);
  json["de2000"] = {{"before", summaryOfJson(error.before)}, {"after", summaryOfJson(error.after)}};
  return json;
}

Json summaryJson(const CalibratedPhoto& photo) {
  Json charts = Json::array();
  charts.push_back(chartJson(photo.charts[0]));
  for (const ChartError& other : photo.others) charts.push_back(chartErrorJson(other));
  return {{"charts", charts},
          {"model", photo.calibration.model.kind->name},
          {"rss", photo.calibration.rss_srgb},
          {"de2000", differencesJson(photo)}};
}

Json reportJson(const CalibratedPhoto& photo, const ReferenceChart& reference) {
  Json json = summaryJson(photo);
  const Calibration& calibration = photo.calibration;
  json["rss_space"] = "encoded sRGB in [0, 1], over used patches and channels";
  json["rss_xyY"] = calibration.rss_xyY;
  json["input"] = photo.linear_codes ? "linear" : "srgb";
  if (photo.light)
    json["light"] = {{"right_by_left", std::exp(photo.light->along)}, {"bottom_by_top", std::exp(photo.light->down)}};
  for (const ModelErrors& tried : calibration.tried) {
    Json model = {
        {"model", tried.kind->name}, {"fit", summaryOfJson(tried.fit)}, {"left_out", summaryOfJson(tried.left_out)}};
    model["row_left_out"] = tried.row_out.empty() ? Json() : summaryOfJson(tried.row_out);
    json["models"].push_back(std::move(model));
  }
  for (std::size_t i = 0; i < kPatches; ++i) json["patches"].push_back(patchJson(photo, reference, i));
  json["warnings"] = Json::array();
  for (const std::string& warning : photo.warnings) json["warnings"].push_back(base::oneLine(warning));
  return json;
}

}  // namespace welkin::calibrate
