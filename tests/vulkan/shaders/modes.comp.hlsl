// SPDX-License-Identifier: Apache-2.0
// modes.comp in HLSL, through the include that a build translates. Map and sampler share the binding of a combined one.
#define WELKIN_REGISTER_CONSTANTS b0, space1
#define WELKIN_REGISTER_MODES t6, space1
#define WELKIN_REGISTER_MODES_SAMPLER s6, space1
#if WELKIN_MODES == 4
#include "welkin/modes_4.hlsl"
#elif WELKIN_MODES == 8
#include "welkin/modes_8.hlsl"
#else
#include "welkin/modes_12.hlsl"
#endif

StructuredBuffer<float4> normals : register(t0);
RWStructuredBuffer<float4> results : register(u1);

[numthreads(64, 1, 1)] void main(uint3 id : SV_DispatchThreadID) {
  uint count, stride;
  normals.GetDimensions(count, stride);
  if (id.x >= count) return;
  float3 n = normals[id.x].xyz;
  results[2 * id.x] = float4(welkinModesIrradiance(n), 0.0);
  results[2 * id.x + 1] = float4(welkinModesIrradianceOverPi(n), 0.0);
}
