// How hair moves, as visitors of the page of `coif view` tune it: node tune_test.mjs CASE. The environment is that of view_test.mjs.

import { strict as assert } from 'node:assert';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { onPage, take } from './browser.mjs';
import { psnr } from './png.mjs';

const { COIF, ASSET, SOURCE, PAGE, WORK } = process.env;
const SIZE = { width: 320, height: 240 };
const STEPS = 40;
const inWork = (name) => join(WORK, name);
const coif = (...words) => execFileSync(COIF, words, { encoding: 'utf8', cwd: WORK });

/** Runs `act` on a page that shows `asset`; the browser must not complain. */
async function withPage(asset, act) {
  coif('view', asset, '-o', 'page.html', '--page', PAGE);
  await onPage(inWork('page.html'), async (page) => {
    await page.evaluate(async () => {
      window.view = await window.coif;
      window.view.wake = () => {};  // time goes on where a test says so
      for (const [name, value] of [['samples', 1], ['shadows', 'none'], ['transparency', 'opaque']]) window.view.set(name, value);
    });
    await act(page);
  }, { width: 640, height: 900 });
}

/** At rest in a wind, which soft hair yields to, and in the middle of a motion. */
async function pictures(page) {
  await page.evaluate(() => { const { view } = window; view.set('motion', 'still'); view.set('plays', 0); view.set('wind', 5); view.restart(); });
  const rest = await take(page, SIZE);
  await page.evaluate((steps) => {
    const { view } = window;
    view.set('wind', 0);
    view.set('motion', 'charge');
    view.set('plays', 1);
    view.restart();
    for (let i = 0; i < steps; ++i) view.draw(64, 48, 1 / 60);
  }, STEPS);
  const moved = await take(page, SIZE);
  await page.evaluate(() => { const { view } = window; view.set('plays', 0); view.set('motion', 'still'); view.restart(); });
  return { rest, moved };
}

const recipeOf = (page) => page.evaluate(() => window.view.recipe());

/** Whether the hair that `page` shows moves as that which its recipe cooks to; `own`: the recipe that it is merged into. */
async function compareWithCook(page, own, untuned, wanted) {
  const seen = await pictures(page);
  const recipe = await recipeOf(page);
  const all = { ...own };
  for (const [section, keys] of Object.entries(recipe)) all[section] = { ...all[section], ...keys };
  writeFileSync(inWork('tuned.recipe.json'), JSON.stringify(all));
  coif('cook', SOURCE, '-o', 'tuned.coif', '--recipe', 'tuned.recipe.json', '--threads', '2');
  await withPage('tuned.coif', async (other) => {
    const cooked = await pictures(other);
    const db = Object.keys(seen).map((which) => [which, psnr(seen[which], cooked[which]), psnr(seen[which], untuned[which])]);
    console.log(`${JSON.stringify(recipe)}\n${db.map(([which, tuned, before]) => `${which}: ${tuned.toFixed(1)} dB from the cooked recipe, ${before.toFixed(1)} from untuned`).join('\n')}`);
    assert.ok(db[0][1] >= wanted.rest, 'at rest');
    assert.ok(db[1][1] >= wanted.moved, 'in motion');
    assert.ok(db[1][2] < wanted.moved - 6, 'the tuning changes nothing');
  });
}

const bobsRecipe = () => JSON.parse(readFileSync(SOURCE.replace(/\.glb$/, '.recipe.json'), 'utf8').replace(/^\s*\/\/.*$/gm, ''));
const pointsOf = (page, name) => page.evaluate((of) => window.view.tuning.editors.find((e) => e.about.name === of).points, name);

/** Drags a point by so many pixels. */
async function drag(page, point, across, down) {
  await point.scrollIntoViewIfNeeded();
  const box = await point.boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + across / 2, y + down / 2);
  await page.mouse.move(x + across, y + down);
  await page.mouse.up();
}

async function choose(page, name, value) {
  await page.$eval(`#control-${name}`, (input, wanted) => {
    input.value = wanted;
    input.dispatchEvent(new Event('input', { bubbles: true }));
    input.dispatchEvent(new Event('change', { bubbles: true }));
  }, String(value));
}

const cases = {
  async points_are_dragged_and_moved_by_keys() {
    await withPage(ASSET, async (page) => {
      const before = await pictures(page);
      const own = await pointsOf(page, 'resistance');
      assert.deepEqual(own, [[0, 0.35], [1, 0.06]], "the recipe's curve, found again in the bones");
      assert.deepEqual(await recipeOf(page), {}, 'nobody changed anything');

      const handles = page.locator('#curve-resistance .point');
      await drag(page, handles.first(), 0, 60);
      const dragged = await pointsOf(page, 'resistance');
      assert.ok(dragged[0][1] < 0.2 && dragged[0][1] > 0.001, `${dragged}`);
      assert.deepEqual(dragged[1], own[1]);
      const after = await pictures(page);
      assert.ok(psnr(before.moved, after.moved) < 40, 'dragging changes no motion');
      const { dynamics } = await recipeOf(page);
      assert.deepEqual(dynamics.resistance, dragged);

      await handles.first().focus();
      await page.keyboard.press('ArrowUp');
      await page.keyboard.press('Enter');  // a second one, which has the focus
      await page.keyboard.press('Shift+ArrowDown');
      await page.keyboard.press('ArrowRight');
      const moved = await pointsOf(page, 'resistance');
      assert.equal(moved.length, 3);
      assert.ok(moved[0][1] > dragged[0][1] && Math.abs(moved[1][0] - 0.51) < 1e-6, `${moved}`);
      const [role, label, text, top] = await page.evaluate(() => ['role', 'aria-label', 'aria-valuetext', 'aria-valuemax'].map((name) => document.activeElement.getAttribute(name)));
      assert.deepEqual([role, label, top], ['slider', 'Stiffness, point 2 of 3', '1']);
      assert.match(text, /^at 51 % of the chain: 0[.]\d+$/);
      await page.keyboard.press('Tab');
      assert.equal(await page.evaluate(() => document.activeElement.getAttribute('aria-label')), 'Stiffness, point 3 of 3');
      await page.keyboard.press('Shift+Tab');
      await page.keyboard.press('Delete');
      assert.equal((await pointsOf(page, 'resistance')).length, 2);

      const box = await page.locator('#curve-resistance svg').boundingBox();
      await page.mouse.dblclick(box.x + box.width / 2, box.y + 20);
      assert.equal((await pointsOf(page, 'resistance')).length, 3);
      await handles.nth(1).dblclick();
      assert.equal((await pointsOf(page, 'resistance')).length, 2);

      await page.click('#curve-resistance .reset');
      assert.deepEqual(await recipeOf(page), {});
      assert.deepEqual(await pictures(page), before, "the asset's own bones are back to the bit");
    });
  },

  async tuned_curves_are_what_their_recipe_cooks() {
    await withPage(ASSET, async (page) => {
      const untuned = await pictures(page);
      await drag(page, page.locator('#curve-resistance .point').first(), 0, 25);
      await drag(page, page.locator('#curve-damping_ratio .point').last(), 0, -20);
      assert.notDeepEqual(await pointsOf(page, 'resistance'), [[0, 0.35], [1, 0.06]]);
      await choose(page, 'gravity_scale', 0.7);
      await compareWithCook(page, bobsRecipe(), untuned, { rest: 40, moved: 34 });
      await page.click('#copy-recipe');
      const copied = JSON.parse(await page.inputValue('#recipe-text'));
      assert.deepEqual(copied, await recipeOf(page));
      assert.match(await page.textContent('#recipe-note'), /formulas that the cook uses/);
    });
  },

  async liveliness_is_what_its_recipe_cooks() {
    await withPage(ASSET, async (page) => {
      const untuned = await pictures(page);
      await choose(page, 'liveliness', 0.2);
      assert.deepEqual(await recipeOf(page), { dynamics: { liveliness: 0.2 } });
      await compareWithCook(page, bobsRecipe(), untuned, { rest: 40, moved: 34 });
      await drag(page, page.locator('#curve-damping_ratio .point').first(), 0, -20);
      const { dynamics } = await recipeOf(page);
      assert.deepEqual(Object.keys(dynamics), ['damping_ratio'], 'a curve takes the place of the slider');
      await choose(page, 'liveliness', 0.3);
      assert.deepEqual(await recipeOf(page), { dynamics: { liveliness: 0.3 } });
    });
  },

  async presets_are_found_in_the_asset_and_changed() {
    const own = bobsRecipe();
    own.dynamics = { preset: 'natural' };
    writeFileSync(inWork('natural.recipe.json'), JSON.stringify(own));
    coif('cook', SOURCE, '-o', 'natural.coif', '--recipe', 'natural.recipe.json', '--threads', '2');
    await withPage('natural.coif', async (page) => {
      const untuned = await pictures(page);
      assert.equal(await page.evaluate(() => window.view.word('preset')), 'natural');
      await choose(page, 'preset', 2);
      assert.deepEqual(await recipeOf(page), { dynamics: { preset: 'stiff' } });
      await compareWithCook(page, own, untuned, { rest: 40, moved: 34 });
    });
    await withPage(ASSET, async (page) => {
      assert.ok(await page.isDisabled('#control-preset'), 'numbers of its own are left out by a cook alone');
    });
  },
};

const wanted = process.argv[2];
if (!(wanted in cases)) throw new Error(`no case ${wanted}; there are ${Object.keys(cases).join(', ')}`);
mkdirSync(WORK, { recursive: true });
await cases[wanted]();
