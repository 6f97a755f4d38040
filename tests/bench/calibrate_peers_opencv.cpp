// SPDX-License-Identifier: Apache-2.0
#include <opencv2/core.hpp>
#include <opencv2/mcc.hpp>

#include "calibrate_peers.h"

namespace welkin::bench {
namespace {

using calibrate::Colour;

struct OpenCvSetting {
  const char* name;
  cv::ccm::CCM_TYPE type;
  cv::ccm::LINEAR_TYPE linear;
  int degree;
};

constexpr OpenCvSetting kOpenCvSettings[] = {
    {"OpenCV 3x3 gamma", cv::ccm::CCM_3x3, cv::ccm::LINEARIZATION_GAMMA, 0},
    {"OpenCV 4x3 gamma", cv::ccm::CCM_4x3, cv::ccm::LINEARIZATION_GAMMA, 0},
    {"OpenCV 3x3 colour polynomial", cv::ccm::CCM_3x3, cv::ccm::LINEARIZATION_COLORPOLYFIT, 3},
    {"OpenCV 4x3 colour polynomial", cv::ccm::CCM_4x3, cv::ccm::LINEARIZATION_COLORPOLYFIT, 3},
    {"OpenCV 3x3 grey logarithm", cv::ccm::CCM_3x3, cv::ccm::LINEARIZATION_GRAYLOGPOLYFIT, 3},
    {"OpenCV 4x3 grey logarithm", cv::ccm::CCM_4x3, cv::ccm::LINEARIZATION_GRAYLOGPOLYFIT, 3},
};

cv::Vec3d vectorOf(const Colour& c) {
  return {c.x(), c.y(), c.z()};
}

std::optional<Colour> openCvCorrected(const OpenCvSetting& setting, std::span<const CodedPatch> patches,
                                      const Colour& code) {
  const int count = static_cast<int>(patches.size());
  cv::Mat codes(count, 1, CV_64FC3), wanted(count, 1, CV_64FC3), coloured(count, 1, CV_8U);
  for (int i = 0; i < count; ++i) {
    const CodedPatch& patch = patches[static_cast<std::size_t>(i)];
    codes.at<cv::Vec3d>(i) = vectorOf(patch.code);
    wanted.at<cv::Vec3d>(i) = vectorOf(calibrate::labOfRgb(patch.wanted));
    coloured.at<std::uint8_t>(i) = patch.is_grey ? 0 : 255;
  }
  try {
    cv::ccm::ColorCorrectionModel model(codes, wanted, cv::ccm::COLOR_SPACE_Lab_D50_2, coloured);
    model.setColorSpace(cv::ccm::COLOR_SPACE_sRGB);
    model.setCCM_TYPE(setting.type);
    model.setDistance(cv::ccm::DISTANCE_CIE2000);
    model.setLinear(setting.linear);
    model.setLinearGamma(2.2);
    model.setLinearDegree(setting.degree);
    model.run();
    const cv::Mat one(1, 1, CV_64FC3, cv::Scalar(code.x(), code.y(), code.z()));
    const cv::Mat light = model.infer(one, true);
    const cv::Vec3d& c = light.at<cv::Vec3d>(0);
    return Colour(c[0], c[1], c[2]);
  } catch (const cv::Exception&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<Peer> openCvPeers() {
  cv::setNumThreads(1);
  std::vector<Peer> peers;
  for (const OpenCvSetting& setting : kOpenCvSettings)
    peers.push_back({setting.name, [&setting](std::span<const CodedPatch> patches, const Colour& code) {
                       return openCvCorrected(setting, patches, code);
                     }});
  return peers;
}

}  // namespace welkin::bench
