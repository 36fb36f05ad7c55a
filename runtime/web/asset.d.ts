// Cooked assets and what is drawn of them; a part of coif.d.ts, which says what all functions have in common.

import type { Hair, HairDesc, HeadPose, Vec3 } from './coif.js';

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
  /** Frees the memory. Throws while a crowd or drawn hair of this asset exists, or a world has it. */
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
