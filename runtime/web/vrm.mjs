// The hair of a VRM model that three-vrm loaded, moved by coif. Types are in vrm.d.ts. Uses nothing of three but the objects that it
// receives.

import { CoifError } from './memory.mjs';

const SIMULATED = 2; // coif_bone_kind
const MOST_OFFSET = 0.01; // metres between a node and its bone: more is another model
const NOWHERE = [0, 0, 0];

export function replaceSpringBones(vrm, asset, options = {}) {
  return new SimulatedHair(vrm, asset, options);
}

/** A node's name in the file; three changes names with dots and brackets, and keeps the original beside it. */
const nameOf = (node) => node.userData?.name ?? node.name;

export class SimulatedHair {
  constructor(vrm, asset, { settings = {}, desc = {} }) {
    this.vrm = vrm;
    this.asset = asset;
    this.settings = { ...settings };
    this.springs = vrm.springBoneManager;
    this.springs?.reset(); // puts nodes into their rest pose, from which the asset was cooked
    this.#find();
    const wearsBody = this.body.length > 0;
    this.hair = asset.createHair({ ...(wearsBody && { solver: 'character', followsBody: true }), ...desc, instances: 1 });
    this.#takeSpringsAway();
    this.reset();
  }

  /** Finds the model's nodes for the asset's head, simulated bones and body bones. */
  #find() {
    const { vrm, asset } = this;
    const nodes = new Map();
    vrm.scene.traverse((node) => nodes.has(nameOf(node)) || nodes.set(nameOf(node), node));
    const bones = asset.bones;
    const { headRotation } = asset.skeleton;
    this.head = vrm.humanoid?.getRawBoneNode?.('head') ?? nodes.get(bones[0].name);
    this.body = asset.bodyBones.map(({ name }) => nodes.get(name));
    const missing = bones.filter(({ kind, name }) => kind === SIMULATED && !nodes.has(name)).map(({ name }) => name);
    asset.bodyBones.forEach(({ name }, i) => this.body[i] === undefined && missing.push(name));
    if (this.head === undefined) missing.unshift(bones[0].name);
    if (missing.length > 0) {
      throw new CoifError(`the model has no '${missing.join("', '")}': the asset was cooked of another file, or with bones of its own`);
    }

    vrm.scene.updateWorldMatrix(true, true);
    const { quaternion, position } = vrm.scene;
    const place = () => ({ position: position.clone(), rotation: quaternion.clone(), scale: position.clone() });
    this.place = place();
    this.seen = vrm.scene.matrix.clone();
    this.mirror = this.seen.clone().makeScale(-1, 1, 1);
    this.turned = quaternion.clone();
    const headTurn = quaternion.clone().fromArray(headRotation);
    this.unitScale = this.#world(this.head, place()).scale.x / this.#world(vrm.scene, place()).scale.x;
    const rest = this.seen.clone().compose(position.clone().fromArray(NOWHERE), headTurn, position.clone().setScalar(this.unitScale));
    this.bone = { rest, largestStretch: Infinity };
    this.joints = [];
    const boneOf = new Map(bones.map((bone, i) => [nodes.get(bone.name), i]));
    const toModel = this.#world(this.head, place()).rotation.clone().multiply(headTurn.conjugate()).invert(); // world to head space
    this.parents = bones.map(({ parent }) => parent);
    this.absolute = bones.map(() => quaternion.clone().identity());
    bones.forEach((bone, i) => {
      if (bone.kind !== SIMULATED) return;
      const node = nodes.get(bone.name);
      const rest = (one) => toModel.clone().multiply(this.#world(one, place()).rotation);
      let above = node.parent;
      while (above !== null && !boneOf.has(above)) above = above.parent;
      this.joints.push({ node, bone: i, above: above === null ? 0 : boneOf.get(above),
        before: rest(node.parent).invert(), after: rest(node) });
      this.#checkPlace(node, bone, toModel);
    });
  }

  #checkPlace(node, bone, toModel) {
    const head = this.#world(this.head, this.place);
    const origin = head.position.clone();
    const scale = head.scale.x / this.unitScale;
    const at = this.#world(node, this.place).position.clone().sub(origin).applyQuaternion(toModel).divideScalar(scale);
    const off = Math.hypot(at.x - bone.joint[0], at.y - bone.joint[1], at.z - bone.joint[2]);
    if (!(off <= MOST_OFFSET)) {
      throw new CoifError(`'${bone.name}' is ${(off * 1000).toFixed(0)} mm from where the asset has it: it was cooked of another file`);
    }
  }

  /** Hair below a mirrored model moves as the mirror image of hair in a mirrored world, in which the model is not mirrored. */
  get #isMirrored() {
    return this.vrm.scene.matrixWorld.determinant() < 0;
  }

  #matrixOf(node) {
    this.seen.copy(node.matrixWorld);
    return this.#isMirrored ? this.seen.premultiply(this.mirror) : this.seen;
  }

  #world(node, { position, rotation, scale }) {
    this.#matrixOf(node).decompose(position, rotation, scale);
    return { position, rotation, scale };
  }

  /** Stops the model's own springs from moving these nodes; they keep moving others. */
  #takeSpringsAway() {
    this.removed = [];
    if (this.springs === undefined || this.springs === null) return;
    const moved = new Set();
    for (let { node } of this.joints) { // includes nodes between head and bones, which coif does not move
      for (; node !== null && node !== this.head; node = node.parent) moved.add(node);
    }
    for (const joint of [...this.springs.joints]) {
      if (!moved.has(joint.bone)) continue;
      this.removed.push(joint);
      this.springs.deleteJoint(joint);
    }
    const others = this.springs.update;
    this.springs.update = (delta) => {
      others.call(this.springs, delta);
      this.update(delta);
    };
  }

  update(delta) {
    this.head.updateWorldMatrix(true, false);
    this.hair.writeHeadBone(0, this.#matrixOf(this.head), this.bone);
    this.hair.setHeads();
    if (this.body.length > 0) this.hair.setBody(0, this.body.map((node) => this.#bodyPose(node)));
    this.settings.dt = delta;
    const { wind = NOWHERE } = this.settings;
    const mirrored = () => ({ ...this.settings, wind: [-(wind.x ?? wind[0]), wind.y ?? wind[1], wind.z ?? wind[2]] });
    this.hair.step(this.#isMirrored ? mirrored() : this.settings);
    this.#turnNodes();
  }

  reset() {
    this.head.updateWorldMatrix(true, false);
    this.hair.reset(0, this.asset.coif.headPose(this.#matrixOf(this.head), this.bone));
    if (this.body.length > 0) this.hair.setBody(0, this.body.map((node) => this.#bodyPose(node)));
    this.#turnNodes();
  }

  #bodyPose(node) {
    node.updateWorldMatrix(true, false);
    const { position, rotation } = this.#world(node, this.place);
    return { position: position.toArray(), rotation: rotation.toArray() };
  }

  /** Sets each node's rotation in its parent's axes. Node and parent turn from their rest in head space as their bones do. */
  #turnNodes() {
    const turns = this.hair.boneTransforms(0);
    this.absolute.forEach((rotation, i) => {
      rotation.fromArray(turns, 7 * i + 3);
      if (this.parents[i] >= 0) rotation.premultiply(this.absolute[this.parents[i]]);
    });
    for (const { node, bone, above, before, after } of this.joints) {
      this.turned.copy(this.absolute[above]).invert().multiply(this.absolute[bone]);
      node.quaternion.copy(before).multiply(this.turned).multiply(after);
      node.updateMatrix(); // three-vrm switched that off for nodes of its springs
    }
  }

  dispose() {
    if (this.hair === undefined) return;
    if (this.springs) {
      delete this.springs.update;
      for (const joint of this.removed) this.springs.addJoint(joint);
      this.springs.reset();
    }
    this.hair.dispose();
    this.hair = undefined;
  }
}
