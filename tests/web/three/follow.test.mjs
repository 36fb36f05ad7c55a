// CoifHair.follow(): heads on bones of rigs, of other units, mirrored, uneven and broken.

import { strict as assert } from 'node:assert';
import { test } from 'node:test';
import { onStage, watchStage } from './pages.mjs';

test("a rig's unit and the rest of its bone change nothing that is drawn", async () => {
  const rigs = { centimetres: 0.01, millimetres: 0.001, 'hundreds of metres': 100, 'centimetres of a tall one': 0.012 };
  const off = await onStage((units) => {
    const { made } = window;
    const { three: THREE } = made;
    const moves = (object, frame) => object.rotation.set(0.2 * Math.sin(frame / 5), 0.5 * Math.sin(frame / 7), 0.1);
    const play = (object) => {
      for (let frame = 0; frame < 20; ++frame) {
        moves(object, frame);
        made.hair.update(1 / 60, made.camera);
      }
      return made.picture();
    };
    const joint = (parent, place, unit) => {
      const bone = new THREE.Bone();
      bone.position.fromArray(place.map((each) => each / unit));
      parent.add(bone);
      return bone;
    };
    const seen = {};
    for (const [name, scale] of Object.entries(units)) {
      const unit = 10 ** Math.round(Math.log10(scale));
      const [rig, usual] = [new THREE.Group(), new THREE.Group()];
      rig.scale.setScalar(scale);
      usual.scale.setScalar(scale / unit);
      for (const each of [rig, usual]) made.scene.add(each);
      const heads = [joint(rig, [0.03, 0.02, -0.1], unit), joint(usual, [0.03, 0.02, -0.1], 1)];
      const pictures = heads.map((bone) => {
        made.wear().follow(0, bone);
        return play(bone);
      });
      // The bone of most rigs has a rotation of its own at rest; here the model was made on the rig as it stands.
      const spine = new THREE.Bone();
      spine.rotation.set(-1.2, 0.3, 0.7);
      rig.scale.setScalar(unit);
      rig.add(spine);
      const turned = joint(spine, [0, 0, 0], unit);
      turned.rotation.set(0.4, -0.2, 1);
      rig.updateMatrixWorld(true);
      made.wear().follow(0, turned, { rest: turned.matrixWorld });
      const atRest = made.picture();
      made.wear();
      seen[name] = [made.compare(...pictures).count, made.compare(atRest, made.picture()).count, made.look(pictures[0]).count];
    }
    return seen;
  }, rigs);
  for (const [name, [moved, atRest, count]] of Object.entries(off)) {
    assert.ok(count > 2500, `${name}: ${count} pixels of hair`);
    assert.ok(moved < 300, `${name}: ${moved} of 262144 values differ`); // by rounding, at edges
    assert.ok(atRest < 300, `${name}: ${atRest} values differ at rest`);
  }
});

test('hair swings below a rig of centimetres as it does below one of metres', async () => {
  const ends = await onStage(() => {
    const { made } = window;
    const { three: THREE } = made;
    return [1, 0.01].map((unit) => {
      const [rig, bone] = [new THREE.Group(), new THREE.Bone()];
      rig.scale.setScalar(unit);
      made.scene.add(rig.add(bone));
      const hair = made.wear();
      hair.follow(0, bone);
      for (let frame = 0; frame < 30; ++frame) {
        bone.position.x = (0.2 * Math.sin(frame / 6)) / unit;
        hair.update(1 / 60, made.camera);
      }
      return { ends: Array.from(hair.hair.boneEnds(0)), scale: hair.heads[0].scale, rest: Array.from(made.wear().hair.boneEnds(0)) };
    });
  });
  const farthest = (a, b) => Math.max(...a.map((each, i) => Math.abs(each - b[i])));
  assert.ok(Math.abs(ends[1].scale - 1) < 1e-6);
  assert.ok(farthest(ends[0].ends, ends[0].rest) > 0.01, 'it swings');
  assert.ok(farthest(ends[0].ends, ends[1].ends) < 1e-4, `${farthest(ends[0].ends, ends[1].ends)} m apart`);
});

test('a mirrored head wears its hair as it was modelled, and the page is told once', async () => {
  const { found, complaints } = await watchStage(() => {
    const { made } = window;
    const { three: THREE } = made;
    const head = made.holder([0.05, 0.02, 0], 0.3);
    head.name = 'Head';
    const hair = made.wear();
    hair.follow(0, head);
    head.scale.x = -1;
    const mirrored = made.picture();
    for (let frame = 0; frame < 10; ++frame) hair.update(1 / 60, made.camera);
    head.scale.x = 1;
    const usual = made.picture();
    // Mirrored across the world's plane of x = 0 it looks where the mirror image of its face looks.
    const world = new THREE.Group();
    world.scale.x = -1;
    made.scene.add(world.add(head));
    hair.reset();
    const across = made.picture();
    made.wear().follow(0, made.holder([-0.05, 0.02, 0], -0.3));
    return { off: made.compare(mirrored, usual).count, across: made.compare(across, made.picture()).count };
  });
  assert.equal(found.off, 0, 'as if it were not mirrored');
  assert.ok(found.across < 300, `${found.across} values differ`);
  assert.deepEqual(complaints, ["coif/three: head 0 follows 'Head', which is mirrored by a negative scale: the hair sits on it as it was modelled, not mirrored"]);
});

test('a head that is scaled to nothing or broken keeps its hair, without an error in any frame', async () => {
  const { found, complaints } = await watchStage(() => {
    const { made } = window;
    const head = made.holder([0, 0, -0.1]);
    const hair = made.wear();
    hair.follow(0, head);
    const frames = (count) => { for (let i = 0; i < count; ++i) hair.update(1 / 60, made.camera); };
    frames(3);
    const before = made.look(made.picture(1 / 60)).count;
    head.scale.setScalar(0);
    frames(5);
    const hidden = made.look().count;
    head.scale.setScalar(0.02); // shrinks: not the unit of a rig
    frames(5);
    const small = made.look().count;
    head.scale.setScalar(1);
    head.position.x = NaN;
    frames(5);
    head.position.x = 0;
    frames(2);
    return { before, hidden, small, after: made.look(made.picture(1 / 60)).count, scale: hair.heads[0].scale, unit: hair.heads[0].unit };
  });
  assert.ok(found.before > 3000);
  assert.equal(found.hidden, 0);
  assert.ok(found.small > 0 && found.small < 20, `${found.small} pixels`);
  assert.ok(Math.abs(found.after / found.before - 1) < 0.02, `${found.after} of ${found.before} pixels`);
  assert.deepEqual([found.scale, found.unit], [1, 1]);
  assert.equal(complaints.length, 2, `${complaints}`);
  assert.match(complaints[0], /head 0 follows 'Object3D', and its hair stands still, since writeHeadBone: a head's scale is outside of 0.05 to 20/);
  assert.match(complaints[1], /a pose has a NaN/);
});

test('a head that grows from nothing has its own size in the end', async () => {
  const sizes = await onStage(() => {
    const { made } = window;
    const head = made.holder([0, 0, 0]);
    head.scale.setScalar(0.01);
    made.wear().follow(0, head);
    return [0.01, 0.04, 0.2, 1].map((scale) => {
      head.scale.setScalar(scale);
      made.hair.update(1 / 60, made.camera);
      return made.hair.heads[0].scale;
    });
  });
  assert.ok(Math.abs(sizes[2] - 0.2) < 1e-6 && Math.abs(sizes[3] - 1) < 1e-6, `${sizes}`);
});

test('an uneven head is drawn uneven, and simulated', async () => {
  const { even, uneven, scale } = await onStage(() => {
    const { made } = window;
    const head = made.holder([0, 0, 0]);
    made.wear().follow(0, head);
    const usual = made.look(made.picture());
    head.scale.set(1, 1.3, 1);
    return { even: usual.count, uneven: made.look(made.picture()).count, scale: made.hair.heads[0].scale };
  });
  assert.ok(uneven > 1.2 * even && uneven < 1.35 * even, `${uneven} of ${even} pixels`);
  assert.ok(Math.abs(scale - Math.sqrt((1 + 1.3 ** 2 + 1) / 3)) < 1e-6);
});

test('the origin of head space may be off the object', async () => {
  const off = await onStage(() => {
    const { made } = window;
    const head = made.holder([0.05, -0.12, 0], 0.4);
    made.wear().follow(0, head, { origin: { x: 0, y: 0.1, z: 0 } });
    const one = made.picture();
    head.position.y += 0.1;
    made.wear().follow(0, head);
    return made.compare(one, made.picture()).count;
  });
  assert.ok(off < 300, `${off} values differ`);
});

test('what cannot be followed is refused at once', async () => {
  const said = await onStage(() => {
    const { made } = window;
    const hair = made.wear();
    const zero = new made.three.Matrix4().makeScale(0, 1, 1);
    return [[3], [0, hair, { rest: zero }], [0, hair, { rest: [1, 2] }], [0, hair, { origin: [NaN, 0, 0] }]].map((given) => {
      try {
        return hair.follow(...given);
      } catch (error) {
        return `${error.name}: ${error.message}`;
      }
    });
  });
  assert.equal(said[0], 'RangeError: there is no head 3');
  for (const each of said.slice(1)) assert.match(each, /^RangeError: head 0: 'rest' must be a matrix of 16 numbers that has an inverse/);
});
