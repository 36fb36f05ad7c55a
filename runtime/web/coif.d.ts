/**
 * coif: hair for games, simulated in WebAssembly; the same bits as native builds on every machine.
 *
 * All assets, crowds and worlds live in one block of memory, which loadCoif() allocates and which never grows. Typed arrays that functions
 * return are views into it: nothing is copied, and a view stays valid until its asset, crowd or world is disposed of. Each member says when
 * the numbers in its view change. Units: metres, seconds, radians; right-handed, +Y up. Vectors as arguments may be lists or have x, y, z (and w), as
 * three.js' own; returned vectors are lists.
 */

import type { Asset } from './asset.js';

export * from './asset.js';

/** The error of all functions here: a sentence, and the name of the C interface's status. A function that throws changes nothing. */
export class CoifError extends Error {
  readonly status: string;
}

export type Vec3 = ArrayLike<number> | { x: number; y: number; z: number };
/** A 4 x 4 matrix for column vectors, 16 numbers, column after column: three's Matrix4, a node of glTF. */
export type Matrix = ArrayLike<number> | { elements: ArrayLike<number> };
/** Rotation, unit. */
export type Quat = ArrayLike<number> | { x: number; y: number; z: number; w: number };

export interface LoadOptions {
  /** Bytes for all assets, crowds and worlds together: 2 MB to 4 GB, 64 MB by default. Pages that were never written to cost nothing. */
  memoryBytes?: number;
  /** 'crowd': without worlds, the solvers 'character' and 'thesis', and keepsLinks; a bit more than half as large. */
  parts?: 'all' | 'crowd';
  /** coif.wasm: its address, its bytes, or the module. By default the file beside this one. */
  wasm?: string | URL | BufferSource | WebAssembly.Module | Response | Promise<Response>;
}

/** Loads the module. Each call makes a module with its own memory, for one thread. */
export function loadCoif(options?: LoadOptions): Promise<Coif>;

export interface Coif {
  readonly version: string;
  readonly freeBytes: number;
  /** Opens a whole .coif file and keeps a copy of it. For damaged or foreign bytes it throws an error that describes the fault. */
  openAsset(bytes: ArrayBuffer | ArrayBufferView): Asset;
  /** An empty world. Throws if a value of the description is out of range or memory does not suffice, and with the module for crowds. */
  createWorld(desc?: WorldDesc): World;
  /** The part of WorldDesc.hairBytes that this asset takes with so many heads; several assets together take less than the sum. */
  bytesForWorld(asset: Asset, heads: number, desc?: WorldDesc, options?: { crowd?: number }): number;
  /** Share of the viewport's height that `height` metres cover at `distance` metres under a vertical field of view `fov`. */
  screenShare(height: number, distance: number, fov: number): number;
  /** The gusts at a world place, m/s, for a page's own cloth and grass; `way` is Heads.gustsWay. */
  gustAt(gusts: Gusts, way: number, place: Vec3): number[];
  /** The pose of a head that follows a bone of an engine, whose world matrix is `bone` now, so that hair that was modelled around the head
   *  at rest sits on it. A mirrored bone gives an unmirrored pose with the head's top and face where they are. Throws CoifError:
   *  COIF_BAD_ARGUMENT for a number of `headBone`, COIF_BAD_POSE for a matrix that is not finite, or sheared or stretched, COIF_BAD_SCALE
   *  for a head's scale outside of 0.05 to 20. */
  headPose(bone: Matrix, headBone?: HeadBone): Required<HeadPose>;
  /** The functions of coif.h, for features that this interface lacks; addresses refer to wasmMemory. */
  readonly exports: Record<string, (...values: number[]) => number>;
  readonly wasmMemory: WebAssembly.Memory;
}

/** World from head space. */
export interface HeadPose {
  position?: Vec3;
  rotation?: Quat;
  scale?: number; // 0.05 to 20
}
/** What stays the same while a head bone moves; the native interface's coif/head_bone.h says more. */
export interface HeadBone {
  /** The bone's world matrix in the rest pose while the model that the hair was made on stands at the origin, unturned, in its own size: a
   *  rig's scale of 0.01 belongs to it. By default the bone has the axes of head space. */
  rest?: Matrix;
  /** Head space's origin at rest, from the bone's: metres, the model's axes. Needed only if the asset was cooked without this bone. */
  origin?: Vec3;
  metresPerUnit?: number; // of the world: 1; 0.01 for centimetres
  /** How uneven the head's axes may be: 0.01 is one per cent of their length, or a hundredth of a radian; Infinity takes the nearest pose. */
  largestStretch?: number;
}
/** What a crowd and a world are created for. */
export interface Rules {
  solver?: 'coif' | 'thesis' | 'passive' | 'cascade' | 'character';
  longestInterval?: number; // 1, 2 or 4
  dynamicsSets?: number; // 1 to 8
  keepsLinks?: boolean; // keeps the asset's linked chains together
  // For 'character':
  movingColliders?: number; // largest number of colliders of a head
  followsBody?: boolean;
  followsPoses?: boolean;
  hasOwnAir?: boolean;
  feelsGusts?: boolean;
}
export interface HairDesc extends Rules {
  instances?: number; // heads, 1
}
export interface WorldDesc extends Rules {
  assets?: number; // most assets at one time, 32
  heads?: number; // most heads at one time, 128
  hairBytes?: number; // for the data of assets and heads, 4 MB; Coif.bytesForWorld() says how much they need
  instructionSet?: number; // 0
}
export interface StepSettings {
  dt?: number; // seconds, 1/60
  substeps?: number; // 0: the number that the asset was tuned for
  iterations?: number;
  gravity?: Vec3; // world axes, m/s^2; multiplied by each head's scale, so that hair hangs as it was modelled
  wind?: Vec3; // world, m/s
  airFollow?: number;
  stiffness?: number;
  damping?: number;
  friction?: number;
  inertia?: number; // 0 to 1: share of the head's motion that hair feels
  teleportDistance?: number;
  teleportAngle?: number;
  sleepAfter?: number;
  sleepSpeed?: number;
  trueGravity?: boolean; // the same gravity in world metres on heads of every scale; default false
}
export interface MovingCollider {
  shape?: 'sphere' | 'ellipsoid' | 'capsule' | 'plane' | 'tapered-capsule' | 'box';
  center?: Vec3; // world, like all members
  rotation?: Quat;
  axis?: Vec3;
  halfExtents?: Vec3;
  radius?: number;
  endRadius?: number;
  isVelocityKnown?: boolean;
  velocity?: { linear?: Vec3; angular?: Vec3 };
}
export interface HeadAir { wind?: Vec3; exposure?: number }
export interface Gusts { amplitude?: number; length?: number; speed?: number; direction?: Vec3; seed?: number }
export interface Impulse { center?: Vec3; axis?: Vec3; radius?: number; speed?: number; velocity?: Vec3; strokes?: boolean }

/** What crowds and worlds do for their heads. In a crowd a head is its number from 0, in a world what addHead() returned. */
export interface Heads<Head> {
  /** Sets a head's pose at the end of the next step, and its velocity then if it is known: m/s, rad/s, world. The first pose of a crowd's
   *  head puts it there, as World.addHead() does; poses after the next step are movement. */
  setHead(head: Head, pose: HeadPose, velocity?: { linear?: Vec3; angular?: Vec3 }): void;
  /** Puts the head there, with its hair in rest pose and at rest. */
  reset(head: Head, pose?: HeadPose): void;
  /** Puts the head there; the hair keeps its shape. */
  teleport(head: Head, pose: HeadPose): void;
  setDetail(head: Head, detail: { level?: number; interval?: number; simulated?: boolean }): void;
  isAsleep(head: Head): boolean;

  /** Steps all heads by `dt` seconds. */
  step(settings?: StepSettings): void;
  /** Before a scene: lets the hair of these heads come to rest, in up to `seconds`; nothing else moves. */
  settle(heads: Head | ArrayLike<Head>, seconds: number, settings?: StepSettings): void;
  readonly savedBytes: number;
  /** A copy of the state of all heads, for restore(). */
  save(): Uint8Array;
  restore(state: Uint8Array): void;

  /** Skinning matrices from rest to current pose, head space: 12 floats a bone, three rows of four. Changes with step() and reset(). */
  palette(head: Head): Float32Array;
  /** The bones' ends, head space: 3 floats a bone. Valid until the next call on this crowd or world. */
  boneEnds(head: Head): Float32Array;
  /** Each bone relative to its parent, 7 floats: translation, rotation. At rest bones have the axes of head space. Valid until the next call
   *  on this crowd or world. */
  boneTransforms(head: Head): Float32Array;

  // For the solver 'character'; each needs its member of the description.
  /** Replaces the colliders that were set before. Places are those at the end of the next step. */
  setColliders(head: Head, colliders: MovingCollider[]): void;
  /** The pose of each of Asset.bodyBones, world from the bone's own axes. */
  setBody(head: Head, bones: { position: Vec3; rotation: Quat }[]): void;
  /** An animator's pose, 4 floats a bone, and weights, one for each chain or one for all. At weight 1 the hair is simulated and pulled to
   *  the pose, at 0 it is the pose. Without rotations and weights: the rest pose again. */
  setPose(head: Head, rotations?: ArrayLike<number>, weights?: ArrayLike<number>): void;
  setAir(head: Head, air: HeadAir): void;
  setGusts(gusts: Gusts): void;
  readonly gustsWay: number;

  setDynamics(set: number, scale: { stiffness?: number; damping?: number; friction?: number }): void;
  chooseDynamics(head: Head, set: number): void;
  /** Changes the hair's speed at once, in a ball or a capsule. */
  push(head: Head, impulse: Impulse): void;
  /** Frees the memory; its views then show other data. */
  dispose(): void;
}

/** A crowd of heads that wear one asset. Heads begin in their rest pose at the world's origin. */
export interface Hair extends Heads<number> {
  readonly instances: number;
  readonly boneCount: number;

  /** As setHead() for all heads at once: call writeHead() for those that moved, then setHeads(). Neither creates an object. A head that was
   *  never written stands upright at the origin, so write all heads before the first setHeads(). */
  writeHead(instance: number, position: Vec3, rotation: Quat, scale?: number): void;
  /** As writeHead(), from a bone: see Coif.headPose(). After an error the head keeps the pose that was written last. */
  writeHeadBone(instance: number, bone: Matrix, headBone?: HeadBone): void;
  setHeads(): void;
  /** The input of setHeads(), for code that writes it directly: head i's position is positions[6 i] to [6 i + 2]; its rotation x, y, z, w
   *  and scale are rotations[12 i + 6] to [12 i + 10]. */
  readonly positions: Float64Array;
  readonly rotations: Float32Array;
}

/** A head in a world, until World.removeHead(). It is passed to the world's functions, which throw COIF_BAD_INDEX after that. */
export interface WorldHead {
  readonly asset: Asset;
}

/** Heads with hair of many assets, which come and go between steps. Each head has the bits that it has in a crowd. Steps and functions for
 *  single heads take no memory; addAsset(), settle(), save() and restore() may take some beside the world's own. */
export interface World extends Heads<WorldHead> {
  /** Makes room for heads with this asset, once in each world. `crowd`: about how many will wear it at a time, or 0 for few; it changes
   *  speed and memory alone. Throws COIF_MEMORY_TOO_SMALL where the description's assets or hairBytes are used up. */
  addAsset(asset: Asset, options?: { crowd?: number }): void;
  /** Throws COIF_BAD_ARGUMENT while heads wear it. */
  removeAsset(asset: Asset): void;
  hasAsset(asset: Asset): boolean;
  /** Adds a head at this pose, with its hair in the rest pose, at rest. Later poses are movement. */
  addHead(asset: Asset, pose?: HeadPose): WorldHead;
  /** Views of its matrices then show other data. */
  removeHead(head: WorldHead): void;
  hasHead(head: WorldHead): boolean;
}
