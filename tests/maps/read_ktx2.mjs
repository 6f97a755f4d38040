// SPDX-License-Identifier: Apache-2.0
// Prints a KTX2 file as JSON, as ktx-parse reads it: node read_ktx2.mjs KTX-PARSE FILE
import {readFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

const {read} = await import(pathToFileURL(process.argv[2]));
const file = read(new Uint8Array(readFileSync(process.argv[3])));
const [descriptor] = file.dataFormatDescriptor;
console.log(JSON.stringify({
  vkFormat: file.vkFormat,
  typeSize: file.typeSize,
  size: [file.pixelWidth, file.pixelHeight, file.pixelDepth],
  layers: file.layerCount,
  faces: file.faceCount,
  supercompression: file.supercompressionScheme,
  model: descriptor.colorModel,
  primaries: descriptor.colorPrimaries,
  transfer: descriptor.transferFunction,
  block: Array.from(descriptor.texelBlockDimension),
  bytesPlane: Array.from(descriptor.bytesPlane),
  samples: descriptor.samples.map((s) => [s.bitOffset, s.bitLength, s.channelType]),
  values: file.keyValue,
  levels: file.levels.map((level) => Buffer.from(level.levelData).toString('hex')),
}));
