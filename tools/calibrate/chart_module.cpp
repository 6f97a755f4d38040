// SPDX-License-Identifier: Apache-2.0
#include "calibrate/chart_module.h"

#include <fmt/format.h>

#include <opencv2/core.hpp>
#include <opencv2/mcc.hpp>

#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::calibrate {
namespace {

constexpr int kMostCharts = 4;

std::vector<Candidate> detect(int width, int height, const std::uint8_t* bgr) {
  try {
    cv::setNumThreads(1);
    cv::theRNG().state = 1;                                                         // its clustering draws numbers
    const cv::Mat picture(height, width, CV_8UC3, const_cast<std::uint8_t*>(bgr));  // only read
    const auto detector = cv::mcc::CCheckerDetector::create();
    std::vector<Candidate> candidates;
    if (!detector->process(picture.clone(), cv::mcc::MCC24, kMostCharts)) return candidates;
    for (const auto& checker : detector->getListColorChecker()) {
      const std::vector<cv::Point2f> box = checker->getBox();
      if (box.size() != 4) continue;
      Candidate candidate;
      candidate.cost = double{checker->getCost()};
      for (std::size_t i = 0; i < 4; ++i) candidate.corners[i] = Point(double{box[i].x}, double{box[i].y});
      candidates.push_back(candidate);
    }
    return candidates;
  } catch (const cv::Exception& e) {
    throw base::Error(base::ExitStatus::internal, fmt::format("OpenCV's chart detector: {}", base::oneLine(e.what())));
  }
}

constexpr ChartModule kModule{detect};

}  // namespace
}  // namespace welkin::calibrate

extern "C" __attribute__((visibility("default"))) const welkin::calibrate::ChartModule* welkinChartModule() {
  return &welkin::calibrate::kModule;
}
