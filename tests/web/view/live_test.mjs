// `coif view` of a source, as its visitors meet it: node live_test.mjs CASE. COIF, SOURCE, PAGE and WORK come in the environment, as
// for view_test.mjs.

import { strict as assert } from 'node:assert';
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { take } from './browser.mjs';
import { cooked, get, inWork, revision, setUp, until, withView, write } from './live_view.mjs';
import { psnr } from './png.mjs';

const { SOURCE, WORK } = process.env;
const SIZE = { width: 320, height: 240 };

const cases = {
  async sliders_cook_and_change_the_picture() {
    await withView(async (page) => {
      assert.match(await page.textContent('#name'), /^bob\.glb$/);
      assert.match(await page.textContent('#cooked'), /^Cooked as a draft in/);
      await setUp(page, 'motion', 1);
      await page.evaluate(() => { const { view } = window; view.set('yaw', 70); for (let i = 0; i < 30; ++i) view.draw(64, 48, 1 / 60); view.play(); });
      const time = await page.evaluate(() => window.view.wasm.numbers().time);
      assert.ok(time > 0.4, `${time} s`);
      const before = await take(page, SIZE, { samples: 1 });
      await setUp(page, 'primary_exponent', 40);
      await setUp(page, 'opaque_threshold', 0.5);
      const tuned = await take(page, SIZE);
      await cooked(page, 2);
      assert.deepEqual([await get(page, 'yaw'), await get(page, 'motion'), await get(page, 'primary_exponent')], [70, 1, 40]);
      assert.ok(Math.abs(await page.evaluate(() => window.view.wasm.numbers().time) - time) < 0.1, 'the motion begins anew');
      const after = await take(page, SIZE);
      const own = await page.evaluate(() => window.view.original[window.view.control('primary_exponent').at]);
      assert.equal(own, 250, "as it came is as the recipe's file has it");
      console.log(`tuned: ${psnr(before, tuned).toFixed(1)} dB from before, cooked: ${psnr(tuned, after).toFixed(1)} dB from tuned`);
      assert.ok(psnr(before, tuned) < 45, 'the slider changes nothing');
      const material = await page.evaluate(() => window.view.live.state.changes.material);
      assert.deepEqual(material, { opaque_threshold: 0.5, primary_exponent: 40 });

      await page.click('#copy-recipe');
      const recipe = JSON.parse(await page.inputValue('#recipe-text'));
      assert.equal(recipe.material.primary_exponent, 40);
      assert.equal(recipe.material.secondary_exponent, 150, "the file's own is kept");
      assert.deepEqual(recipe.hair, { meshes: ['hair'] });
      await page.click('#close-recipe');

      const last = await revision(page);
      await page.click('.row:has(#control-primary_exponent) .reset');
      await cooked(page, last + 1);
      assert.equal(await get(page, 'primary_exponent'), 250);
    });
  },

  async files_cook_and_problems_keep_the_hair() {
    await withView(async (page, view) => {
      const before = await take(page, SIZE, { samples: 1 });
      const recipe = readFileSync(inWork('bob.recipe.json'), 'utf8');
      write('bob.recipe.json', recipe.replace('"primary_exponent": 250', '"primary_exponent": 30').replace('[1.7, 1.6, 1.5]', '[4, 0, 0]'));
      await cooked(page, 2);
      assert.equal(await get(page, 'primary_exponent'), 30);
      const after = await take(page, SIZE);
      assert.ok(psnr(before, after) < 45, 'the file changes nothing');

      write('bob.recipe.json', '{"material": {"primary_shft": 1}}');
      await until(page, () => document.querySelector('#cooked.problem') !== null);
      const shown = await page.textContent('#cooked');
      assert.ok(view.said.includes(`coif view: error: ${shown}\n`), `${shown}\n${view.said}`);
      assert.deepEqual(await take(page, SIZE), after, 'the last good hair is gone');

      write('bob.recipe.json', recipe);
      await cooked(page, 3);
      await until(page, () => document.querySelector('#cooked.problem') === null);
      await page.setInputFiles('#file', { name: 'other hair.glb', mimeType: 'model/gltf-binary', buffer: readFileSync(SOURCE) });
      await until(page, () => document.getElementById('name').textContent === 'other hair.glb');
      assert.ok(new Set(await take(page, SIZE)).size > 50, 'nothing is shown');
    });
  },
};

const wanted = process.argv[2];
if (!(wanted in cases)) throw new Error(`no case ${wanted}; there are ${Object.keys(cases).join(', ')}`);
rmSync(WORK, { recursive: true, force: true });
mkdirSync(WORK, { recursive: true });
await cases[wanted]();
