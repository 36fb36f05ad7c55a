// Hair drawn by three's WebGLRenderer (WebGL 2): coif's simulation, order of triangles, transparency and shading, with the scene's own
// lights, shadows, fog, tone mapping and colour space.

import type { Camera, Object3D } from 'three';
import type { Asset, DrawnHair, Hair, HairDesc, Material, StepSettings } from './coif.js';

/** blend: as the asset was cooked for, in up to four passes; soft edges, right order. opaque: cut at the material's threshold. hashed,
 * bayer: thinned, pixel by pixel. coverage: alpha to coverage, for a renderer with `antialias`. */
export type Transparency = 'blend' | 'opaque' | 'hashed' | 'bayer' | 'coverage';

export interface CoifHairOptions {
  /** Heads that wear the asset; 1. All are drawn at once where they share a level of detail and an order of triangles. */
  instances?: number;
  transparency?: Transparency;
  /** Members of Hair's description but `instances`, as the solver. */
  desc?: Partial<Omit<HairDesc, 'instances'>>;
  /** Of every step. */
  settings?: Partial<Omit<StepSettings, 'dt'>>;
  /** In place of the asset's own; `ambient` is not read: the scene's lights are. */
  material?: Partial<Material>;
}

/** Place it into the scene, once for all its heads. Units are metres. Its own matrix is the place of heads that follow nothing. */
export class CoifHair extends Object3D {
  /** `asset` must have a mesh and outlives this. CoifError where the module's memory is too small, or as createHair(). */
  constructor(asset: Asset, options?: CoifHairOptions);

  readonly isObject3D: true;
  /** The crowd, for colliders, poses, gusts and all else of the simulation. */
  readonly hair: Hair;
  readonly drawn: DrawnHair;
  /** Of every step; members may be changed. */
  settings: Partial<StepSettings>;
  /** May be set; the passes are made anew. RangeError for a way that there is not. */
  transparency: Transparency;
  /** Whether hair throws shadows, and has them thrown onto it; from the next `transparency` on. Both true. */
  casts: boolean;
  receives: boolean;

  /** From the next update on the head is where `object` is, of which head space must be a part: an object at the head's joint with the
   * model's axes, such as a bone of a skeleton that rests unturned. Without one: where this object is. RangeError. */
  follow(head: number, object?: Object3D): void;
  /** Once a frame, before it is rendered: heads go where they are now, `delta` seconds pass, and triangles are ordered for `camera`. */
  update(delta: number, camera: Camera): void;
  /** The rest pose where heads are now; after cuts and jumps. The first update() begins so. */
  reset(): void;
  /** Changes members of the material: colours, exponents, thresholds, shading. */
  updateMaterial(changes: Partial<Material>): void;
  /** Frees what it took of the module's memory and of the GPU. The asset stays open. */
  dispose(): void;
}
