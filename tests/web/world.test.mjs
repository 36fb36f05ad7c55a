// Worlds: heads of many assets have the bits of crowds of their own, come and go, and give their memory back.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { CoifError, loadCoif } from 'coif';

const [bob, long] = ['bob', 'long'].map((name) => readFileSync(`assets/${name}.coif`));
const refused = (what, message, status) => assert.throws(what, (error) => {
  assert.ok(error instanceof CoifError, `${error}`);
  assert.match(error.message, message);
  if (status !== undefined) assert.equal(error.status, status);
  return true;
});
const wander = (frame, i = 0) => ({ position: [0.02 * frame, 1.6, i], rotation: [0, Math.sin(frame / 40 + i), 0, Math.cos(frame / 40 + i)] });

/** The same heads in a world and in crowds of their own, which tell() tells the same. */
class Both {
  constructor(coif, desc) {
    this.world = coif.createWorld({ hairBytes: 16 << 20, ...desc });
    this.desc = desc;
    this.heads = [];
  }
  add(asset, pose) {
    const [head, hair] = [this.world.addHead(asset, pose), asset.createHair(this.desc)];
    hair.reset(0, pose);
    this.heads.push({ head, hair });
  }
  remove(i) {
    const [{ head, hair }] = this.heads.splice(i, 1);
    this.world.removeHead(head);
    hair.dispose();
  }
  tell(i, name, ...values) {
    this.world[name](this.heads[i].head, ...values);
    this.heads[i].hair[name](0, ...values);
  }
  tellAll(name, ...values) {
    this.world[name](...values);
    for (const { hair } of this.heads) hair[name](...values);
  }
  assertSame(what) {
    for (const { head, hair } of this.heads) {
      for (const result of ['palette', 'boneEnds', 'boneTransforms']) assert.deepEqual(this.world[result](head), hair[result](0), `${what}: ${result}`);
      assert.equal(this.world.isAsleep(head), hair.isAsleep(0));
    }
  }
}

for (const solver of ['coif', 'thesis', 'passive', 'cascade', 'character']) {
  test(`${solver}: heads have the bits of crowds, whoever comes and goes`, async () => {
    const coif = await loadCoif();
    const assets = [coif.openAsset(bob), coif.openAsset(long)];
    const both = new Both(coif, { solver, longestInterval: 2 });
    both.world.addAsset(assets[0]);
    both.world.addAsset(assets[1], { crowd: 16 });
    for (let i = 0; i < 4; ++i) both.add(assets[i % 2], wander(0, i));
    for (let frame = 1; frame <= 24; ++frame) {
      both.heads.forEach((_, i) => both.tell(i, 'setHead', wander(frame, i), i === 1 ? { linear: [1, 0, 0] } : undefined));
      if (frame === 6) both.tell(0, 'teleport', wander(90));
      if (frame === 9) both.tell(3, 'setDetail', { simulated: false });
      if (frame === 12) {
        both.remove(2);
        both.add(assets[0], wander(0, 7));
      }
      both.tellAll('step', { dt: 1 / 60 });
      both.assertSame(`frame ${frame}`);
    }
  });
}

test('what heads are told on characters and in air has the bits of crowds', async () => {
  const coif = await loadCoif();
  const both = new Both(coif, { solver: 'character', movingColliders: 1, followsPoses: true, hasOwnAir: true, feelsGusts: true, dynamicsSets: 2 });
  for (const asset of [coif.openAsset(bob), coif.openAsset(long)]) {
    both.world.addAsset(asset);
    both.add(asset, {});
  }
  both.tellAll('setGusts', { amplitude: 5 });
  both.tellAll('setDynamics', 1, { stiffness: 0.5 });
  both.tell(1, 'setAir', { wind: [3, 0, 0], exposure: 0.5 });
  both.tell(1, 'chooseDynamics', 1);
  const bones = both.heads[0].hair.boneCount;
  const turned = Array.from({ length: bones }, () => [0.0998334, 0, 0, 0.9950042]).flat();
  for (let frame = 0; frame < 30; ++frame) {
    both.tell(0, 'setColliders', [{ shape: 'sphere', center: [0, -0.1, -0.2 + 0.01 * frame], radius: 0.05 }]);
    both.tell(0, 'setPose', turned, [0.5]);
    if (frame === 15) both.tell(1, 'push', { radius: 1, speed: 2 });
    both.tellAll('step');
    both.assertSame(`frame ${frame}`);
  }
  assert.ok(both.world.gustsWay > 0);
  assert.equal(both.world.gustsWay, both.heads[0].hair.gustsWay);
  both.world.settle(both.heads.map(({ head }) => head), 0.5);
  both.heads.forEach(({ hair }) => hair.settle(0, 0.5));
  both.assertSame('settled');
});

test('a saved state goes on to the same bits, and frames take no memory', async () => {
  const coif = await loadCoif({ memoryBytes: 32 << 20 });
  const [asset, world] = [coif.openAsset(bob), coif.createWorld()];
  world.addAsset(asset);
  const heads = [0, 1, 2].map((i) => world.addHead(asset, wander(0, i)));
  const play = (from, to) => {
    for (let frame = from; frame < to; ++frame) {
      heads.forEach((head, i) => world.setHead(head, wander(frame, i)));
      world.step();
      world.boneEnds(heads[1]);
    }
    return heads.map((head) => Float32Array.from(world.palette(head)));
  };
  play(0, 20);
  const saved = world.save();
  assert.equal(saved.length, world.savedBytes);
  const [free, palette] = [coif.freeBytes, world.palette(heads[1])];
  const first = play(20, 60);
  world.restore(saved);
  assert.deepEqual(play(20, 60), first);
  assert.equal(coif.freeBytes, free);
  assert.equal(world.palette(heads[1]), palette, 'the same view');
  world.removeHead(heads[2]);
  refused(() => world.restore(saved), /another|state/, 'COIF_FOREIGN_STATE');
});

test('what is disposed of or removed makes room, and is refused', async () => {
  const coif = await loadCoif();
  const free = coif.freeBytes;
  for (let round = 0; round < 2; ++round) {
    const [asset, world] = [coif.openAsset(bob), coif.createWorld({ assets: 1, heads: 2, hairBytes: coif.bytesForWorld(coif.openAsset(bob), 2) })];
    assert.equal(world.hasAsset(asset), false);
    refused(() => world.addHead(asset), /is not in this world/, 'COIF_BAD_INDEX');
    world.addAsset(asset);
    const [head, other] = [world.addHead(asset), world.addHead(asset, { position: [1, 0, 0] })];
    assert.equal(head.asset, asset);
    refused(() => world.addHead(asset), /memory/, 'COIF_MEMORY_TOO_SMALL');
    refused(() => asset.dispose(), /still need it/);
    refused(() => world.removeAsset(asset), /range/, 'COIF_BAD_ARGUMENT');
    world.removeHead(head);
    assert.deepEqual([world.hasHead(head), world.hasHead(other), world.hasHead({})], [false, true, false]);
    refused(() => world.palette(head), /instance|index/, 'COIF_BAD_INDEX');
    refused(() => world.boneEnds(head), /instance|index/, 'COIF_BAD_INDEX');
    world.removeHead(other);
    world.removeAsset(asset);
    asset.dispose();
    const again = coif.openAsset(long);
    refused(() => world.addAsset(again), /memory/, 'COIF_MEMORY_TOO_SMALL');
    world.dispose();
    world.dispose();
    for (const call of [() => world.step(), () => world.addAsset(again), () => world.hasHead(head), () => world.addHead(again)]) {
      refused(call, /world was disposed of/, 'COIF_NOT_CREATED');
    }
    again.dispose();
  }
  assert.ok(coif.freeBytes >= free - 2 * (bob.length + 2048), 'only the two assets that were opened for their size are left');
});

test('what is wrong is thrown with a sentence, and nothing moved', async () => {
  const [coif, another] = [await loadCoif(), await loadCoif({ memoryBytes: 16 << 20 })];
  const [asset, world] = [coif.openAsset(bob), coif.createWorld()];
  world.addAsset(asset);
  const head = world.addHead(asset, wander(0));
  const before = Float32Array.from(world.palette(head));
  refused(() => world.addAsset(asset), /in this world already/, 'COIF_BAD_ARGUMENT');
  refused(() => world.addAsset(another.openAsset(bob)), /another module/, 'COIF_BAD_ARGUMENT');
  refused(() => world.setHead(0, {}), /no head of this world/, 'COIF_BAD_INDEX');
  refused(() => coif.createWorld().setHead(head, {}), /no head of this world/, 'COIF_BAD_INDEX');
  refused(() => world.settle([head, undefined], 1), /no head of this world/, 'COIF_BAD_INDEX');
  refused(() => world.setHead(head, { rotation: [0, 0, 0, 2] }), /pose/, 'COIF_BAD_POSE');
  refused(() => world.addHead(asset, { scale: 0 }), /scale/, 'COIF_BAD_SCALE');
  refused(() => world.step({ dt: NaN }), /time step/, 'COIF_BAD_TIME_STEP');
  refused(() => world.setAir(head, {}), /created without/, 'COIF_NOT_ASKED');
  refused(() => world.setBody(head, []), /created without/, 'COIF_NOT_ASKED');
  refused(() => world.restore(new Uint8Array(4)), /state/);
  refused(() => coif.createWorld({ heads: 0 }), /description/, 'COIF_BAD_ARGUMENT');
  refused(() => coif.createWorld({ instances: 1 }), /'instances' is no member of WorldDesc/, 'COIF_BAD_ARGUMENT');
  refused(() => coif.createWorld({ hairBytes: 512 << 20 }), /does not fit/, 'COIF_MEMORY_TOO_SMALL');
  refused(() => coif.bytesForWorld(asset, 1, { solver: 'fast' }), /'solver' is fast/);
  assert.deepEqual(world.palette(head), before);
});

test('the module for crowds has no worlds, and says so', async () => {
  const coif = await loadCoif({ parts: 'crowd', memoryBytes: 16 << 20 });
  refused(() => coif.createWorld(), /createWorld: .* built without worlds/, 'COIF_BAD_ARGUMENT');
  refused(() => coif.bytesForWorld(coif.openAsset(bob), 1), /built without worlds/, 'COIF_BAD_ARGUMENT');
});
