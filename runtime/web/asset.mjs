// A cooked asset in the module's memory: opened, read in place. coif.d.ts documents types and members.

import { DrawnHair } from './drawn_hair.mjs';
import { Hair } from './hair.mjs';
import { CoifError } from './memory.mjs';
import { RECORDS } from './records.mjs';

const VIEW_BYTES = 1024; // coif_asset
const WHY_BYTES = 512;
const NONE = 0xffffffff;

const TEXTURE_ROLES = { 'base-color': 0, 'shift-mask': 1, 'normal-map': 2, 'strand-map': 3 };

export class Asset {
  constructor(coif, bytes) {
    this.coif = coif;
    this.byteLength = bytes.length;
    this.users = 0;
    this.at = coif.memory.take(bytes.length, 'an asset');
    coif.memory.bytes.set(bytes, this.at);
    this.view = coif.memory.take(VIEW_BYTES, 'an asset');
    const why = coif.scratch;
    if (coif.exports.coif_asset_open(this.view, this.at, bytes.length, why, WHY_BYTES) !== 0) {
      this.#giveBack();
      throw new CoifError(coif.memory.text(why), 'COIF_ASSET_LACKS_DATA');
    }
  }

  /** Compares vertices, indices and texels with their hashes, which opening does not. Throws if they were changed. */
  verifyDrawData() {
    const why = this.coif.scratch;
    if (this.coif.exports.coif_asset_verify_draw_data(this.open, why, WHY_BYTES) === 0) {
      throw new CoifError(this.coif.memory.text(why), 'COIF_ASSET_LACKS_DATA');
    }
  }

  /** The address of the C interface's view of it. */
  get open() {
    if (this.at === 0) throw new CoifError('the asset was disposed of', 'COIF_NOT_CREATED');
    return this.view;
  }

  get skeleton() {
    return this.coif.read('Skeleton', this.coif.exports.coif_asset_skeleton(this.open) >>> 0);
  }
  get bones() {
    return this.#records('coif_asset_bones', 'Bone').map((bone, i) => ({
      ...bone, parent: bone.parent === NONE ? -1 : bone.parent, chain: bone.chain === NONE ? -1 : bone.chain, name: this.boneName(i) }));
  }
  get chains() {
    return this.#records('coif_asset_chains', 'Chain');
  }
  get limits() {
    return this.#records('coif_asset_limits', 'Limit');
  }
  get links() {
    return this.#records('coif_asset_links', 'Link');
  }
  get colliders() {
    return this.#records('coif_asset_colliders', 'Collider');
  }
  get bodyBones() {
    const name = (i) => this.coif.memory.text(this.coif.exports.coif_asset_body_bone_name(this.view, i) >>> 0);
    return this.#records('coif_asset_body_bones', 'BodyBone').map((bone, i) => ({ ...bone, name: name(i) }));
  }
  get bodyColliders() {
    return this.#records('coif_asset_body_colliders', 'Collider');
  }

  boneName(bone) {
    return this.coif.memory.text(this.coif.exports.coif_asset_bone_name(this.open, bone) >>> 0);
  }

  tunedSubsteps(dt) {
    return this.coif.exports.coif_asset_tuned_substeps(this.open, dt);
  }

  // Drawn data.

  get vertices() {
    const { at, count } = this.#list('coif_asset_vertices');
    return new Uint8Array(this.coif.memory.buffer, at, count * RECORDS.Vertex.size);
  }
  get skin() {
    const { at, count } = this.#list('coif_asset_skin');
    return new Uint8Array(this.coif.memory.buffer, at, count * RECORDS.Skin.size);
  }
  get indices() {
    const { at, count } = this.#list('coif_asset_indices');
    return new Uint32Array(this.coif.memory.buffer, at, count);
  }
  get patches() {
    return this.#records('coif_asset_patches', 'Patch');
  }
  get lodCount() {
    return this.coif.exports.coif_asset_lod_count(this.open);
  }
  lodIndices(lod) {
    const { at, count } = this.#list('coif_asset_lod_indices', lod);
    return new Uint32Array(this.coif.memory.buffer, at, count);
  }
  chooseLod(share, current, hysteresis = 0.1) {
    return this.coif.exports.coif_asset_choose_lod(this.open, share, current, hysteresis);
  }

  get material() {
    const at = this.coif.exports.coif_asset_material(this.open) >>> 0;
    return at === 0 ? null : this.coif.read('Material', at);
  }

  texture(role) {
    if (!(role in TEXTURE_ROLES)) {
      throw new CoifError(`'${role}' is no texture; there are ${Object.keys(TEXTURE_ROLES).join(', ')}`, 'COIF_BAD_ARGUMENT');
    }
    const { exports, memory } = this.coif;
    const at = exports.coif_asset_texture(this.open, TEXTURE_ROLES[role]) >>> 0;
    if (at === 0) return null;
    const { format, width, height, mipCount } = this.coif.read('Texture', at);
    const mips = Array.from({ length: mipCount }, (_, mip) => {
      const texels = exports.coif_asset_texels(this.view, at, mip, this.coif.scratch) >>> 0;
      return new Uint8Array(memory.buffer, texels, memory.view.getUint32(this.coif.scratch, true));
    });
    return { format: ['srgb8-alpha8', 'rg8', 'rg11-eac', 'srgb8-alpha8-etc2'][format], width, height, mips };
  }

  /** The data for renderers; throws for an asset without a mesh. */
  drawnHair() {
    return new DrawnHair(this);
  }

  createHair(desc = {}) {
    return new Hair(this, desc);
  }

  dispose() {
    if (this.at === 0) return;
    if (this.users > 0) throw new CoifError(`${this.users} that were made of the asset still need it; dispose() of them first`);
    this.#giveBack();
  }

  #giveBack() {
    this.coif.memory.give(this.at, this.byteLength);
    if (this.view !== undefined) this.coif.memory.give(this.view, VIEW_BYTES);
    this.at = 0;
  }

  /** A list of the C interface: its address and its length. */
  #list(name, ...more) {
    const { exports, memory, scratch } = this.coif;
    const at = exports[name](this.open, ...more, scratch) >>> 0;
    return { at, count: memory.view.getUint32(scratch, true) };
  }

  #records(name, type) {
    const { at, count } = this.#list(name);
    return Array.from({ length: count }, (_, i) => this.coif.read(type, at + i * RECORDS[type].size));
  }
}
