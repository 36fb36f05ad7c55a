// A crowd of heads that wear one asset. Types, units and errors are in coif.d.ts; nothing here allocates in the module's memory
// after the constructor, nor copies matrices.

import { CoifError } from './memory.mjs';
import { RECORDS } from './records.mjs';

const { HeadPose, MovingCollider, BodyPose, BoneTransform } = RECORDS;
const PALETTE_FLOATS = 12; // a matrix: three rows of four
const MOST_COLLIDERS = 16; // kMaxMovingColliders

export class Hair {
  constructor(asset, desc) {
    this.asset = asset;
    const coif = (this.coif = asset.coif);
    const { exports, memory } = coif;
    const wanted = coif.fill('HairDesc', desc, 'coif_hair_desc_init');
    this.bytes = exports.coif_hair_memory_need(asset.open && asset.at, asset.byteLength, wanted) >>> 0;
    if (this.bytes === 0) throw new CoifError('createHair: a member of the description is out of its range, or of what the loaded module was built without', 'COIF_BAD_ARGUMENT');
    this.memory = memory.take(this.bytes, 'hair');
    const [out, kept] = [coif.scratch + 512, coif.fill('HairDesc', desc, 'coif_hair_desc_init')];
    const status = exports.coif_hair_create(asset.at, asset.byteLength, kept, this.memory, this.bytes, out);
    if (status !== 0) {
      memory.give(this.memory, this.bytes);
      coif.check(status, 'createHair');
    }
    this.at = memory.view.getUint32(out, true);
    this.instances = exports.coif_hair_instance_count(this.at);
    this.boneCount = exports.coif_hair_bone_count(this.at);
    ++asset.users;
    this.#takeBuffers();
  }

  /** Memory for its input and output, apart from the crowd's own. */
  #takeBuffers() {
    const { memory, exports, scratch } = this.coif;
    const perHead = Math.max(this.boneCount * BoneTransform.size, MOST_COLLIDERS * MovingCollider.size, this.asset.bodyBones.length * BodyPose.size);
    this.savedBytes = exports.coif_hair_saved_bytes(this.at) >>> 0;
    // After the heads' poses: input or output of a single head, or a saved state; one at a time.
    this.poseBytes = this.instances * HeadPose.size;
    this.bufferBytes = this.poseBytes + Math.max(2 * perHead, this.savedBytes, 4 * this.instances);
    this.poses = memory.take(this.bufferBytes, 'poses of heads');
    this.room = this.poses + this.poseBytes;
    exports.coif_head_pose_init(scratch);
    for (let i = 0; i < this.instances; ++i) memory.bytes.copyWithin(this.poses + i * HeadPose.size, scratch, scratch + HeadPose.size);
    this.positions = new Float64Array(memory.buffer, this.poses, this.poseBytes / 8);
    this.rotations = new Float32Array(memory.buffer, this.poses, this.poseBytes / 4);
    this.boneEndsView = new Float32Array(memory.buffer, this.room, 3 * this.boneCount);
    this.transformsView = new Float32Array(memory.buffer, this.room, 7 * this.boneCount);
    this.palettes = new Array(this.instances);
  }

  // Heads.

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
    const isHead = this.#open !== 0 && Number.isInteger(instance) && instance >= 0 && instance < this.instances;
    if (!isHead) this.#check(4, 'writeHeadBone'); // COIF_BAD_INDEX
    this.#check(this.coif.poseOfBone(bone, headBone, this.poses + instance * HeadPose.size), 'writeHeadBone');
  }
  setHeads() {
    this.#check(this.coif.exports.coif_hair_set_heads(this.#open, this.poses, this.instances), 'setHeads');
  }
  setHead(instance, pose, velocity) {
    const at = this.#pose(pose);
    const { exports, scratch } = this.coif;
    if (velocity === undefined) return this.#check(exports.coif_hair_set_head(this.#open, instance, at), 'setHead');
    const speed = this.coif.fill('HeadVelocity', { linear: [0, 0, 0], angular: [0, 0, 0], ...velocity }, undefined, scratch + 64);
    return this.#check(exports.coif_hair_set_moving_head(this.#open, instance, at, speed), 'setHead');
  }
  reset(instance, pose = {}) {
    this.#check(this.coif.exports.coif_hair_reset(this.#open, instance, this.#pose(pose)), 'reset');
  }
  teleport(instance, pose) {
    this.#check(this.coif.exports.coif_hair_teleport(this.#open, instance, this.#pose(pose)), 'teleport');
  }
  setDetail(instance, detail) {
    const at = this.coif.fill('Detail', { level: 0, interval: 1, simulated: true, ...detail });
    this.#check(this.coif.exports.coif_hair_set_detail(this.#open, instance, at), 'setDetail');
  }
  isAsleep(instance) {
    return this.coif.exports.coif_hair_is_asleep(this.#open, instance) !== 0;
  }

  // Time.

  step(settings) {
    this.#check(this.coif.exports.coif_hair_step(this.#open, this.coif.fillSettings(settings)), 'step');
  }
  settle(instances, seconds, settings) {
    const list = typeof instances === 'number' ? [instances] : instances;
    if (list.length > this.instances) throw new CoifError('settle: more heads than there are', 'COIF_BAD_INDEX');
    new Uint32Array(this.coif.memory.buffer, this.room, list.length).set(list);
    const at = this.coif.fillSettings(settings);
    this.#check(this.coif.exports.coif_hair_settle(this.#open, this.room, list.length, seconds, at), 'settle');
  }
  save() {
    this.#check(this.coif.exports.coif_hair_save(this.#open, this.room, this.savedBytes), 'save');
    return this.coif.memory.bytes.slice(this.room, this.room + this.savedBytes);
  }
  restore(state) {
    if (state.length > this.savedBytes) this.#check(10, 'restore'); // COIF_FOREIGN_STATE: there is no room for more
    this.coif.memory.bytes.set(state, this.room);
    this.#check(this.coif.exports.coif_hair_restore(this.#open, this.room, state.length), 'restore');
  }

  // Results.

  palette(instance) {
    const at = this.coif.exports.coif_hair_palette(this.#open, instance) >>> 0;
    if (at === 0) this.#check(4, 'palette'); // COIF_BAD_INDEX
    let view = this.palettes[instance];
    if (view === undefined || view.byteOffset !== at) {
      view = this.palettes[instance] = new Float32Array(this.coif.memory.buffer, at, PALETTE_FLOATS * this.boneCount);
    }
    return view;
  }
  boneEnds(instance) {
    this.#check(this.coif.exports.coif_hair_bone_ends(this.#open, instance, this.room, this.boneCount), 'boneEnds');
    return this.boneEndsView;
  }
  boneTransforms(instance) {
    const palette = this.palette(instance).byteOffset;
    this.#check(this.coif.exports.coif_bone_transforms(this.asset.view, palette, this.room, this.boneCount), 'boneTransforms');
    return this.transformsView;
  }

  // On a character.

  setColliders(instance, colliders) {
    if (colliders.length > MOST_COLLIDERS) this.#check(12, 'setColliders'); // COIF_NOT_ASKED
    colliders.forEach((each, i) => this.coif.fill('MovingCollider', each, 'coif_moving_collider_init', this.room + i * MovingCollider.size));
    this.#check(this.coif.exports.coif_hair_set_colliders(this.#open, instance, this.room, colliders.length), 'setColliders');
  }
  setBody(instance, bones) {
    // C refuses any other number without reading it, and says why.
    if (bones.length === this.asset.bodyBones.length) bones.forEach((each, i) => this.coif.fill('BodyPose', each, undefined, this.room + i * BodyPose.size));
    this.#check(this.coif.exports.coif_hair_set_body(this.#open, instance, this.room, bones.length), 'setBody');
  }
  setPose(instance, rotations = [], weights = []) {
    const after = this.room + 16 * this.boneCount;
    const fits = rotations.length % 4 === 0 && rotations.length <= 4 * this.boneCount && weights.length <= this.boneCount;
    if (fits) {
      new Float32Array(this.coif.memory.buffer, this.room, rotations.length).set(rotations);
      new Float32Array(this.coif.memory.buffer, after, weights.length).set(weights);
    }
    const count = fits ? rotations.length / 4 : this.boneCount + 1; // C refuses that unread, and says why
    this.#check(this.coif.exports.coif_hair_set_pose(this.#open, instance, this.room, count, after, weights.length), 'setPose');
  }

  // Air, blows, dynamics.

  setAir(instance, air) {
    this.#check(this.coif.exports.coif_hair_set_air(this.#open, instance, this.coif.fill('HeadAir', air, 'coif_head_air_init')), 'setAir');
  }
  setGusts(gusts) {
    this.#check(this.coif.exports.coif_hair_set_gusts(this.#open, this.coif.fill('Gusts', gusts, 'coif_gusts_init')), 'setGusts');
  }
  get gustsWay() {
    return this.coif.exports.coif_hair_gusts_way(this.#open);
  }
  setDynamics(set, { stiffness = 1, damping = 1, friction = 1 }) {
    this.#check(this.coif.exports.coif_hair_set_dynamics(this.#open, set, stiffness, damping, friction), 'setDynamics');
  }
  chooseDynamics(instance, set) {
    this.#check(this.coif.exports.coif_hair_choose_dynamics(this.#open, instance, set), 'chooseDynamics');
  }
  push(instance, impulse) {
    this.#check(this.coif.exports.coif_hair_push(this.#open, instance, this.coif.fill('Impulse', impulse, 'coif_impulse_init')), 'push');
  }

  dispose() {
    if (this.at === 0) return;
    this.coif.memory.give(this.memory, this.bytes);
    this.coif.memory.give(this.poses, this.bufferBytes);
    this.at = 0;
    --this.asset.users;
  }

  get #open() {
    if (this.at === 0) throw new CoifError('the hair was disposed of', 'COIF_NOT_CREATED');
    return this.at;
  }
  #check(status, what) {
    this.coif.check(status, what);
  }
  #pose(pose) {
    return this.coif.fill('HeadPose', pose, 'coif_head_pose_init');
  }
}
