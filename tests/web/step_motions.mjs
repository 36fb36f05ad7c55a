// What step_motions.cpp prints, by the package.

import { readFileSync } from 'node:fs';
import { basename } from 'node:path';

const FRAMES = 150;
const DELAY = 30;
const POSE_BYTES = 48;
const SOLVERS = ['coif', 'thesis', 'passive', 'cascade', 'character'];
const MOTIONS = ['still', 'nod', 'turn', 'charge', 'run', 'jump', 'tumble', 'teleport', 'bow', 'lie', 'jog'];

class Hash {
  first = 2166136261;
  second = 1;
  add(floats) {
    for (const word of new Uint32Array(floats.buffer, floats.byteOffset, floats.length)) {
      this.first = Math.imul(this.first ^ word, 16777619);
      this.second = Math.imul((this.second + word) | 0, 2246822507);
      this.second ^= this.second >>> 13;
    }
  }
  get text() {
    return [this.first, this.second].map((word) => (word >>> 0).toString(16).padStart(8, '0')).join('');
  }
}

function bringCompany(hair, position, i) {
  const center = position.map((each, k) => each + (k === 1 ? -0.0625 : 0.125));
  hair.setColliders(i, [{ center, radius: 0.0625 }]);
  hair.setAir(i, { wind: [0.5, 0.25, 0], exposure: 0.75 });
  const body = hair.asset.bodyBones;
  if (body.length > 0) {
    hair.setBody(i, body.map(({ joint, rotation }) => ({ position: position.map((each, k) => each + joint[k]), rotation })));
  }
}

function play(asset, solver, poses) {
  const isWorn = solver === 'character';
  const hair = asset.createHair({ instances: 2, solver, keepsLinks: solver !== 'thesis',
    ...(isWorn && { movingColliders: 1, hasOwnAir: true, feelsGusts: true, followsBody: true }) });
  if (isWorn) hair.setGusts({ amplitude: 1.5 });
  const hash = new Hash();
  for (let frame = 0; frame < FRAMES; ++frame) {
    const heads = [frame, frame < DELAY ? 0 : frame - DELAY].map((each, i) => {
      const at = poses.byteOffset + each * POSE_BYTES;
      const position = [...new Float64Array(poses.buffer, at, 3)];
      hair.writeHead(i, position, new Float32Array(poses.buffer, at + 24, 4), i === 0 ? 1 : 1.5);
      return position;
    });
    hair.setHeads();
    if (isWorn) heads.forEach((position, i) => bringCompany(hair, position, i));
    hair.step();
    hash.add(hair.palette(0));
    hash.add(hair.palette(1));
  }
  hair.dispose();
  return hash.text;
}

/** The lines for these files; `posesFile` is what `step_motions poses` wrote. */
export function hashLines(coif, posesFile, files) {
  const poses = new Uint8Array(readFileSync(posesFile)).slice();
  return files.flatMap((file) => {
    const asset = coif.openAsset(readFileSync(file));
    const lines = SOLVERS.flatMap((solver) => MOTIONS.map((motion, i) => {
      const path = poses.subarray(i * FRAMES * POSE_BYTES, (i + 1) * FRAMES * POSE_BYTES);
      return `${basename(file, '.coif')} ${solver} ${motion} ${play(asset, solver, path)}`;
    }));
    asset.dispose();
    return lines;
  });
}
