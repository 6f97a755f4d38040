// SPDX-License-Identifier: Apache-2.0
// Binding numbers inside the descriptor set that welkin_vulkan.h makes; C++ and GLSL. A shader that uses that set
// defines WELKIN_SET and includes this file. A shader with its own layout defines all of these macros itself.
#ifndef WELKIN_SKY_BINDINGS_H
#define WELKIN_SKY_BINDINGS_H

#define WELKIN_BINDING_CONSTANTS 0       // uniform buffer, WelkinSkyConstants
#define WELKIN_BINDING_GRADIENT_SUN 1    // sampler2D, RGBA32F, fetched, never filtered
#define WELKIN_BINDING_GRADIENT_ANTI 2   // sampler2D, RGBA32F, fetched, never filtered
#define WELKIN_BINDING_CUBEMAP_FIRST 3   // samplerCube, linear; its format is the file's, WelkinCubemapFormat:
#define WELKIN_BINDING_CUBEMAP_SECOND 4  // RGBA16F, RGB9E5 or B10G11R11, which all read as RGB
#define WELKIN_BINDING_STARS 5           // sampler2D, sRGB, linear
#define WELKIN_BINDING_MODES 6           // sampler2DArray, RGBA16F, linear, clamped

#endif
