// Hair that is tuned while a server cooks it: node tune_live_test.mjs CASE. The environment is that of live_test.mjs.

import { strict as assert } from 'node:assert';
import { mkdirSync, rmSync } from 'node:fs';
import { take } from './browser.mjs';
import { cooked, get, revision, setUp, withView } from './live_view.mjs';
import { psnr } from './png.mjs';

const { WORK } = process.env;
const SIZE = { width: 320, height: 240 };

const changes = (page) => page.evaluate(() => window.view.live.state.changes);
/** The bones' mean damping ratio, as the asset has it. */
const ownRatio = (page) => page.evaluate(() => {
  const { bones } = window.view.wasm.motion().damping_ratio;
  return bones.reduce((sum, [, value]) => sum + value, 0) / bones.length;
});

const cases = {
  async liveliness_and_tint_are_cooked() {
    await withView(async (page) => {
      await page.evaluate(() => { for (const [name, value] of [['samples', 1], ['shadows', 'none']]) window.view.set(name, value); });
      const before = await ownRatio(page), untinted = await take(page, SIZE);
      await setUp(page, 'liveliness', 0.25);
      await cooked(page, 2);
      assert.deepEqual((await changes(page)).dynamics, { liveliness: 0.25 });
      assert.ok(Math.abs(await ownRatio(page) - 0.75) < 0.01, `${await ownRatio(page)}, before ${before}`);
      assert.ok(Math.abs(await get(page, 'liveliness') - 0.25) < 1e-6);

      const last = await revision(page);
      await setUp(page, 'base_color', '#8060ff');
      const tinted = await take(page, SIZE);
      await cooked(page, last + 1);
      const { base_color: color } = (await changes(page)).material;
      assert.equal(color.length, 4);
      assert.ok(color[0] < 0.4 && color[2] === 1 && color[3] === 1, `${color}`);
      const after = await take(page, SIZE);
      console.log(`tinted: ${psnr(untinted, tinted).toFixed(1)} dB from before, cooked: ${psnr(tinted, after).toFixed(1)} dB from tinted`);
      assert.ok(psnr(untinted, tinted) < 35 && psnr(tinted, after) > 45, 'the tint counts twice, or not at all');

      await page.click('#copy-recipe');
      const recipe = JSON.parse(await page.inputValue('#recipe-text'));
      assert.deepEqual([recipe.material.base_color, recipe.dynamics.liveliness], [color, 0.25]);
      assert.equal(recipe.material.primary_exponent, 250, "the file's own is kept");
      await page.click('#close-recipe');

      const again = await revision(page);
      await page.click('.row:has(#control-base_color) .reset');
      await cooked(page, again + 1);
      assert.equal((await changes(page)).material, undefined);
      assert.ok(psnr(untinted, await take(page, SIZE)) > 45, 'the tint stays');
    });
  },

  async curves_are_cooked_once() {
    await withView(async (page) => {
      await page.focus('#curve-resistance .point');
      await page.keyboard.press('Shift+ArrowDown');
      const drawn = await page.evaluate(() => window.view.tuning.editors[0].points);
      await cooked(page, 2);
      assert.deepEqual((await changes(page)).dynamics.resistance, drawn);
      const { resistance } = await page.evaluate(() => window.view.wasm.motion());
      assert.ok(Math.abs(resistance.points[0][1] - drawn[0][1]) < 1e-3, JSON.stringify(resistance));
      assert.deepEqual(await page.evaluate(() => window.view.tuning.editors[0].points), drawn, 'the curve stays as it was drawn');
      assert.deepEqual((await page.evaluate(() => window.view.recipe())).dynamics.resistance, drawn);
      assert.ok(await page.evaluate(() => document.activeElement.getAttribute('aria-label')?.startsWith('Stiffness')), 'the focus stays, for the next key');
    });
  },

  async every_other_key_can_be_found_and_set() {
    await withView(async (page) => {
      await page.click('#recipe-keys > summary');
      const shown = () => page.$$eval('#recipe-keys .key:not([hidden]) label', (labels) => labels.map((label) => label.title));
      const all = await shown();
      assert.ok(all.length > 40, `${all}`);
      assert.ok(!all.includes('material.primary_exponent') && !all.includes('dynamics.liveliness'), 'they have controls already');
      await page.fill('#search-keys', 'parent share');
      assert.deepEqual(await shown(), ['dynamics.parent_share']);
      assert.match(await page.textContent('#key-dynamics-parent_share-help'), /share of the pull .*0 to 1; default 1/s);
      await page.fill('.key:has(#key-dynamics-parent_share) input[type=number]', '0.5');
      await page.dispatchEvent('.key:has(#key-dynamics-parent_share) input[type=number]', 'change');
      await cooked(page, 2);
      assert.deepEqual(await changes(page), { dynamics: { parent_share: 0.5 } });

      await page.fill('#search-keys', 'energy');
      await page.selectOption('#key-material-energy', 'bounded');
      await cooked(page, 3);
      assert.deepEqual(await changes(page), { dynamics: { parent_share: 0.5 }, material: { energy: 'bounded' } });
      await page.fill('#search-keys', 'no such words');
      assert.deepEqual(await shown(), []);
      await page.fill('#search-keys', 'parent');
      await page.click('.key:has(#key-dynamics-parent_share) .reset');
      await cooked(page, 4);
      assert.deepEqual(await changes(page), { material: { energy: 'bounded' } });
    });
  },
};

const wanted = process.argv[2];
if (!(wanted in cases)) throw new Error(`no case ${wanted}; there are ${Object.keys(cases).join(', ')}`);
rmSync(WORK, { recursive: true, force: true });
mkdirSync(WORK, { recursive: true });
await cases[wanted]();
