// What the package promises besides the numbers: errors that say why, memory that stands still, views that stay.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { CoifError, loadCoif } from 'coif';

const bob = readFileSync('assets/bob.coif');
const refused = (what, message, status) => assert.throws(what, (error) => {
  assert.ok(error instanceof CoifError);
  assert.match(error.message, message);
  if (status !== undefined) assert.equal(error.status, status);
  return true;
});
const turned = (frame) => ({ position: [0, 1.6, 0], rotation: [0, Math.sin(frame / 40), 0, Math.cos(frame / 40)] });

test('bytes that are no asset are refused for what they are', async () => {
  const coif = await loadCoif();
  const free = coif.freeBytes;
  refused(() => coif.openAsset(new Uint8Array(10)), /too short to be a cooked hair asset/, 'COIF_ASSET_LACKS_DATA');
  refused(() => coif.openAsset(new TextEncoder().encode('x'.repeat(400))), /not a cooked hair asset/);
  refused(() => coif.openAsset(bob.subarray(0, bob.length - 1)), /truncated/);
  const damaged = Uint8Array.from(bob);
  damaged[300] ^= 1;
  refused(() => coif.openAsset(damaged), /bytes were changed after cooking|chunk|hash/);
  assert.equal(coif.freeBytes, free, 'they hold no memory');
});

test('what C refuses is thrown as it says it, and what it has no word for is named', async () => {
  const coif = await loadCoif();
  const asset = coif.openAsset(bob);
  const hair = asset.createHair();
  const before = Float32Array.from(hair.palette(0));
  refused(() => hair.step({ dt: NaN }), /time step/, 'COIF_BAD_TIME_STEP');
  refused(() => hair.setHead(0, { rotation: [0, 0, 0, 2] }), /pose/, 'COIF_BAD_POSE');
  refused(() => hair.setHead(0, { scale: 0 }), /scale is outside of 0.05 to 20/, 'COIF_BAD_SCALE');
  refused(() => hair.setHead(1, {}), /instance/, 'COIF_BAD_INDEX');
  refused(() => hair.palette(7), /instance/, 'COIF_BAD_INDEX');
  refused(() => hair.setColliders(0, [{ radius: 1 }]), /created without/, 'COIF_NOT_ASKED');
  refused(() => hair.setColliders(0, new Array(17).fill({ radius: 1 })), /created without/, 'COIF_NOT_ASKED');
  hair.setColliders(0, []);
  refused(() => hair.setBody(0, []), /created without/, 'COIF_NOT_ASKED');
  refused(() => hair.setBody(0, new Array(40).fill({})), /created without/, 'COIF_NOT_ASKED');
  refused(() => hair.setPose(0), /created without/, 'COIF_NOT_ASKED');
  refused(() => hair.setPose(0, new Array(4 * hair.boneCount + 4).fill(0), [1]), /created without/, 'COIF_NOT_ASKED');
  const posed = asset.createHair({ solver: 'character', followsPoses: true });
  refused(() => posed.setPose(0, [0, 0, 0, 1, 0], [1]), /do not belong together/, 'COIF_SIZE_MISMATCH');
  posed.dispose();
  refused(() => hair.setAir(0, {}), /created without/, 'COIF_NOT_ASKED');
  refused(() => hair.setGusts({}), /created without/, 'COIF_NOT_ASKED');
  refused(() => hair.setDynamics(0, {}), /created without/, 'COIF_NOT_ASKED');
  refused(() => hair.chooseDynamics(0, 1), /created without/, 'COIF_NOT_ASKED');
  refused(() => hair.step({ dampng: 1 }), /'dampng' is no member of StepSettings; it has dt, /);
  refused(() => hair.setHead(0, { position: [1, 2] }), /'position' needs 3 numbers/);
  refused(() => asset.createHair({ solver: 'fast' }), /'solver' is fast; it must be one of coif, thesis/);
  refused(() => asset.createHair({ instances: 0 }), /description/, 'COIF_BAD_ARGUMENT');
  refused(() => asset.texture('roughness'), /there are base-color/);
  refused(() => hair.restore(new Uint8Array(4)), /state/);
  refused(() => asset.dispose(), /still need it/);
  assert.deepEqual(hair.palette(0), before, 'and nothing moved');
  await assert.rejects(loadCoif({ memoryBytes: 1000 }), /memoryBytes is 1000; it must be/);
  const small = await loadCoif({ memoryBytes: 2 << 20 });
  refused(() => small.openAsset(new Uint8Array(3 << 20)), /of 3.0 MB does not fit: .* give loadCoif\(\) more memoryBytes/, 'COIF_MEMORY_TOO_SMALL');
});

test('thousands of frames take no memory, and views stay', async () => {
  const coif = await loadCoif({ memoryBytes: 16 << 20 });
  const asset = coif.openAsset(bob);
  const hair = asset.createHair({ instances: 3 });
  const [palette, buffer, free] = [hair.palette(1), coif.wasmMemory.buffer, coif.freeBytes];
  const rest = Float32Array.from(palette);
  for (let frame = 0; frame < 2000; ++frame) {
    for (let i = 0; i < 3; ++i) hair.writeHead(i, turned(frame).position, turned(frame).rotation);
    hair.setHeads();
    hair.step({ dt: 1 / 60 });
    hair.boneEnds(1);
  }
  assert.equal(coif.wasmMemory.buffer, buffer);
  assert.equal(buffer.byteLength, 16 << 20);
  assert.equal(coif.freeBytes, free);
  assert.equal(hair.palette(1), palette, 'the same view, not one more');
  assert.notDeepEqual(palette, rest, 'with what is so now');
  assert.ok(palette.every(Number.isFinite));
});

test('what is disposed of makes room', async () => {
  const coif = await loadCoif();
  const free = coif.freeBytes;
  for (let i = 0; i < 3; ++i) {
    const asset = coif.openAsset(bob);
    const [hair, other, drawn] = [asset.createHair(), asset.createHair({ instances: 20 }), asset.drawnHair()];
    drawn.drawOrders();
    drawn.skinVertices(hair.palette(0));
    for (const each of [other, hair, drawn, asset]) each.dispose();
    assert.equal(coif.freeBytes, free);
    refused(() => hair.step(), /disposed of/);
    refused(() => asset.bones, /disposed of/);
  }
});

test('a saved state goes on to the same bits', async () => {
  const coif = await loadCoif();
  const hair = coif.openAsset(bob).createHair({ solver: 'passive' });
  const play = (from, to) => {
    for (let frame = from; frame < to; ++frame) {
      hair.setHead(0, turned(frame));
      hair.step();
    }
    return Float32Array.from(hair.palette(0));
  };
  play(0, 30);
  const saved = hair.save();
  const first = play(30, 60);
  play(60, 70);
  hair.restore(saved);
  assert.deepEqual(play(30, 60), first);
  refused(() => coif.openAsset(bob).createHair({ instances: 2 }).restore(saved), /another|state/, 'COIF_FOREIGN_STATE');
});

/** A head turned by 90 degrees about the vertical at (0.5, 1.6, -2), in a rig of centimetres; column after column, as three has it. */
const BONE = [0, 0, -0.01, 0, 0, 0.01, 0, 0, 0.01, 0, 0, 0, 0.5, 1.6, -2, 1];
const AT_REST = [0.01, 0, 0, 0, 0, 0.01, 0, 0, 0, 0, 0.01, 0, 0, 1.6, 0, 1];
const near = (a, b, most = 1e-6) => a.forEach((each, i) => assert.ok(Math.abs(each - b[i]) < most, `${a}, not ${b}`));

test("a head follows an engine's bone, with the rig's unit and rest taken out", async () => {
  const coif = await loadCoif();
  const { position, rotation, scale } = coif.headPose(BONE, { rest: { elements: AT_REST }, origin: { x: 0, y: 0.25, z: 0.5 } });
  near([...position, ...rotation, scale], [1, 1.85, -2, 0, Math.SQRT1_2, 0, Math.SQRT1_2, 1]);
  const far = BONE.map((each, i) => each * (i < 12 ? 100 : 1)); // all in centimetres: no scale
  near(coif.headPose(far, { metresPerUnit: 0.01 }).position, [0.005, 0.016, -0.02]);
  const mirrored = BONE.map((each, i) => (i % 4 === 0 ? -each : each)); // the world's x
  near(coif.headPose(mirrored, { rest: AT_REST }).rotation, [0, -Math.SQRT1_2, 0, Math.SQRT1_2]);

  refused(() => coif.headPose(BONE), /headPose: a head's scale is outside of 0.05 to 20/, 'COIF_BAD_SCALE');
  refused(() => coif.headPose([...BONE.slice(0, 12), NaN, 0, 0, 1], { rest: AT_REST }), /NaN/, 'COIF_BAD_POSE');
  refused(() => coif.headPose(BONE, { rest: new Array(16).fill(0) }), /range/, 'COIF_BAD_ARGUMENT');
  refused(() => coif.headPose(BONE.slice(1)), /'bone' needs 16 numbers, column after column/, 'COIF_BAD_ARGUMENT');
  refused(() => coif.headPose(BONE, { rest: 3 }), /'rest' needs 16 numbers/);
  refused(() => coif.headPose(BONE, { metersPerUnit: 1 }), /'metersPerUnit' is no member of HeadBone; it has rest, origin, metresPerUnit/);
});

test('a bone moves a head of a crowd as its pose does, and a bad one leaves it where it is', async () => {
  const coif = await loadCoif();
  const asset = coif.openAsset(bob);
  const [by, same] = [asset.createHair({ instances: 2 }), asset.createHair({ instances: 2 })];
  const headBone = { rest: AT_REST };
  for (let frame = 0; frame < 30; ++frame) {
    const bone = BONE.with(12, 0.02 * frame);
    by.writeHeadBone(1, bone, headBone);
    const { position, rotation, scale } = coif.headPose(bone, headBone);
    same.writeHead(1, position, rotation, scale);
    for (const each of [by, same]) {
      each.setHeads();
      each.step();
    }
  }
  assert.deepEqual(by.palette(1), same.palette(1));
  const before = Float64Array.from(by.positions);
  refused(() => by.writeHeadBone(1, BONE), /writeHeadBone: a head's scale/, 'COIF_BAD_SCALE');
  refused(() => by.writeHeadBone(2, BONE, headBone), /instance/, 'COIF_BAD_INDEX');
  refused(() => by.writeHeadBone(0.5, BONE, headBone), /instance/, 'COIF_BAD_INDEX');
  assert.deepEqual(by.positions, before);
  by.dispose();
  refused(() => by.writeHeadBone(0, BONE, headBone), /disposed of/);
});

test('bones against their parents make the matrices again, and all that is drawn is there', async () => {
  const coif = await loadCoif();
  const asset = coif.openAsset(bob);
  const hair = asset.createHair();
  for (let frame = 0; frame < 20; ++frame) {
    hair.setHead(0, turned(frame));
    hair.step();
  }
  const turns = hair.boneTransforms(0);
  assert.equal(turns.length, 7 * hair.boneCount);
  for (let i = 0; i < hair.boneCount; ++i) assert.ok(Math.abs(Math.hypot(...turns.subarray(7 * i + 3, 7 * i + 7)) - 1) < 1e-5);
  const drawn = asset.drawnHair();
  assert.equal(asset.vertices.length % 36, 0);
  assert.equal(asset.skin.length / 12, asset.vertices.length / 36);
  assert.equal(asset.lodIndices(0).length, drawn.lods[0].count);
  assert.equal(drawn.drawOrders().length, drawn.orderCount * drawn.indicesOfOrder);
  assert.ok(drawn.chooseOrder([0, 0, 1]) < drawn.orderCount);
  assert.equal(asset.material.baseColor.length, 4);
  const texture = asset.texture('base-color');
  assert.equal(texture.mips[0].length, texture.width * texture.height * 4);
  const { lowest, highest } = drawn.bound(hair.palette(0));
  const vertices = drawn.skinVertices(hair.palette(0));
  for (let i = 0; i < vertices.length; i += 9) {
    for (let k = 0; k < 3; ++k) assert.ok(vertices[i + k] >= lowest[k] - 1e-5 && vertices[i + k] <= highest[k] + 1e-5);
  }
  const looksAt = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.1, 0];
  assert.ok(drawn.orderInView({ position: [0, 0, -2] }, [0, 0, 0], looksAt) >= 0);
  assert.equal(drawn.orderInView({ position: [0, 0, 9] }, [0, 0, 0], looksAt), -1);
});

test('a character has colliders, air, poses, and time to settle', async () => {
  const coif = await loadCoif();
  const hair = coif.openAsset(bob).createHair({ solver: 'character', movingColliders: 2, hasOwnAir: true, feelsGusts: true,
    followsPoses: true, dynamicsSets: 2 });
  const ends = () => Float32Array.from(hair.boneEnds(0));
  const moves = (what) => {
    const before = ends();
    what();
    for (let i = 0; i < 30; ++i) hair.step({ sleepAfter: Infinity });
    const after = ends();
    assert.ok(Math.max(...after.map((each, i) => Math.abs(each - before[i]))) > 1e-3, `${what}`);
  };
  hair.settle(0, 5);
  moves(() => hair.setColliders(0, [{ shape: 'sphere', center: { x: 0, y: -0.05, z: 0.05 }, radius: 0.15 }]));
  moves(() => hair.setColliders(0, []));
  moves(() => hair.setAir(0, { wind: [6, 0, 0], exposure: 1 }));
  moves(() => hair.setAir(0, {}));
  moves(() => hair.setGusts({ amplitude: 8 }));
  assert.ok(hair.gustsWay > 0);
  assert.equal(coif.gustAt({ amplitude: 8 }, hair.gustsWay, [0, 0, 0]).length, 3);
  hair.setDynamics(1, { stiffness: 0 });
  moves(() => hair.chooseDynamics(0, 1));
  moves(() => hair.push(0, { radius: 1, speed: 3 }));
  const quarter = Array.from({ length: hair.boneCount }, () => [0.3826834, 0, 0, 0.9238795]).flat();
  moves(() => hair.setPose(0, quarter, [0]));
  hair.setPose(0);
});

test('the module for crowds gives the same bits, and refuses what it leaves out', async () => {
  const [all, crowd] = [await loadCoif(), await loadCoif({ parts: 'crowd' })];
  const play = (coif, solver) => {
    const hair = coif.openAsset(bob).createHair({ solver });
    for (let frame = 0; frame < 40; ++frame) {
      hair.setHead(0, turned(frame));
      hair.step();
    }
    return Float32Array.from(hair.palette(0));
  };
  for (const solver of ['coif', 'passive', 'cascade']) assert.deepEqual(play(crowd, solver), play(all, solver));
  refused(() => play(crowd, 'character'), /built without/, 'COIF_BAD_ARGUMENT');
  refused(() => play(crowd, 'thesis'), /built without/);
  refused(() => crowd.openAsset(bob).createHair({ keepsLinks: true }), /built without/);
  await assert.rejects(loadCoif({ parts: 'some' }), /must be all or crowd/);
});
