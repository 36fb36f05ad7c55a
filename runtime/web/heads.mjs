// What crowds (hair.mjs) and worlds (world.mjs) have in common: heads, time, results. Types, units and errors are in coif.d.ts.
//
// A class of them says what C calls a head (`nameOf`, and `writeNames` for a list), which asset it wears (`assetOf`), and where there is
// memory for input and output (`room`).

import { CoifError } from './memory.mjs';
import { RECORDS } from './records.mjs';

const { MovingCollider, BodyPose, BoneTransform } = RECORDS;
const PALETTE_FLOATS = 12; // a matrix: three rows of four
const MOST_COLLIDERS = 16; // kMaxMovingColliders

/** Bytes of input or output for one head with this asset. */
export const bytesPerHead = (boneCount, bodyBones) =>
  2 * Math.max(boneCount * BoneTransform.size, MOST_COLLIDERS * MovingCollider.size, bodyBones * BodyPose.size);

export class Heads {
  /** `names`: C's functions, which `calls` has without `prefix`. */
  constructor(coif, prefix, names) {
    this.coif = coif;
    this.calls = Object.fromEntries(names.map((name) => [name.slice(prefix.length), coif.exports[name]]));
    this.at = 0;
    this.palettes = new Map();
    this.views = new Map();
  }

  /** Takes `bytes` bytes for `what`, where `make` has C create it; `name` is that of the call. */
  createIn(bytes, what, name, make) {
    const { memory, scratch } = this.coif;
    if (bytes === 0) throw new CoifError(`${name}: a member of the description is out of its range, or of what the loaded module was built without`, 'COIF_BAD_ARGUMENT');
    this.bytes = bytes;
    this.memory = memory.take(bytes, what);
    const status = make(this.memory, scratch + 512);
    if (status !== 0) {
      memory.give(this.memory, bytes);
      this.check(status, name);
    }
    this.at = memory.view.getUint32(scratch + 512, true);
  }

  // Heads.

  setHead(head, pose, velocity) {
    const at = this.pose(pose);
    if (velocity === undefined) return this.check(this.calls.set_head(this.open, this.nameOf(head), at), 'setHead');
    const speed = this.coif.fill('HeadVelocity', { linear: [0, 0, 0], angular: [0, 0, 0], ...velocity }, undefined, this.coif.scratch + 64);
    return this.check(this.calls.set_moving_head(this.open, this.nameOf(head), at, speed), 'setHead');
  }
  reset(head, pose = {}) {
    this.check(this.calls.reset(this.open, this.nameOf(head), this.pose(pose)), 'reset');
  }
  teleport(head, pose) {
    this.check(this.calls.teleport(this.open, this.nameOf(head), this.pose(pose)), 'teleport');
  }
  setDetail(head, detail) {
    const at = this.coif.fill('Detail', { level: 0, interval: 1, simulated: true, ...detail });
    this.check(this.calls.set_detail(this.open, this.nameOf(head), at), 'setDetail');
  }
  isAsleep(head) {
    return this.calls.is_asleep(this.open, this.nameOf(head)) !== 0;
  }

  // Time.

  step(settings) {
    this.check(this.calls.step(this.open, this.coif.fillSettings(settings)), 'step');
  }
  settle(heads, seconds, settings) {
    const list = typeof heads?.length === 'number' ? heads : [heads];
    const names = this.writeNames(list);
    this.check(this.calls.settle(this.open, names, list.length, seconds, this.coif.fillSettings(settings)), 'settle');
  }
  get savedBytes() {
    return this.calls.saved_bytes(this.open) >>> 0;
  }
  save() {
    const bytes = this.savedBytes;
    const at = this.room(bytes);
    this.check(this.calls.save(this.open, at, bytes), 'save');
    return this.coif.memory.bytes.slice(at, at + bytes);
  }
  restore(state) {
    const bytes = this.savedBytes;
    if (state.length > bytes) this.check(10, 'restore'); // COIF_FOREIGN_STATE: there is no room for more
    const at = this.room(bytes);
    this.coif.memory.bytes.set(state, at);
    this.check(this.calls.restore(this.open, at, state.length), 'restore');
  }

  // Results.

  palette(head) {
    const at = this.calls.palette(this.open, this.nameOf(head)) >>> 0;
    if (at === 0) this.check(4, 'palette'); // COIF_BAD_INDEX
    let view = this.palettes.get(head);
    if (view === undefined || view.byteOffset !== at) {
      view = new Float32Array(this.coif.memory.buffer, at, PALETTE_FLOATS * this.bonesOf(head));
      this.palettes.set(head, view);
    }
    return view;
  }
  boneEnds(head) {
    const [at, bones] = [this.room(0), this.bonesOf(head)];
    this.check(this.calls.bone_ends(this.open, this.nameOf(head), at, bones), 'boneEnds');
    return this.#floats(at, 3 * bones);
  }
  boneTransforms(head) {
    const [at, palette, bones] = [this.room(0), this.palette(head).byteOffset, this.bonesOf(head)];
    this.check(this.coif.exports.coif_bone_transforms(this.assetOf(head).view, palette, at, bones), 'boneTransforms');
    return this.#floats(at, 7 * bones);
  }

  // On a character.

  setColliders(head, colliders) {
    if (colliders.length > MOST_COLLIDERS) this.check(12, 'setColliders'); // COIF_NOT_ASKED
    const at = this.room(0);
    colliders.forEach((each, i) => this.coif.fill('MovingCollider', each, 'coif_moving_collider_init', at + i * MovingCollider.size));
    this.check(this.calls.set_colliders(this.open, this.nameOf(head), at, colliders.length), 'setColliders');
  }
  setBody(head, bones) {
    const at = this.room(0);
    // C refuses any other number without reading it, and says why.
    if (bones.length === this.assetOf(head).bodyBones.length) bones.forEach((each, i) => this.coif.fill('BodyPose', each, undefined, at + i * BodyPose.size));
    this.check(this.calls.set_body(this.open, this.nameOf(head), at, bones.length), 'setBody');
  }
  setPose(head, rotations = [], weights = []) {
    const [at, bones] = [this.room(0), this.bonesOf(head)];
    const after = at + 16 * bones;
    const fits = rotations.length % 4 === 0 && rotations.length <= 4 * bones && weights.length <= bones;
    if (fits) {
      new Float32Array(this.coif.memory.buffer, at, rotations.length).set(rotations);
      new Float32Array(this.coif.memory.buffer, after, weights.length).set(weights);
    }
    const count = fits ? rotations.length / 4 : bones + 1; // C refuses that unread, and says why
    this.check(this.calls.set_pose(this.open, this.nameOf(head), at, count, after, weights.length), 'setPose');
  }

  // Air, blows, dynamics.

  setAir(head, air) {
    this.check(this.calls.set_air(this.open, this.nameOf(head), this.coif.fill('HeadAir', air, 'coif_head_air_init')), 'setAir');
  }
  setGusts(gusts) {
    this.check(this.calls.set_gusts(this.open, this.coif.fill('Gusts', gusts, 'coif_gusts_init')), 'setGusts');
  }
  get gustsWay() {
    return this.calls.gusts_way(this.open);
  }
  setDynamics(set, { stiffness = 1, damping = 1, friction = 1 }) {
    this.check(this.calls.set_dynamics(this.open, set, stiffness, damping, friction), 'setDynamics');
  }
  chooseDynamics(head, set) {
    this.check(this.calls.choose_dynamics(this.open, this.nameOf(head), set), 'chooseDynamics');
  }
  push(head, impulse) {
    this.check(this.calls.push(this.open, this.nameOf(head), this.coif.fill('Impulse', impulse, 'coif_impulse_init')), 'push');
  }

  // For the classes that extend this one.

  check(status, what) {
    this.coif.check(status, what);
  }
  pose(pose) {
    return this.coif.fill('HeadPose', pose, 'coif_head_pose_init');
  }
  /** The view of so many floats at `at`, the same one each time. */
  #floats(at, length) {
    let view = this.views.get(length);
    if (view === undefined || view.byteOffset !== at) {
      view = new Float32Array(this.coif.memory.buffer, at, length);
      this.views.set(length, view);
    }
    return view;
  }
}
