// Times VRMSpringBoneManager.update() of three-vrm-springbone on the crowds of ../workload.h, and prints what
// Google Benchmark would: {"benchmarks": [...]}, medians over repetitions of the median frame.
//   node spring_bones.mjs REPETITIONS FRAMES [--cpu]    (in a folder where `npm ci` has run)
// --cpu: the process's own time, for a machine that does other things, which interrupt long frames.
import { readFileSync } from 'node:fs';
import * as THREE from 'three';
import {
  VRMSpringBoneCollider, VRMSpringBoneColliderShapeSphere, VRMSpringBoneJoint, VRMSpringBoneManager,
} from '@pixiv/three-vrm-springbone';

const FRAME = 1 / 60;        // s
const WARM_UP = 300;         // frames; the JIT has then seen everything
const BONE = 0.08;           // m
const HEAD_RADIUS = 0.1;     // m
const OUTWARDS = 0.2;        // of a bone's length
const JOINT = { hitRadius: 0.01, stiffness: 1, gravityPower: 0.5, dragForce: 0.4 };
const WORKLOADS = { a: { heads: 200, chains: 3, bones: 3 }, b: { heads: 1, chains: 100, bones: 16 } };

function addChild(parent, x, y, z) {
  const child = new THREE.Object3D();
  child.position.set(x, y, z);
  parent.add(child);
  return child;
}

/** One chain as pairs [bone, its tail]. */
function growChain(head, angle, bones) {
  const [s, c] = [Math.sin(angle), Math.cos(angle)];
  const down = -Math.sqrt(1 - OUTWARDS * OUTWARDS);
  const segments = [];
  let bone = addChild(head, HEAD_RADIUS * s, 0.02, HEAD_RADIUS * c);
  for (let depth = 0; depth < bones; ++depth) {
    const tail = addChild(bone, BONE * OUTWARDS * s, BONE * down, BONE * OUTWARDS * c);
    segments.push([bone, tail]);
    bone = tail;
  }
  return segments;
}

function makeHead({ chains, bones }) {
  const head = new THREE.Object3D();
  const sphere = new VRMSpringBoneCollider(new VRMSpringBoneColliderShapeSphere({ radius: HEAD_RADIUS }));
  head.add(sphere);
  const manager = new VRMSpringBoneManager();
  const segments = [];
  for (let chain = 0; chain < chains; ++chain) segments.push(...growChain(head, 2 * Math.PI * chain / chains, bones));
  head.updateMatrixWorld(true);
  for (const [bone, tail] of segments) {
    manager.addJoint(new VRMSpringBoneJoint(bone, tail, JOINT, [{ colliders: [sphere] }]));
  }
  manager.setInitState();
  return { head, manager };
}

/** As head_pose_at() of ../workload.h. */
function moveHead(head, index, seconds) {
  const turn = 2 * Math.PI * seconds;
  head.position.set(2 * (index % 15) + 0.3 * Math.sin(0.5 * turn + index), 1.6, 2 * Math.floor(index / 15));
  head.rotation.set(0, Math.sin(0.7 * turn + index), 0);
}

function medianOf(values) {
  return values.toSorted((x, y) => x - y)[values.length >> 1];
}

const ownTime = () => {
  const { user, system } = process.cpuUsage();
  return BigInt(user + system) * 1000n;
};
const now = process.argv.includes('--cpu') ? ownTime : process.hrtime.bigint;

/** Median nanoseconds that update() of all heads takes. */
function timeFrames(crowd, clock, frames) {
  const times = [];
  for (let frame = 0; frame < frames; ++frame) {
    clock.seconds += FRAME;
    crowd.forEach(({ head }, index) => moveHead(head, index, clock.seconds));
    const before = now();
    for (const { manager } of crowd) manager.update(FRAME);
    times.push(Number(now() - before));
  }
  return medianOf(times);
}

function timeWorkload(name, shape, solver, repetitions, frames) {
  const crowd = Array.from({ length: shape.heads }, () => makeHead(shape));
  const clock = { seconds: 0 };
  timeFrames(crowd, clock, WARM_UP);
  const nanoseconds = medianOf(Array.from({ length: repetitions }, () => timeFrames(crowd, clock, frames)));
  const perBone = nanoseconds / (shape.heads * shape.chains * shape.bones);
  return {
    name: `peer_${name}_three_vrm/manual_time_median`, aggregate_name: 'median', repetitions, label: solver, ...shape,
    substeps: 1, step_ns_per_bone: perBone, us_per_frame: nanoseconds / 1e3,
  };
}

const [repetitions, frames] = [Number(process.argv[2] ?? 5), Number(process.argv[3] ?? 120)];
const packageFile = new URL('./node_modules/@pixiv/three-vrm-springbone/package.json', import.meta.url);
const solver = `three-vrm-springbone-${JSON.parse(readFileSync(packageFile)).version} node`;
const benchmarks = Object.entries(WORKLOADS).map(
  ([name, shape]) => timeWorkload(name, shape, solver, repetitions, frames));
console.log(JSON.stringify({ benchmarks }, null, 1));
