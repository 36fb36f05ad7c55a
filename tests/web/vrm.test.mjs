// coif/vrm on artists' models, loaded by three-vrm: hair goes as coif has it, everything else as before.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { test } from 'node:test';
import { loadCoif } from 'coif';
import { replaceSpringBones } from 'coif/vrm';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { loadVrm } from './vrm_file.mjs';

const folder = join(process.env.COIF_TEST_ASSETS, 'hair');
const FILES = ['churro/ChurroChurro.vrm', 'godette/Godette_vrm_v4.vrm'].map((name) => join(folder, name));

/** World rotation of each bone's node at the start, by the bone's index. */
const rotationOf = (node) => node.getWorldQuaternion(new Quaternion());

function pose(vrm, frame) {
  const angle = Math.sin(frame / 12);
  vrm.humanoid.getNormalizedBoneNode('head').rotation.set(0.2 * angle, angle, 0);
  vrm.humanoid.getNormalizedBoneNode('hips').position.x = 0.1 * angle;
}

/** Rotations of the palette's matrices, world, from the head's. */
function turnOf(palette, bone) {
  const m = palette.subarray(12 * bone, 12 * bone + 12);
  return new Quaternion().setFromRotationMatrix(new Matrix4().set(...m.slice(0, 3), 0, ...m.slice(4, 7), 0, ...m.slice(8, 11), 0, 0, 0, 0, 1));
}

async function replaced(file) {
  const cooked = `assets/${basename(file, '.vrm')}.coif`;
  execFileSync(process.env.COIF, ['cook', file, '--draft', '-o', cooked], { stdio: 'ignore' });
  const coif = await loadCoif();
  const vrm = await loadVrm(file);
  const asset = coif.openAsset(readFileSync(cooked));
  return { coif, vrm, asset, springs: vrm.springBoneManager };
}

const angleTo = (a, b) => 2 * Math.asin(Math.min(1, Math.hypot(a.x - b.x * s(a, b), a.y - b.y * s(a, b), a.z - b.z * s(a, b), a.w - b.w * s(a, b)) / 2));
const s = (a, b) => (a.dot(b) < 0 ? -1 : 1);

function checkModel(file) {
  test(`${basename(file)}: nodes are turned as coif's bones are`, async () => {
    const { vrm, asset, springs } = await replaced(file);
    vrm.scene.updateWorldMatrix(true, true);
    vrm.scene.rotation.y = 0.4; // wherever the model stands
    vrm.scene.position.set(3, 0, -2);
    vrm.scene.updateWorldMatrix(true, true);
    springs.reset();
    const nodes = new Map();
    vrm.scene.traverse((node) => nodes.set(node.userData.name ?? node.name, node));
    const bones = asset.bones.map((bone, i) => ({ i, node: nodes.get(bone.name), kind: bone.kind })).filter(({ kind }) => kind === 2);
    const head = vrm.humanoid.getRawBoneNode('head');
    const atRest = bones.map(({ node }) => rotationOf(head).invert().multiply(rotationOf(node)));
    const joints = springs.joints.size;
    const hair = replaceSpringBones(vrm, asset);
    assert.ok(springs.joints.size < joints, 'they are no longer moved by the model\'s own springs');
    const toModel = new Quaternion().fromArray(asset.skeleton.headRotation);

    let worst = 0;
    let farthest = 0;
    for (let frame = 0; frame < 120; ++frame) {
      pose(vrm, frame);
      vrm.update(1 / 60);
      vrm.scene.updateWorldMatrix(true, true);
      const headSpace = rotationOf(head).multiply(toModel.clone().invert());
      bones.forEach(({ i, node }, k) => {
        const turn = turnOf(hair.hair.palette(0), i);
        const expected = headSpace.clone().multiply(turn).multiply(toModel).multiply(atRest[k]);
        worst = Math.max(worst, angleTo(rotationOf(node), expected));
        farthest = Math.max(farthest, angleTo(turn, new Quaternion()));
      });
      for (const { i, node } of bones) { // and joints are where coif has them
        const start = new Vector3(...asset.bones[i].joint);
        const m = hair.hair.palette(0).subarray(12 * i, 12 * i + 12);
        const moved = new Vector3(...[0, 4, 8].map((row) => m[row] * start.x + m[row + 1] * start.y + m[row + 2] * start.z + m[row + 3]));
        const world = moved.applyQuaternion(headSpace).add(head.getWorldPosition(new Vector3()));
        assert.ok(world.distanceTo(node.getWorldPosition(new Vector3())) < 2e-5, `${node.name} in frame ${frame}`);
      }
    }
    assert.ok(worst < 1e-5, `off by ${worst} radians`);
    assert.ok(farthest > 0.02, `nothing moved: ${farthest}`);

    hair.dispose();
    assert.equal(springs.joints.size, joints);
    vrm.update(1 / 60);
    asset.dispose();
  });

  test(`${basename(file)}: a model that is mirrored moves as its mirror image`, async () => {
    const play = async (mirror) => {
      const { vrm, asset } = await replaced(file);
      vrm.scene.scale.setScalar(0.8);
      vrm.scene.scale.x *= mirror;
      vrm.scene.rotation.y = 0.4 * mirror;
      vrm.scene.position.set(2 * mirror, 0, -1);
      const hair = replaceSpringBones(vrm, asset, { settings: { wind: [1.5 * mirror, 0, 0.5] } });
      for (let frame = 0; frame < 60; ++frame) {
        pose(vrm, frame);
        vrm.update(1 / 60);
      }
      vrm.scene.updateWorldMatrix(true, true);
      return hair.joints.map(({ node }) => node.getWorldPosition(new Vector3()));
    };
    const [usual, mirrored] = [await play(1), await play(-1)];
    usual.forEach((place, i) => assert.ok(place.x * mirrored[i].x < 0 && place.setX(-place.x).distanceTo(mirrored[i]) < 1e-5, `joint ${i}`));
  });

  test(`${basename(file)}: an asset of another file is refused, and nothing changes`, async () => {
    const { coif, vrm, springs } = await replaced(file);
    const joints = springs.joints.size;
    assert.throws(() => replaceSpringBones(vrm, coif.openAsset(readFileSync('assets/bob.coif'))), /the model has no '/);
    assert.equal(springs.joints.size, joints);
    vrm.update(1 / 60);
  });
}

if (!existsSync(folder)) console.log(`skipped: no corpus of artists' files in ${folder}`);
else FILES.forEach(checkModel);
