// coif in JavaScript: loads the module, opens assets, makes worlds. coif.d.ts documents the types and functions.

import { Asset } from './asset.mjs';
import { CoifError, Memory } from './memory.mjs';
import { RECORDS, read, write, writeMatrix } from './records.mjs';
import { bytesForWorld, World } from './world.mjs';

export { CoifError };

const PAGE = 65536;
const LEAST_BYTES = 2 << 20; // stack, constants and a small asset
const SCRATCH_BYTES = 4096;  // descriptions, poses, settings, one at a time

const STATUSES = ['COIF_OK', 'COIF_BAD_TIME_STEP', 'COIF_BAD_POSE', 'COIF_BAD_ARGUMENT', 'COIF_BAD_INDEX', 'COIF_MEMORY_TOO_SMALL',
  'COIF_NOT_CREATED', 'COIF_ASSET_LACKS_DATA', 'COIF_SIZE_MISMATCH', 'COIF_DRIVER', 'COIF_FOREIGN_STATE', 'COIF_DAMAGED_STATE', 'COIF_NOT_ASKED', 'COIF_BAD_SCALE'];

// Not literally: bundlers for browsers would look for it and find none.
const NODE_FILES = ['node:fs', 'promises'].join('/');

async function compile(wasm) {
  const source = await wasm;
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return WebAssembly.compile(source);
  if (typeof Response !== 'undefined' && source instanceof Response) return WebAssembly.compile(await source.arrayBuffer());
  const url = new URL(source, import.meta.url);
  if (url.protocol === 'file:') {
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ NODE_FILES);
    return WebAssembly.compile(await readFile(url));
  }
  const answer = await fetch(url);
  if (!answer.ok) throw new CoifError(`${url}: ${answer.status} ${answer.statusText}`);
  return WebAssembly.compile(await answer.arrayBuffer());
}

// Literally, for bundlers, which look for such files.
const MODULES = { all: new URL('./coif.wasm', import.meta.url), crowd: new URL('./coif-crowd.wasm', import.meta.url) };

export async function loadCoif({ memoryBytes = 64 << 20, parts = 'all', wasm = MODULES[parts] } = {}) {
  if (wasm === undefined) throw new CoifError(`parts is '${parts}'; it must be all or crowd`, 'COIF_BAD_ARGUMENT');
  if (!(memoryBytes >= LEAST_BYTES && memoryBytes <= 4294901760)) {
    throw new CoifError(`memoryBytes is ${memoryBytes}; it must be ${LEAST_BYTES} to 4294901760`, 'COIF_BAD_ARGUMENT');
  }
  const module = await compile(wasm);
  const pages = Math.ceil(memoryBytes / PAGE);
  const memory = new WebAssembly.Memory({ initial: pages, maximum: pages });
  const { exports } = await WebAssembly.instantiate(module, { env: { memory } });
  exports._initialize();
  return new Coif(exports, memory);
}

/** The module, its memory, and the functions that assets, crowds and worlds call. */
export class Coif {
  constructor(exports, memory) {
    this.exports = exports;
    this.wasmMemory = memory;
    this.memory = new Memory(memory, exports.__heap_base.value >>> 0);
    this.scratch = this.memory.take(SCRATCH_BYTES, 'scratch memory');
    this.settings = this.memory.take(RECORDS.StepSettings.size, 'settings');
    exports.coif_step_settings_init(this.settings);
  }

  get version() {
    return this.memory.text(this.exports.coif_version() >>> 0);
  }

  get freeBytes() {
    return this.memory.freeBytes;
  }

  openAsset(bytes) {
    return new Asset(this, ArrayBuffer.isView(bytes) ? new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength) : new Uint8Array(bytes));
  }

  createWorld(desc = {}) {
    return new World(this, desc);
  }

  bytesForWorld(asset, heads, desc = {}, options = {}) {
    return bytesForWorld(asset, heads, desc, options);
  }

  screenShare(height, distance, fov) {
    return this.exports.coif_screen_share(height, distance, fov);
  }

  gustAt(gusts, way, place) {
    this.fill('Gusts', gusts, 'coif_gusts_init');
    const where = this.fill('BodyPose', { position: place }, undefined, this.scratch + 256);
    const out = this.scratch + 512;
    this.exports.coif_gust_at(out, this.scratch, way, where);
    return Array.from(new Float32Array(this.memory.buffer, out, 3));
  }

  headPose(bone, headBone) {
    const out = this.scratch + 512;
    this.check(this.poseOfBone(bone, headBone, out), 'headPose');
    const { position, rotation, scale } = this.read('HeadPose', out);
    return { position, rotation, scale };
  }

  // For the other modules.

  /** Writes the pose of a head on a bone to the address `out`; its status. */
  poseOfBone(bone, headBone, out) {
    writeMatrix(this.memory.view, this.scratch, bone, 'bone');
    const kind = this.fill('HeadBone', headBone, 'coif_head_bone_init', this.scratch + RECORDS.BoneMatrix.size);
    return this.exports.coif_head_pose_of_bone(this.scratch, kind, out);
  }

  /** Throws the error of a status other than COIF_OK; `what` is the name of the call. */
  check(status, what) {
    if (status === 0) return;
    throw new CoifError(`${what}: ${this.memory.text(this.exports.coif_describe(status) >>> 0)}`, STATUSES[status] ?? `${status}`);
  }

  /** Writes a record: defaults by `init`, then the members of `object`. Returns its address in scratch, valid until the next call. */
  fill(name, object, init, at = this.scratch) {
    if (init !== undefined) this.exports[init](at);
    write(this.memory.view, RECORDS[name], at, object);
    return at;
  }

  /** The settings of a step: defaults, and the members of `object`. */
  fillSettings(object) {
    const { size } = RECORDS.StepSettings;
    this.memory.bytes.copyWithin(this.scratch, this.settings, this.settings + size);
    write(this.memory.view, RECORDS.StepSettings, this.scratch, object);
    return this.scratch;
  }

  read(name, at) {
    return read(this.memory.view, RECORDS[name], at);
  }
}
