// Hair drawn by three's WebGLRenderer (WebGL 2): coif's simulation, order of triangles, transparency and shading, with the scene's own
// lights, shadows, fog, tone mapping and colour space. Needs three 0.157 or later.

import type { Camera, Object3D } from 'three';
import type { Asset, DrawnHair, Hair, HairDesc, Material, Matrix, StepSettings, Vec3 } from './coif.js';

/** blend: soft edges in the cooked order, in up to four passes. opaque: cut at the material's threshold. hashed, bayer: leave out single
 * pixels. coverage: alpha to coverage, for a renderer with `antialias`. */
export type Transparency = 'blend' | 'opaque' | 'hashed' | 'bayer' | 'coverage';

export interface CoifHairOptions {
  /** Heads that wear the asset, by default 1. Heads with the same level of detail and triangle order share draw calls. */
  instances?: number;
  transparency?: Transparency;
  /** Members of HairDesc except `instances`, for example the solver. */
  desc?: Partial<Omit<HairDesc, 'instances'>>;
  /** The settings of every step. */
  settings?: Partial<Omit<StepSettings, 'dt'>>;
  /** Replaces members of the asset's material; `ambient` is ignored in favour of the scene's lights. */
  material?: Partial<Material>;
}

/** Add one object to the scene for all heads. Units are metres. Heads that follow no object are at this object's own place. */
export class CoifHair extends Object3D {
  /** `asset` must have a mesh and outlive this object. Throws CoifError if the module's memory is too small or three is older than 0.157, or
   * as createHair(). */
  constructor(asset: Asset, options?: CoifHairOptions);

  readonly isObject3D: true;
  /** The crowd, for colliders, poses, gusts and everything else of the simulation. */
  readonly hair: Hair;
  readonly drawn: DrawnHair;
  /** The settings of every step; members may be changed. */
  settings: Partial<StepSettings>;
  /** Setting it makes new passes. RangeError for an unknown value. */
  transparency: Transparency;
  /** Whether hair casts and receives shadows, from the next change of `transparency` on. Both true by default. */
  casts: boolean;
  receives: boolean;

  /** From the next update on the head follows `object`, by default this object. `rest` is the object's matrixWorld in the rest pose, while
   * the model that the hair was made on stands at the origin, unturned, in its own size; it is copied. Its rotation and scale are taken out:
   * `hair.follow(0, bone, { rest: bone.matrixWorld })` right after loading, before anything moves. `origin` as in HeadBone.
   *
   * Without `rest` the object must have the model's axes at rest, such as a bone without a rotation, and its world scale is the head's. A
   * scale that no head has (below 0.05 or above 20) at the first update counts as the unit of a rig, rounded to a power of ten (0.01:
   * centimetres), until the scale is one of a head.
   *
   * Hair on a mirrored head (a negative scale, which `rest` does not have) is not mirrored, and sits with its top and its face where the
   * head's are. While the object's matrix gives no pose (a scale of 0, a NaN) the hair stands still relative to the head. Each of these
   * warns once in the console. Throws RangeError for an unknown head, and for a `rest` without an inverse. */
  follow(head: number, object?: Object3D, bone?: { rest?: Matrix; origin?: Vec3 }): void;
  /** Call once per frame before rendering: moves heads to their present places, steps by `delta`, sorts triangles for `camera`. `delta` is the
   * time since the last call in seconds, however long it is; the first call brings the hair to rest instead. */
  update(delta: number, camera: Camera): void;
  /** Puts the hair into its rest pose at the heads' present places, for cuts and jumps. The first update() does so, too. */
  reset(): void;
  /** Changes members of the material: colours, exponents, thresholds, shading. */
  updateMaterial(changes: Partial<Material>): void;
  /** Frees its memory in the module and on the GPU. The asset stays open. */
  dispose(): void;
}
