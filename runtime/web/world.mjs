// Heads with hair of many assets, which come and go. Types, units and errors are in coif.d.ts. Steps and calls for single heads take no
// memory; addAsset(), settle(), save() and restore() may, where the room for their input and output is too small.

import { bytesPerHead, Heads } from './heads.mjs';
import { CoifError } from './memory.mjs';

const CALLS = ['coif_world_set_head', 'coif_world_set_moving_head', 'coif_world_reset', 'coif_world_teleport', 'coif_world_set_detail',
  'coif_world_is_asleep', 'coif_world_step', 'coif_world_settle', 'coif_world_saved_bytes', 'coif_world_save', 'coif_world_restore',
  'coif_world_palette', 'coif_world_bone_ends', 'coif_world_set_colliders', 'coif_world_set_body', 'coif_world_set_pose', 'coif_world_set_air',
  'coif_world_set_gusts', 'coif_world_gusts_way', 'coif_world_set_dynamics', 'coif_world_choose_dynamics', 'coif_world_push'];
const NAME_BYTES = 8;    // coif_world_head, coif_world_asset: two numbers
const NAME_AT = 1024;    // In scratch memory, behind what fill() writes there.

/** A head in a world: C's handle, and what it wears. */
export class WorldHead {
  constructor(world, asset, { index, generation }) {
    this.world = world;
    this.asset = asset;
    this.index = index;
    this.generation = generation;
    Object.freeze(this);
  }
}

/** Bytes of a world's hairBytes that an asset takes. */
export function bytesForWorld(asset, heads, desc, { crowd = 0 } = {}) {
  const { coif } = asset;
  needWorlds(coif, 'bytesForWorld');
  const wanted = coif.fill('WorldDesc', desc, 'coif_world_desc_init');
  const bytes = coif.exports.coif_world_bytes_for(asset.open && asset.at, asset.byteLength, heads, wanted, crowd) >>> 0;
  if (bytes === 0) coif.check(3, 'bytesForWorld'); // COIF_BAD_ARGUMENT
  return bytes;
}

function needWorlds({ exports }, what) {
  if (exports.coif_world_create === undefined) throw new CoifError(`${what}: the loaded module, of parts 'crowd', was built without worlds`, 'COIF_BAD_ARGUMENT');
}

export class World extends Heads {
  constructor(coif, desc) {
    needWorlds(coif, 'createWorld');
    super(coif, 'coif_world_', CALLS);
    const { exports } = coif;
    const wanted = () => coif.fill('WorldDesc', desc, 'coif_world_desc_init');
    const bytes = exports.coif_world_memory_need(wanted()) >>> 0;
    this.createIn(bytes, 'a world', 'createWorld', (memory, out) => exports.coif_world_create(wanted(), memory, bytes, out));
    this.assets = new Map(); // asset: its handle, and how many bones it has
    this.roomBytes = 0;
  }

  addAsset(asset, { crowd = 0 } = {}) {
    const { exports, scratch } = this.coif;
    if (this.assets.has(asset)) throw new CoifError('addAsset: the asset is in this world already', 'COIF_BAD_ARGUMENT');
    if (asset?.coif !== this.coif) throw new CoifError('addAsset: the asset was opened by another module', 'COIF_BAD_ARGUMENT');
    const [world, at, { boneCount }] = [this.open, asset.open && asset.at, asset.skeleton];
    this.room(bytesPerHead(boneCount, asset.bodyBones.length));
    this.check(exports.coif_world_add_asset(world, at, asset.byteLength, crowd, scratch), 'addAsset');
    this.assets.set(asset, { ...this.#written(), boneCount });
    ++asset.users;
  }
  removeAsset(asset) {
    this.check(this.coif.exports.coif_world_remove_asset(this.open, this.#nameOfAsset(asset, 'removeAsset')), 'removeAsset');
    this.assets.delete(asset);
    --asset.users;
  }
  hasAsset(asset) {
    return this.open !== 0 && this.assets.has(asset);
  }

  addHead(asset, pose = {}) {
    const out = this.coif.scratch + 512;
    this.check(this.coif.exports.coif_world_add_head(this.open, this.#nameOfAsset(asset, 'addHead'), this.pose(pose), out), 'addHead');
    return new WorldHead(this, asset, this.#written(out));
  }
  removeHead(head) {
    this.check(this.coif.exports.coif_world_remove_head(this.open, this.nameOf(head)), 'removeHead');
    this.palettes.delete(head);
  }
  hasHead(head) {
    return this.open !== 0 && head?.world === this && this.coif.exports.coif_world_has_head(this.open, this.nameOf(head)) !== 0;
  }

  dispose() {
    if (this.at === 0) return;
    const { memory } = this.coif;
    memory.give(this.memory, this.bytes);
    if (this.roomBytes > 0) memory.give(this.roomAt, this.roomBytes);
    this.at = 0;
    for (const asset of this.assets.keys()) --asset.users;
    this.assets.clear();
    this.palettes.clear();
  }

  // For heads.mjs.

  get open() {
    if (this.at === 0) throw new CoifError('the world was disposed of', 'COIF_NOT_CREATED');
    return this.at;
  }
  nameOf(head) {
    this.#own(head);
    return this.#write(head, this.coif.scratch + NAME_AT);
  }
  writeNames(heads) {
    const at = this.room(NAME_BYTES * heads.length);
    for (let i = 0; i < heads.length; ++i) this.#write(this.#own(heads[i]), at + NAME_BYTES * i);
    return at;
  }
  assetOf(head) {
    return this.#own(head).asset;
  }
  bonesOf(head) {
    // After the asset was removed, no head wears it; C refuses this one unread.
    return this.assets.get(this.#own(head).asset)?.boneCount ?? 0;
  }
  /** Address of at least so many bytes, and of at least what calls for one head need. */
  room(bytes) {
    if (bytes > this.roomBytes) {
      const { memory } = this.coif;
      const more = memory.take(bytes, "a world's input and output");
      if (this.roomBytes > 0) memory.give(this.roomAt, this.roomBytes);
      this.roomAt = more;
      this.roomBytes = bytes;
    }
    return this.roomAt;
  }

  #own(head) {
    if (head?.world !== this) throw new CoifError('this is no head of this world, which addHead() returned', 'COIF_BAD_INDEX');
    return head;
  }
  /** C takes a handle by value, which in WebAssembly is the address of a copy that the call may change. */
  #write({ index, generation }, at) {
    this.coif.memory.view.setUint32(at, index, true);
    this.coif.memory.view.setUint32(at + 4, generation, true);
    return at;
  }
  #written(at = this.coif.scratch) {
    const { view } = this.coif.memory;
    return { index: view.getUint32(at, true), generation: view.getUint32(at + 4, true) };
  }
  #nameOfAsset(asset, what) {
    const name = this.assets.get(asset);
    if (this.open !== 0 && name === undefined) throw new CoifError(`${what}: the asset is not in this world; addAsset() puts it there`, 'COIF_BAD_INDEX');
    return this.#write(name, this.coif.scratch + NAME_AT);
  }
}
