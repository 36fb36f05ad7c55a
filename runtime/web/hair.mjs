// A crowd of heads that wear one asset. Types, units and errors are in coif.d.ts; nothing here allocates in the module's memory
// after the constructor, nor copies matrices.

import { bytesPerHead, Heads } from './heads.mjs';
import { CoifError } from './memory.mjs';
import { RECORDS } from './records.mjs';

const { HeadPose } = RECORDS;
const CALLS = ['coif_hair_set_head', 'coif_hair_set_moving_head', 'coif_hair_reset', 'coif_hair_teleport', 'coif_hair_set_detail',
  'coif_hair_is_asleep', 'coif_hair_step', 'coif_hair_settle', 'coif_hair_saved_bytes', 'coif_hair_save', 'coif_hair_restore',
  'coif_hair_palette', 'coif_hair_bone_ends', 'coif_hair_set_colliders', 'coif_hair_set_body', 'coif_hair_set_pose', 'coif_hair_set_air',
  'coif_hair_set_gusts', 'coif_hair_gusts_way', 'coif_hair_set_dynamics', 'coif_hair_choose_dynamics', 'coif_hair_push'];

export class Hair extends Heads {
  constructor(asset, desc) {
    super(asset.coif, 'coif_hair_', CALLS);
    this.asset = asset;
    const { exports } = this.coif;
    const wanted = () => this.coif.fill('HairDesc', desc, 'coif_hair_desc_init');
    const bytes = exports.coif_hair_memory_need(asset.open && asset.at, asset.byteLength, wanted()) >>> 0;
    this.createIn(bytes, 'hair', 'createHair', (memory, out) => exports.coif_hair_create(asset.at, asset.byteLength, wanted(), memory, bytes, out));
    this.instances = exports.coif_hair_instance_count(this.at);
    this.boneCount = exports.coif_hair_bone_count(this.at);
    ++asset.users;
    this.#takeBuffers();
  }

  /** Memory for its input and output, apart from the crowd's own. */
  #takeBuffers() {
    const { memory, exports, scratch } = this.coif;
    // After the heads' poses: input or output of a single head, or a saved state; one at a time.
    this.poseBytes = this.instances * HeadPose.size;
    this.bufferBytes = this.poseBytes + Math.max(bytesPerHead(this.boneCount, this.asset.bodyBones.length), this.savedBytes, 4 * this.instances);
    this.poses = memory.take(this.bufferBytes, 'poses of heads');
    exports.coif_head_pose_init(scratch);
    for (let i = 0; i < this.instances; ++i) memory.bytes.copyWithin(this.poses + i * HeadPose.size, scratch, scratch + HeadPose.size);
    this.positions = new Float64Array(memory.buffer, this.poses, this.poseBytes / 8);
    this.rotations = new Float32Array(memory.buffer, this.poses, this.poseBytes / 4);
  }

  writeHead(instance, position, rotation, scale = 1) {
    const [p, r] = [instance * 6, instance * 12 + 6];
    this.positions[p] = position.x ?? position[0];
    this.positions[p + 1] = position.y ?? position[1];
    this.positions[p + 2] = position.z ?? position[2];
    this.rotations[r] = rotation.x ?? rotation[0];
    this.rotations[r + 1] = rotation.y ?? rotation[1];
    this.rotations[r + 2] = rotation.z ?? rotation[2];
    this.rotations[r + 3] = rotation.w ?? rotation[3];
    this.rotations[r + 4] = scale;
  }
  writeHeadBone(instance, bone, headBone) {
    const isHead = this.open !== 0 && Number.isInteger(instance) && instance >= 0 && instance < this.instances;
    if (!isHead) this.check(4, 'writeHeadBone'); // COIF_BAD_INDEX
    this.check(this.coif.poseOfBone(bone, headBone, this.poses + instance * HeadPose.size), 'writeHeadBone');
  }
  setHeads() {
    this.check(this.coif.exports.coif_hair_set_heads(this.open, this.poses, this.instances), 'setHeads');
  }

  dispose() {
    if (this.at === 0) return;
    this.coif.memory.give(this.memory, this.bytes);
    this.coif.memory.give(this.poses, this.bufferBytes);
    this.at = 0;
    --this.asset.users;
  }

  // For heads.mjs.

  get open() {
    if (this.at === 0) throw new CoifError('the hair was disposed of', 'COIF_NOT_CREATED');
    return this.at;
  }
  nameOf(instance) {
    return instance;
  }
  writeNames(instances) {
    if (instances.length > this.instances) throw new CoifError('settle: more heads than there are', 'COIF_BAD_INDEX');
    new Uint32Array(this.coif.memory.buffer, this.room(), instances.length).set(instances);
    return this.room();
  }
  assetOf() {
    return this.asset;
  }
  bonesOf() {
    return this.boneCount;
  }
  /** There is enough for everything. */
  room() {
    return this.poses + this.poseBytes;
  }
}
