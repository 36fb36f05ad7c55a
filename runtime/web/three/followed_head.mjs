// A head of a CoifHair: which object it follows, and where that puts it. ../three.d.ts documents follow().

import { Matrix4, Quaternion, Vector3 } from 'three';

import { CoifError } from '../memory.mjs';

const SMALLEST_SCALE = 0.05, LARGEST_SCALE = 20; // of a head
const mirror = new Matrix4().makeScale(-1, 1, 1);

/** The mean factor by which a matrix scales lengths. */
const scaleOf = (matrix) => Math.cbrt(Math.abs(matrix.determinant()));
const isOfHeads = (scale) => scale >= SMALLEST_SCALE && scale <= LARGEST_SCALE;

export class FollowedHead {
  constructor(number, object) {
    Object.assign(this, { number, position: new Vector3(), rotation: new Quaternion(), scale: 1, lod: 0, distance: 0 });
    this.matrix = new Matrix4(); // from head space to that of the CoifHair
    this.fromHead = new Matrix4(); // from head space to the axes of the object
    this.isPlaced = true;
    this.follow(object);
  }

  follow(object, { rest, origin } = {}) {
    const axes = new Matrix4();
    if (rest !== undefined) axes.fromArray(rest.elements ?? rest).setPosition(0, 0, 0);
    const from = new Vector3();
    if (origin !== undefined) from.set(origin.x ?? origin[0], origin.y ?? origin[1], origin.z ?? origin[2]);
    const volume = Math.abs(axes.determinant()) * (Number.isFinite(from.length()) ? 1 : 0);
    if (!(volume > 0 && volume < Infinity)) {
      throw new RangeError(`head ${this.number}: 'rest' must be a matrix of 16 numbers that has an inverse, and 'origin' three numbers`);
    }
    this.followed = object;
    this.bone = { rest: axes, origin: from, largestStretch: Infinity }; // drawn as uneven as it is, simulated evenly
    this.fromHead.copy(axes).invert().multiply(new Matrix4().setPosition(from));
    this.unit = rest === undefined ? undefined : 1; // of a rig: unknown
    this.warned = new Set();
  }

  /** Takes out a rig's unit: that of an object whose scale no head has, until the scale is a head's. */
  #findUnit(matrix) {
    const scale = scaleOf(matrix);
    if (this.unit === 1 || !(scale > 0 && scale < Infinity)) return;
    const unit = isOfHeads(scale) ? 1 : this.unit ?? 10 ** Math.round(Math.log10(scale));
    if (unit === this.unit) return;
    this.unit = unit;
    this.bone.rest.makeScale(unit, unit, unit);
    this.fromHead.makeScale(1 / unit, 1 / unit, 1 / unit).multiply(new Matrix4().setPosition(this.bone.origin));
  }

  /** Writes its pose to `hair`, or keeps the last one where the object's matrix gives none. `toLocal`: from the world to the CoifHair. */
  place(hair, toLocal) {
    const { matrixWorld } = this.followed;
    this.#findUnit(matrixWorld);
    this.matrix.multiplyMatrices(matrixWorld, this.fromHead);
    if (this.matrix.determinant() < 0) {
      this.matrix.multiply(mirror);
      this.#warn('mirrored', 'which is mirrored by a negative scale: the hair sits on it as it was modelled, not mirrored');
    }
    const wasPlaced = this.isPlaced;
    this.isPlaced = this.#writePose(hair, matrixWorld);
    this.position.setFromMatrixPosition(this.matrix);
    this.matrix.premultiply(toLocal);
    const { position, rotation, scale } = this;
    if (this.isPlaced && !wasPlaced) hair.teleport(this.number, { position, rotation, scale });
  }

  #writePose(hair, matrixWorld) {
    try {
      hair.writeHeadBone(this.number, matrixWorld, this.bone);
    } catch (error) {
      if (!(error instanceof CoifError)) throw error;
      this.#warn(error.status, `and its hair stands still, since ${error.message}. A rig's own scale belongs to 'rest' of follow()`);
      return false;
    }
    const at = 12 * this.number + 6;
    this.rotation.fromArray(hair.rotations, at);
    this.scale = hair.rotations[at + 4];
    return true;
  }

  /** Once for each fault of each object. */
  #warn(fault, sentence) {
    if (this.warned.has(fault)) return;
    this.warned.add(fault);
    console.warn(`coif/three: head ${this.number} follows '${this.followed.name || this.followed.type}', ${sentence}`);
  }
}
