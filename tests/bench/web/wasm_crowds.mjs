// Times step() of the package for the web on the crowds of ../workload.h, and prints what Google Benchmark would:
// {"benchmarks": [...]}, medians over repetitions of the median frame.
//   node wasm_crowds.mjs PACKAGE WORKLOADS REPETITIONS FRAMES     (folders: of coif.mjs; of what coif_write_workloads wrote)
import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const FRAME = 1 / 60;  // s
const WARM_UP = 1000;  // frames; node has then compiled everything at its best
const WORKLOADS = { a: { heads: 200, chains: 3, bones: 3 }, b: { heads: 1, chains: 100, bones: 16 } };

/** As head_pose_at() of ../workload.h. */
function moveHead(hair, index, seconds) {
  const turn = 2 * Math.PI * seconds;
  const yaw = Math.sin(0.7 * turn + index) / 2;
  const place = [2 * (index % 15) + 0.3 * Math.sin(0.5 * turn + index), 1.6, 2 * Math.floor(index / 15)];
  hair.writeHead(index, place, [0, Math.sin(yaw), 0, Math.cos(yaw)]);
}

const medianOf = (values) => values.toSorted((x, y) => x - y)[values.length >> 1];

/** Median nanoseconds that step() takes. */
function timeFrames(hair, clock, frames) {
  const settings = { dt: FRAME, substeps: 1 };
  const times = [];
  for (let frame = 0; frame < frames; ++frame) {
    clock.seconds += FRAME;
    for (let head = 0; head < hair.instances; ++head) moveHead(hair, head, clock.seconds);
    hair.setHeads();
    const before = process.hrtime.bigint();
    hair.step(settings);
    times.push(Number(process.hrtime.bigint() - before));
  }
  return medianOf(times);
}

const [folder, workloads, repetitions, frames] = [process.argv[2], process.argv[3], Number(process.argv[4] ?? 5), Number(process.argv[5] ?? 120)];
const { loadCoif } = await import(pathToFileURL(join(resolve(folder), 'coif.mjs')));
const coif = await loadCoif();

function timeWorkload(name, shape) {
  const hair = coif.openAsset(readFileSync(join(workloads, `${name}.coif`))).createHair({ instances: shape.heads });
  const clock = { seconds: 0 };
  timeFrames(hair, clock, WARM_UP);
  const nanoseconds = medianOf(Array.from({ length: repetitions }, () => timeFrames(hair, clock, frames)));
  return {
    name: `peer_${name}_wasm/manual_time_median`, aggregate_name: 'median', repetitions, label: `coif wasm node-${process.versions.node}`,
    ...shape, substeps: 1, step_ns_per_bone: nanoseconds / (shape.heads * shape.chains * shape.bones), us_per_frame: nanoseconds / 1e3,
  };
}

const benchmarks = Object.entries(WORKLOADS).map(([name, shape]) => timeWorkload(name, shape));
console.log(JSON.stringify({ benchmarks }, null, 1));
