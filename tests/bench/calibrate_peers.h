// SPDX-License-Identifier: Apache-2.0
// Other programs' corrections of the same patches of a chart: OpenCV's ccm and Argyll's colprof.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibrate/model.h"
#include "calibrate/reference_chart.h"

namespace welkin::bench {

/// A patch as a peer takes it.
struct CodedPatch {
  calibrate::Colour code;    ///< encoded sRGB as photographed, in [0, 1]
  calibrate::Colour wanted;  ///< linear Rec. 709
  bool is_grey = false;      ///< one of the chart's last row
};

/// A correction: its name, and its fit to some patches with what it makes of a code, as linear Rec. 709. None where the
/// peer refuses or is not there.
struct Peer {
  std::string name;
  std::function<std::optional<calibrate::Colour>(std::span<const CodedPatch> patches, const calibrate::Colour& code)>
      correct;
};

/// ColorCorrectionModel of OpenCV 4 with the settings that its documentation offers, CIEDE2000 as its distance.
std::vector<Peer> openCvPeers();

/// colprof of Argyll with its three matrix models, read by xicclu. Both must be on PATH. Its tables have far more
/// numbers than a chart has patches, and a fit of one takes half a minute.
std::vector<Peer> argyllPeers();

}  // namespace welkin::bench
