// SPDX-License-Identifier: Apache-2.0
// Runs the modes' include in WGSL by Dawn and prints the results of every case as JSON.
//   node run_wgsl.mjs DAWN-PACKAGE FOLDER-OF-INCLUDES INPUT.json      {"skipped": "why"} without a device
import {readFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

const [dawn, folder, input] = process.argv.slice(2);
const {create, globals} = await import(pathToFileURL(`${dawn}/index.js`));
Object.assign(globalThis, globals);
const gpu = create(['backend=opengles']);
const adapter = await gpu.requestAdapter({featureLevel: 'compatibility'});
if (!adapter) {
  console.log(JSON.stringify({skipped: 'Dawn finds no OpenGL ES without a window here'}));
  process.exit(0);
}
const device = await adapter.requestDevice();
const {normals, cases} = JSON.parse(readFileSync(input));
const main = `
@group(1) @binding(0) var<storage, read> normals: array<vec4f>;
@group(1) @binding(1) var<storage, read_write> results: array<vec4f>;
@compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {
  if (id.x >= arrayLength(&normals)) { return; }
  let n = normals[id.x].xyz;
  results[2 * id.x] = vec4f(welkinModesIrradiance(n), 0.0);
  results[2 * id.x + 1] = vec4f(welkinModesIrradianceOverPi(n), 0.0);
}`;

function bufferOf(data, usage) {
  const buffer = device.createBuffer({size: data.byteLength, usage: usage | GPUBufferUsage.COPY_DST});
  device.queue.writeBuffer(buffer, 0, data);
  return buffer;
}

const list = bufferOf(new Float32Array(normals.flatMap((n) => [...n, 0])), GPUBufferUsage.STORAGE);
const outputs = [];
for (const {holds, constants, columns, rows, layers, texels} of cases) {
  device.pushErrorScope('validation');
  const module = device.createShaderModule({code: readFileSync(`${folder}/modes_${holds}.wgsl`, 'utf8') + main});
  for (const message of (await module.getCompilationInfo()).messages)
    throw new Error(`modes_${holds}.wgsl:${message.lineNum}: ${message.message}`);
  const pipeline = device.createComputePipeline({layout: 'auto', compute: {module, entryPoint: 'main'}});
  const size = [columns, rows, Math.max(layers, 2)];  // one layer alone would be a texture without layers
  const map = device.createTexture({size, format: 'rgba16float', usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST});
  device.queue.writeTexture({texture: map}, new Uint16Array(texels), {bytesPerRow: 8 * columns, rowsPerImage: rows}, [columns, rows, layers]);
  const sampler = device.createSampler({magFilter: 'linear', minFilter: 'linear'});
  const size_bytes = 32 * normals.length;
  const results = device.createBuffer({size: size_bytes, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC});
  const read = device.createBuffer({size: size_bytes, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ});
  const group = (index, resources) => device.createBindGroup({
    layout: pipeline.getBindGroupLayout(index),
    entries: resources.map((resource, binding) => ({binding, resource})),
  });
  const encoder = device.createCommandEncoder();
  const pass = encoder.beginComputePass();
  pass.setPipeline(pipeline);
  const uniform = bufferOf(new Float32Array(constants), GPUBufferUsage.UNIFORM);
  pass.setBindGroup(0, group(0, [{buffer: uniform}, map.createView({dimension: '2d-array'}), sampler]));
  pass.setBindGroup(1, group(1, [{buffer: list}, {buffer: results}]));
  pass.dispatchWorkgroups(Math.ceil(normals.length / 64));
  pass.end();
  encoder.copyBufferToBuffer(results, 0, read, 0, size_bytes);
  device.queue.submit([encoder.finish()]);
  const error = await device.popErrorScope();
  if (error) throw new Error(error.message);
  await read.mapAsync(GPUMapMode.READ);
  outputs.push(Array.from(new Float32Array(read.getMappedRange())));
  read.unmap();
}
console.log(JSON.stringify(outputs));
process.exit(0);
