import type { Asset, HairDesc, StepSettings } from './coif.js';

/** The used members of a model of @pixiv/three-vrm. */
export interface VrmModel {
  scene: object;
  humanoid?: object | null;
  springBoneManager?: object | null;
}

export interface SpringOptions {
  /** Wind, gravity, stiffness and so on of every step; may be changed later in SimulatedHair.settings. */
  settings?: Omit<StepSettings, 'dt'>;
  /** Added to the members that the asset's body colliders need. */
  desc?: Omit<HairDesc, 'instances'>;
}

/**
 * Lets coif move the model's nodes for which the asset has bones; the model's own springs move only their other nodes from now on.
 * `vrm.update(delta)` steps the hair. For a model without spring bones, call update() after the head has moved.
 *
 * The asset must be cooked from the same file (`coif cook model.vrm -o model.coif`). Throws a CoifError and changes nothing if the model
 * lacks a bone of the asset or has it in another place. One asset may serve any number of models that were loaded from that file.
 *
 * A model that is mirrored (a negative scale) and its `settings.wind` are simulated as their mirror image. Gusts are not mirrored.
 */
export function replaceSpringBones(vrm: VrmModel, asset: Asset, options?: SpringOptions): SimulatedHair;

export interface SimulatedHair {
  settings: StepSettings;
  /** Reads the head's pose from the model, steps, and turns the nodes. */
  update(delta: number): void;
  /** Brings the hair to rest in its rest pose at the head's present place, for a model that was put somewhere else. */
  reset(): void;
  /** Gives the nodes back to the model's own springs. */
  dispose(): void;
}
