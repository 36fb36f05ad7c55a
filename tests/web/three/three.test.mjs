// coif/three as its users see it: pictures of a scene, drawn by Chromium.

import { strict as assert } from 'node:assert';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { onStage, open, pages } from './pages.mjs';

const { PACKAGE, README } = process.env;

test('the oldest version of three that the package asks for is the one that is tested', () => {
  const versionOf = (file) => JSON.parse(readFileSync(file, 'utf8'));
  const { version } = versionOf('node_modules/three-floor/package.json');
  assert.equal(versionOf(`${PACKAGE}/package.json`).peerDependencies.three, `>=${version}`);
});

test('an older version of three is refused, with what to do', async () => {
  const pretending = "export * from '/three/build/three.module.js';\nexport const REVISION = '156';";
  pages.set('/old_three.js', pretending);
  pages.set('/old.html', readFileSync('scene.html', 'utf8').replace('/three/build/three.module.js', '/old_three.js'));
  const { page } = await open('/old.html');
  const said = await page.evaluate(async () => {
    const made = await window.stage;
    const free = made.coif.freeBytes;
    try {
      return `${made.wear()}`;
    } catch (error) {
      return `${error.name} ${error.message} ${free - made.coif.freeBytes}`;
    }
  });
  await page.close();
  assert.equal(said, 'CoifError coif/three draws with three 0.157.0 or later, and this page has loaded three 0.156: ' +
    "run 'npm install three@latest', or change three's address in the page's import map 0");
});

test('hair is drawn in every way, about as large, and not alike', async () => {
  const modes = ['blend', 'opaque', 'hashed', 'bayer', 'coverage'];
  const seen = await onStage((ways) => ways.map((transparency) => {
    window.made.wear({ transparency });
    return window.made.look();
  }), modes);
  const blended = seen[0];
  assert.ok(blended.count > 3000, `${blended.count} pixels of hair`);
  assert.ok(blended.mean[0] > blended.mean[2] + 10, 'the sample is brown');
  seen.forEach(({ count, mean }, i) => {
    assert.ok(Math.abs(count / blended.count - 1) < 0.25, `${modes[i]}: ${count} pixels`);
    assert.ok(Math.abs(mean[0] / blended.mean[0] - 1) < 0.3, `${modes[i]}: colour`);
    if (i > 0) assert.notDeepEqual([count, mean], [blended.count, blended.mean], modes[i]);
  });
});

test('a way that there is not is refused by name', async () => {
  const said = await onStage(() => {
    try {
      return `${window.made.wear({ transparency: 'glass' })}`;
    } catch (error) {
      return error.message;
    }
  });
  assert.match(said, /'glass' is no way to draw hair; there are blend/);
});

test('solid and transparent things stand before and behind hair', async () => {
  const { behind, before: inFront, glass, far } = await onStage(() => {
    const { made } = window;
    made.wear();
    const hair = made.look();
    const wall = made.plate(-0.5);
    const behindHair = made.picture();
    wall.position.z = 0.4;
    const beforeHair = made.look(made.picture());
    wall.removeFromParent();
    const pane = made.plate(0.4, { opacity: 0.5 });
    const through = made.picture();
    pane.position.z = -0.5;
    const over = made.picture();
    const middle = 4 * (128 * 256 + 128);
    const pixel = (picture) => Array.from(picture.subarray(middle, middle + 3));
    made.scene.remove(pane);
    return { behind: [pixel(behindHair), pixel(made.picture()), hair.count], before: beforeHair.mean, glass: pixel(through), far: pixel(over) };
  });
  const hairs = behind[1];
  assert.deepEqual(behind[0], hairs, 'a wall behind hair changes none of it');
  assert.ok(inFront[0] < 60 && inFront[1] > 200, `a wall before hair hides it: ${inFront}`);
  assert.ok(glass[1] > hairs[1] + 60 && glass[0] > 5, `glass before hair tints it: ${glass} of ${hairs}`);
  assert.deepEqual(far, hairs, 'glass behind solid hair is not seen');
});

test('hair throws shadows, and things throw shadows onto hair', async () => {
  const { lit, shaded, onWall, bare } = await onStage(() => {
    const { made } = window;
    const { three: THREE } = made;
    const sumOf = (pixels) => pixels.reduce((sum, value, i) => sum + (i % 4 === 3 ? 0 : value), 0);
    made.sun.castShadow = true;
    made.sun.position.set(0.8, 0.8, 2);
    const wall = new THREE.Mesh(new THREE.PlaneGeometry(3, 3), new THREE.MeshLambertMaterial({ color: 0xffffff }));
    wall.position.z = -0.45;
    wall.receiveShadow = true;
    made.scene.add(wall);
    made.wear();
    const withShadow = sumOf(made.picture());
    for (const { meshes } of made.hair.batches.values()) for (const mesh of meshes) mesh.castShadow = false;
    const withoutShadow = sumOf(made.picture());
    wall.removeFromParent();
    const inSun = made.look();
    const roof = new THREE.Mesh(new THREE.PlaneGeometry(1.2, 1.2), new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
    roof.castShadow = true;
    roof.position.set(0.6, 0.6, 1.5);
    roof.lookAt(0, 0, 0);
    roof.material.colorWrite = roof.material.depthWrite = false;
    made.scene.add(roof);
    const under = made.look();
    return { lit: inSun.mean, shaded: under.mean, onWall: withShadow, bare: withoutShadow };
  });
  assert.ok(onWall < bare - 20000, `the wall is darker: ${onWall} of ${bare}`);
  assert.ok(shaded[0] < 0.7 * lit[0], `hair under a roof is darker: ${shaded[0]} of ${lit[0]}`);
});

test('heads of a crowd look as one does alone', async () => {
  const off = await onStage(() => {
    const { made } = window;
    const turned = (hair, head) => hair.follow(head, made.holder([0.05, 0.02, -0.1], 0.8));
    turned(made.wear(), 0);
    const alone = made.picture();
    const crowd = made.wear({ instances: 3 });
    turned(crowd, 2);
    for (const head of [0, 1]) crowd.follow(head, made.holder([50, 0, 0]));
    return made.compare(alone, made.picture());
  });
  assert.ok(off.count === 0, `${off.count} values differ, by up to ${off.most}`);
});

test('hair swings, and comes to rest where its head is', async () => {
  const { swung, rested } = await onStage(() => {
    const { made } = window;
    const hair = made.wear();
    for (let i = 0; i < 120; ++i) hair.update(1 / 60, made.camera);
    const still = made.picture();
    hair.position.x = 0.06;
    hair.update(1 / 60, made.camera);
    hair.position.x = 0;
    for (let i = 0; i < 4; ++i) hair.update(1 / 60, made.camera);
    const moved = made.compare(still, made.picture(1 / 60));
    for (let i = 0; i < 400; ++i) hair.update(1 / 60, made.camera);
    return { swung: moved.count, rested: made.compare(still, made.picture(1 / 60)).count };
  });
  assert.ok(swung > 500, `${swung} values changed`);
  assert.ok(rested < swung / 20, `${rested} values are still others`);
});

test('a material may change', async () => {
  const [own, red] = await onStage(() => {
    const { made } = window;
    const hair = made.wear();
    const before = made.look().mean;
    hair.updateMaterial({ baseColor: [1, 0.05, 0.05, 1], primaryColor: [0, 0, 0], secondaryColor: [0, 0, 0] });
    return [before, made.look().mean];
  });
  assert.ok(red[0] / red[1] > 1.5 * (own[0] / own[1]), `redder: ${red} than ${own}`);
});

test("hair is lit by a light probe and by the scene's environment", async () => {
  const [dark, probed, surrounded] = await onStage(() => {
    const { made } = window;
    const three = made.three;
    made.wear();
    made.scene.children.filter((child) => child.isLight).forEach((light) => light.removeFromParent());
    const nothing = made.look().mean;
    const probe = new three.LightProbe();
    probe.sh.coefficients[0].set(1, 1, 1);
    made.scene.add(probe);
    const lit = made.look().mean;
    probe.removeFromParent();
    const room = new three.Scene();
    room.background = new three.Color(0.3, 0.3, 0.3);
    made.scene.environment = new three.PMREMGenerator(made.renderer).fromScene(room).texture;
    const around = made.look().mean;
    made.clear();
    return [nothing, lit, around];
  });
  assert.ok(dark[0] < 2, `nothing lights it: ${dark}`);
  assert.ok(probed[0] > dark[0] + 20, `a probe does: ${probed}`);
  // Radiance 1 over the factor of the first harmonic, 0.282 in all, and 0.3 all around.
  assert.ok(Math.abs(surrounded[0] / probed[0] - 1) < 0.1, `as the room does: ${surrounded}, ${probed}`);
});

test('nothing grows from frame to frame, and dispose() gives everything back', async () => {
  const { grown, objects, free, memory } = await onStage(() => {
    const { made } = window;
    const freeBefore = made.coif.freeBytes;
    const before = { ...made.renderer.info.memory };
    made.wear({ instances: 4 });
    for (let i = 0; i < 10; ++i) made.picture(1 / 60);
    const some = { ...made.renderer.info.memory };
    const { buffer } = made.coif.wasmMemory;
    for (let i = 0; i < 190; ++i) {
      made.hair.rotation.y = 0.002 * i;
      made.picture(1 / 60);
    }
    const after = { ...made.renderer.info.memory };
    const isSame = buffer === made.coif.wasmMemory.buffer;
    made.clear();
    return { grown: [some, after], objects: [before, { ...made.renderer.info.memory }], free: [freeBefore, made.coif.freeBytes], memory: isSame };
  });
  assert.deepEqual(grown[1].textures, grown[0].textures);
  assert.ok(grown[1].geometries <= grown[0].geometries + 32, 'at most one more for each order that is seen');
  assert.equal(objects[1].geometries, objects[0].geometries);
  assert.ok(objects[1].textures <= objects[0].textures + 1, 'but for a shadow map');
  assert.equal(free[1], free[0]);
  assert.ok(memory, 'the module keeps its memory');
});

test('a lost context comes back with the same picture', async () => {
  const off = await onStage(async () => {
    const { made } = window;
    made.wear();
    const before = made.picture();
    await made.loseContext();
    return made.compare(before, made.picture());
  }, undefined, /context lost|CONTEXT_LOST/i);
  assert.equal(off.count, 0);
});

test("the README's page works when pasted", async () => {
  const example = /```html\n([^]*?)```/.exec(readFileSync(README, 'utf8'))[1];
  assert.ok(example.split('\n').length <= 30, 'it is short');
  pages.set('/pasted.html', example.replaceAll('./node_modules/three/', '/three/').replaceAll('./node_modules/coif/', '/coif/'));
  const { page, complaints } = await open('/pasted.html');
  await page.waitForFunction(() => document.querySelector('canvas') !== null, undefined, { timeout: 60000 });
  await page.waitForTimeout(2000);
  const colors = await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => {
    const canvas = document.querySelector('canvas');
    const copy = Object.assign(document.createElement('canvas'), { width: canvas.width, height: canvas.height }).getContext('2d');
    copy.drawImage(canvas, 0, 0);
    done(new Set(new Uint32Array(copy.getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size);
  })));
  const { steps, took } = await page.evaluate(async () => {
    const { CoifHair } = await import('coif/three');
    const { update } = CoifHair.prototype;
    const frames = [];
    CoifHair.prototype.update = function (delta, camera) {
      frames.push({ delta, at: document.timeline.currentTime });
      update.call(this, delta, camera);
    };
    while (frames.length < 8 || frames.at(-1).at === frames[0].at) await new Promise(requestAnimationFrame);
    return { steps: frames.slice(1).reduce((sum, { delta }) => sum + delta, 0), took: (frames.at(-1).at - frames[0].at) / 1000 };
  });
  await page.close();
  assert.deepEqual(complaints, []);
  assert.ok(colors > 100, `${colors} colours: something is drawn`);
  assert.ok(Math.abs(steps - took) < 1e-3, `frames that took ${took} s are stepped by ${steps} s`);
});
