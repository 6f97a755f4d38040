// SPDX-License-Identifier: Apache-2.0
// Diffuse and specular light apart, by two photographs in polarised light. A surface keeps the polarisation of light
// that it reflects as a mirror, and scatters the rest without any. So a filter across the light's polarisation passes
// half of the diffuse light D, and one along it passes D/2 and all of the specular light S (W.-C. Ma and others, "Rapid
// Acquisition of Specular and Diffuse Normal Maps from Polarized Spherical Gradient Illumination", 2007, section 3):
// with the crossed photograph X and the parallel one P, D is 2 X and S is P - X.
#pragma once

#include <string>

#include "calibrate/model.h"
#include "sky/image/image.h"

namespace welkin::calibrate {

struct Specular {
  image::Image image;  ///< linear Rec. 709; 1 is the light of a white diffuse surface. No channel is below 0
  double below = 0.0;  ///< part of the texels where the parallel photograph is darker than the crossed one by green
};

/// A part below that is worth a warning: noise makes some of it where nothing is specular, up to a half.
inline constexpr double kMuchBelow = 0.6;

/// Specular light in units of albedo. `model` gives the albedo of a texel from the crossed photograph. So 2 X has the
/// albedo model(X), D + S, which is X + P, has model((X + P) / 2), and the specular part is the difference of both.
/// Both pictures are linear, of the same size, exposure and place of the camera. Throws Error(content) naming
/// `parallel_name` for another size.
Specular specularOf(const image::Image& crossed, const image::Image& parallel, const std::string& parallel_name,
                    const Model& model);

}  // namespace welkin::calibrate
