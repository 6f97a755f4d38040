// SPDX-License-Identifier: Apache-2.0
// three.js' own functions, lit by the code of docs/engines.md, against this library's irradiance; the orientation of its
// cubemaps and latlongs.   node three_test.mjs VALUES    VALUES: the JSON of three_values
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { ClampToEdgeWrapping, CubeTexture, LinearSRGBColorSpace, Scene, ShaderChunk, SphericalHarmonics3, Vector3 } from 'three';
import { LightProbeGenerator } from 'three/addons/lights/LightProbeGenerator.js';
import { facesForThree, latlongForThree, lightScene } from './three_code.mjs';

// three.js has constants of six digits: 1e-6 of each of nine terms.
const SIX_DIGITS = 1e-5;
const samples = JSON.parse(readFileSync(process.argv[2]));
assert(samples.length >= 3);

for (const sky of samples) {
  const { probe, sun } = lightScene(new Scene(), sky);
  let largest = 0, sum = 0;
  for (const [normal, expected] of sky.irradiance) {
    const e = probe.sh.getIrradianceAt(new Vector3(...normal), new Vector3()).toArray();
    e.forEach((value, c) => {
      largest = Math.max(largest, Math.abs(Math.max(value, 0) - expected[c]));
      sum += expected[c];
    });
  }
  const error = largest / (sum / (3 * sky.irradiance.length));
  console.log(`LightProbe, ${sky.name}: ${error.toExponential(1)}`);
  assert(error < SIX_DIGITS, `${sky.name}: ${error}`);
  assert.equal(probe.intensity * sun.intensity, 1);
  sun.color.toArray().forEach((value, c) => assert(Math.abs(value - sky.sun.normal_irradiance[c]) < 1e-6));
  sun.position.toArray().forEach((value, c) => assert(Math.abs(value - sky.sun.direction[c]) < 1e-6));
}
// A white surface shows E/pi.
assert.match(ShaderChunk.common, /return RECIPROCAL_PI \* diffuseColor;/);

// A sky within [0, 1] with all nine coefficients, and its faces in Vulkan's orientation.
const coefficients = [1.6, 0.1, -0.15, 0.2, 0.1, -0.12, 0.08, 0.14, -0.1];
const basis = new Array(9);
function radiance(x, y, z) {
  const length = Math.hypot(x, y, z);
  SphericalHarmonics3.getBasisAt(new Vector3(x / length, y / length, z / length), basis);
  return coefficients.reduce((sum, c, i) => sum + c * basis[i], 0);
}
const faceDirections = [
  (s, t) => [1, -t, -s], (s, t) => [-1, -t, s], (s, t) => [s, 1, t],
  (s, t) => [s, -1, -t], (s, t) => [s, -t, 1], (s, t) => [-s, -t, -1],
];
const size = 32;
const faces = faceDirections.map((direction) => {
  const texels = new Array(4 * size * size).fill(255);
  for (let row = 0; row < size; ++row) {
    for (let column = 0; column < size; ++column) {
      const value = radiance(...direction(2 * (column + 0.5) / size - 1, 2 * (row + 0.5) / size - 1));
      assert(value >= 0 && value <= 1);
      texels.fill(255 * value, 4 * (row * size + column), 4 * (row * size + column) + 3);
    }
  }
  return texels;
});

// The generator reads its faces through a canvas: this one hands them through.
globalThis.document = {
  createElement: () => {
    let image;
    return {
      getContext: () => ({ drawImage: (drawn) => { image = drawn; }, getImageData: () => image }),
    };
  },
};
function project(six) {
  const images = six.map((data) => ({ data, width: size, height: size }));
  const texture = new CubeTexture(images);
  texture.colorSpace = LinearSRGBColorSpace;
  assert.equal(texture.wrapS, ClampToEdgeWrapping);
  return LightProbeGenerator.fromCubeTexture(texture).sh.coefficients.map((c) => c.x);
}
// Coefficients of 32 x 32 texels a face are within 0.1 % of c0.
const near = (a, b) => Math.abs(a - b) < 2e-3;
const asTheyAre = project(faces);
const flipped = coefficients.flatMap((c, i) => (near(asTheyAre[i], c) ? [] : [i]));
console.log(`fromCubeTexture, faces as they are: coefficients ${flipped} flip`);
assert.deepEqual(flipped, [3, 4, 7]);
for (const i of flipped) assert(near(asTheyAre[i], -coefficients[i]));
const mirrored = project(facesForThree(faces, size));
coefficients.forEach((c, i) => assert(near(mirrored[i], c), `coefficient ${i}: ${mirrored[i]} for ${c}`));
console.log('fromCubeTexture, facesForThree: all agree');

// The column of a latlong at which three.js' shaders look for a direction, by the shaders' own text.
const equirect = /float u = (.*?);/.exec(ShaderChunk.common.slice(ShaderChunk.common.indexOf('vec2 equirectUv')))[1];
const threeColumn = new Function('dir', `
  const atan = Math.atan2, RECIPROCAL_PI2 = 0.5 / Math.PI;
  return ${equirect};`);
const width = 64, height = 32;
let before;
for (let k = 0; k < 32; ++k) {
  const azimuth = 2 * Math.PI * (k + 0.5) / 32 + 0.01, y = 0.3, flat = Math.sqrt(1 - y * y);
  const sun = { x: flat * Math.sin(azimuth), y, z: -flat * Math.cos(azimuth) };
  // Welkin's latlong: +z in the middle, +x to its left.
  const column = Math.floor(width * (0.5 - Math.atan2(sun.x, sun.z) / (2 * Math.PI)));
  const row = Math.floor(height * Math.acos(y) / Math.PI);
  const texels = new Array(4 * width * height).fill(0);
  texels[4 * (row * width + column)] = 1;
  const turned = latlongForThree(texels, width).indexOf(1) / 4;
  const expected = Math.floor(width * threeColumn(sun));
  assert.equal(turned % width, expected, `azimuth ${azimuth}`);
  assert.equal(Math.floor(turned / width), row);
  if (column === 13) before = expected;
}
console.log(`latlong of 64 columns: the sun of column 13 is wanted in column ${before}`);
assert.equal(before, 29);
