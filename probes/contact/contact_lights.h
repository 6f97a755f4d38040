// SPDX-License-Identifier: Apache-2.0
// The lights that contact factors are fitted to. They are of the level and its sun's path, not of one sky's colours.
#pragma once

#include <optional>
#include <vector>

#include "probes/fit/training_skies.h"
#include "probes/sectors/level_light.h"
#include "sky/model/sky.h"

namespace welkin::contact {

using f64::Number3;

/// A grey sky of horizontal irradiance 1, alone or with the sun.
struct ContactLight {
  std::size_t sky = 0;             ///< of ContactLights::skies()
  std::optional<std::size_t> sun;  ///< of ContactLights::directions()
  double irradiance = 0.0;         ///< of a surface that faces the sun: as strong beside its sky as in the level's own
  double time_h = 0.0;             ///< of the sun; its direction then is that of `sun`
};

/// An even sky, an overcast one, and clear ones with the sun at up to six times of its day. Not the moon: beside a dark
/// sky it would outweigh all else, and factors for it make days worse.
class ContactLights {
 public:
  explicit ContactLights(const model::Sky& sky);

  const std::vector<ContactLight>& light() const { return light_; }
  const fit::TrainingSkies& skies() const { return skies_; }
  const std::vector<Number3>& directions() const { return direction_; }

  /// The probes of a level under each light. The sectors must outlive the result.
  std::vector<sectors::LevelLight> on(const std::vector<sectors::SectorFile>& sectors) const;

 private:
  std::vector<ContactLight> light_;
  std::vector<Number3> direction_;
  fit::TrainingSkies skies_;
};

}  // namespace welkin::contact
