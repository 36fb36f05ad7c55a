/**
 * coif: hair for games, simulated in WebAssembly; the same bits as native builds on every machine.
 *
 * All assets and crowds live in one block of memory, which loadCoif() allocates and which never grows. Typed arrays that functions return
 * are views into it: nothing is copied, and a view stays valid until its asset or crowd is disposed of. Each member says when the numbers
 * in its view change. Units: metres, seconds, radians; right-handed, +Y up. Vectors as arguments may be lists or have x, y, z (and w), as
 * three.js' own; returned vectors are lists.
 */

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
  /** Bytes for all assets and crowds together: 2 MB to 4 GB, 64 MB by default. Pages that were never written to cost nothing. */
  memoryBytes?: number;
  /** 'crowd': without the solvers 'character' and 'thesis', and without keepsLinks; a bit more than half as large. */
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
  /** Share of the viewport's height that `height` metres cover at `distance` metres under a vertical field of view `fov`. */
  screenShare(height: number, distance: number, fov: number): number;
  /** The gusts at a world place, m/s, for a page's own cloth and grass; `way` is Hair.gustsWay. */
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

export interface Bone {
  name: string;
  parent: number; // -1: none
  kind: number; // 0: head, 1: rigid with it, 2: simulated
  chain: number; // -1: none
  joint: number[]; // start at rest, head space
  length: number;
  restDirection: number[];
  colliders: number; // bit i: may touch collider i
}
export interface Skeleton {
  boneCount: number;
  simulatedCount: number;
  chainCount: number;
  flags: number; // 1: the face looks along -Z at rest
  headJoint: number[]; // in the source model
  headRotation: number[]; // from the head bone's own axes to the model's
  airLag: number;
}
export interface Chain { firstBone: number; boneCount: number; root: number; model: number }
export interface Limit { kind: number; angles: number[]; rotation: number[] }
export interface Link { bone: number; to: number; shortest: number; longest: number }
export interface AssetCollider { shape: number; bone: number; flags: number; center: number[]; radii: number[]; rotation: number[]; axis: number[] }
export interface BodyBone { name: string; joint: number[]; rotation: number[] }
export interface Patch { firstIndex: number; indexCount: number; headDistance: number; bone: number; filePlace: number }

/** Colours are linear. */
export interface Material {
  baseColor: number[]; ambient: number[]; opaqueThreshold: number; primaryColor: number[]; primaryExponent: number;
  secondaryColor: number[]; secondaryExponent: number; primaryShift: number; secondaryShift: number; discardThreshold: number;
  flags: number; // 1: double-sided, 2: both faces together
  shading: number; // 0: thesis, 1: Kajiya-Kay, 2: Marschner, 3: volume
  tilt: number; roughness: number; scatter: number; lightCut: number;
  glow: number; rootShade: number; variation: number;
}
export interface Texture {
  format: 'srgb8-alpha8' | 'rg8' | 'rg11-eac' | 'srgb8-alpha8-etc2';
  width: number;
  height: number;
  /** Texels of each level, the finest and the first row first: views. */
  mips: Uint8Array[];
}

/** A cooked asset. Each access to a list of objects makes a new list; typed arrays are views. */
export interface Asset {
  readonly byteLength: number;
  readonly skeleton: Skeleton;
  readonly bones: Bone[];
  readonly chains: Chain[];
  readonly limits: Limit[];
  readonly links: Link[];
  readonly colliders: AssetCollider[];
  readonly bodyBones: BodyBone[];
  readonly bodyColliders: AssetCollider[];
  boneName(bone: number): string;
  /** Sub-steps of a step of `dt` seconds if the settings have no `substeps`. */
  tunedSubsteps(dt: number): number;

  /** 36 bytes a vertex, rest pose, head space: position (3 x float), normal and tangent (4 x snorm16), uv (2 x float). */
  readonly vertices: Uint8Array;
  /** 12 bytes a vertex: bones (4 x uint16), weights (4 x unorm8). Empty: rigid hair. */
  readonly skin: Uint8Array;
  /** Triangles of all levels; keep their order. */
  readonly indices: Uint32Array;
  readonly patches: Patch[];
  readonly lodCount: number;
  lodIndices(lod: number): Uint32Array;
  /** The level for a head that covers this share of the viewport's height and was drawn at level `current`. */
  chooseLod(share: number, current: number, hysteresis?: number): number;
  readonly material: Material | null;
  texture(role: 'base-color' | 'shift-mask' | 'normal-map' | 'strand-map'): Texture | null;
  /** Compares all drawn data with its hashes, which openAsset() does not. Throws if bytes were changed. */
  verifyDrawData(): void;
  /** Throws for an asset without a mesh. */
  drawnHair(): DrawnHair;

  /** Throws if a value of the description is out of range or memory does not suffice. */
  createHair(desc?: HairDesc): Hair;
  /** Frees the memory. Throws while a crowd or drawn hair of this asset exists. */
  dispose(): void;
}

export interface DrawnHair {
  readonly lods: { first: number; count: number }[]; // indices in the stored order
  readonly orderCount: number;
  readonly indicesOfOrder: number;
  readonly indexBytes: 2 | 4;
  readonly reach: { center: number[]; radius: number }; // a sphere that hair never leaves, head space
  readonly alpha: { lowest: number; highest: number };
  readonly skinning: number; // 0: rigid, 1: one bone, 2: four
  readonly material: Material;
  /** Indices of all draw orders: level l of order k begins at k * indicesOfOrder + lods[l].first. A view, the same each time. */
  drawOrders(): Uint16Array | Uint32Array;
  /** The order for a viewing direction: from head to eye, head space, of any length. */
  chooseOrder(direction: Vec3): number;
  /** The draw order of a head; -1 if it is certainly out of view. `eye`: world; `clipFromView`: column-major. */
  orderInView(head: HeadPose, eye: Vec3, clipFromView: ArrayLike<number>): number;
  /** Skins on the processor with a palette from Hair.palette(): position, normal, tangent, 9 floats per vertex. Valid until the next call. */
  skinVertices(palette: Float32Array): Float32Array;
  /** The box around the hair in this pose, head space. */
  bound(palette: Float32Array): { lowest: number[]; highest: number[] };
  dispose(): void;
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
export interface HairDesc {
  instances?: number; // heads, 1
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

/** A crowd of heads that wear one asset. Heads begin in their rest pose at the world's origin. */
export interface Hair {
  readonly instances: number;
  readonly boneCount: number;

  /** Sets a head's pose at the end of the next step, and its velocity then if it is known: m/s, rad/s, world. The
   *  first pose of a head puts it there; poses after the next step are movement. */
  setHead(instance: number, pose: HeadPose, velocity?: { linear?: Vec3; angular?: Vec3 }): void;
  /** The same for all heads at once: call writeHead() for those that moved, then setHeads(). Neither creates an object. A head that was
   *  never written stands upright at the origin, so write all heads before the first setHeads(). */
  writeHead(instance: number, position: Vec3, rotation: Quat, scale?: number): void;
  /** As writeHead(), from a bone: see Coif.headPose(). After an error the head keeps the pose that was written last. */
  writeHeadBone(instance: number, bone: Matrix, headBone?: HeadBone): void;
  setHeads(): void;
  /** The input of setHeads(), for code that writes it directly: head i's position is positions[6 i] to [6 i + 2]; its rotation x, y, z, w
   *  and scale are rotations[12 i + 6] to [12 i + 10]. */
  readonly positions: Float64Array;
  readonly rotations: Float32Array;
  /** Puts the head there, with its hair in rest pose and at rest. */
  reset(instance: number, pose?: HeadPose): void;
  /** Puts the head there; the hair keeps its shape. */
  teleport(instance: number, pose: HeadPose): void;
  setDetail(instance: number, detail: { level?: number; interval?: number; simulated?: boolean }): void;
  isAsleep(instance: number): boolean;

  /** Steps all heads by `dt` seconds. */
  step(settings?: StepSettings): void;
  /** Before a scene: lets the hair of these heads come to rest, in up to `seconds`; nothing else moves. */
  settle(instances: number | ArrayLike<number>, seconds: number, settings?: StepSettings): void;
  readonly savedBytes: number;
  /** A copy of the crowd's state, for restore(). */
  save(): Uint8Array;
  restore(state: Uint8Array): void;

  /** Skinning matrices from rest to current pose, head space: 12 floats a bone, three rows of four. Changes with step() and reset(). */
  palette(instance: number): Float32Array;
  /** The bones' ends, head space: 3 floats a bone. Valid until the next call on this hair. */
  boneEnds(instance: number): Float32Array;
  /** Each bone relative to its parent, 7 floats: translation, rotation. At rest bones have the axes of head space. Valid until the next call
   *  on this hair. */
  boneTransforms(instance: number): Float32Array;

  // For the solver 'character'; each needs its member of the description.
  /** Replaces the colliders that were set before. Places are those at the end of the next step. */
  setColliders(instance: number, colliders: MovingCollider[]): void;
  /** The pose of each of Asset.bodyBones, world from the bone's own axes. */
  setBody(instance: number, bones: { position: Vec3; rotation: Quat }[]): void;
  /** An animator's pose, 4 floats a bone, and weights, one for each chain or one for all. At weight 1 the hair is simulated and pulled to
   *  the pose, at 0 it is the pose. Without rotations and weights: the rest pose again. */
  setPose(instance: number, rotations?: ArrayLike<number>, weights?: ArrayLike<number>): void;
  setAir(instance: number, air: HeadAir): void;
  setGusts(gusts: Gusts): void;
  readonly gustsWay: number;

  setDynamics(set: number, scale: { stiffness?: number; damping?: number; friction?: number }): void;
  chooseDynamics(instance: number, set: number): void;
  /** Changes the hair's speed at once, in a ball or a capsule. */
  push(instance: number, impulse: Impulse): void;
  /** Frees the memory; its views then show other data. */
  dispose(): void;
}
