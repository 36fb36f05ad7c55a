import type { Asset, HairDesc, StepSettings } from './coif.js';

/** What is used of a model of @pixiv/three-vrm. */
export interface VrmModel {
  scene: object;
  humanoid?: object | null;
  springBoneManager?: object | null;
}

export interface SpringOptions {
  /** Wind, gravity, stiffness and so on of every step; may be changed later in SimulatedHair.settings. */
  settings?: Omit<StepSettings, 'dt'>;
  /** Besides what the asset's body colliders ask for. */
  desc?: Omit<HairDesc, 'instances'>;
}

/**
 * From now on coif moves those nodes of the model that the asset has bones for; the model's own springs leave them alone and go on with
 * others. `vrm.update(delta)` steps it; for a model without spring bones, call update() after the head was moved.
 *
 * The asset is cooked of the same file (`coif cook model.vrm -o model.coif`). Throws a CoifError where the model lacks a bone of the
 * asset, or has it elsewhere: then nothing has changed. One asset may serve any number of models that were loaded of that file.
 */
export function replaceSpringBones(vrm: VrmModel, asset: Asset, options?: SpringOptions): SimulatedHair;

export interface SimulatedHair {
  settings: StepSettings;
  /** Takes the head from the model, steps, and turns the nodes. */
  update(delta: number): void;
  /** Rest pose, at rest, where the head is now: after the model was put somewhere else. */
  reset(): void;
  /** Gives the nodes back to the model's own springs. */
  dispose(): void;
}
