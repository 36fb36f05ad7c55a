// The page of `coif view` as its visitors meet it: node view_test.mjs CASE. What it is given comes in the environment: COIF (the
// program), ASSET (a cooked sample), SOURCE (what it was cooked from), PAGE (the page without an asset), WORK (a folder of its own).

import { strict as assert } from 'node:assert';
import { execFileSync, spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { launch, onPage, openPage, take } from './browser.mjs';
import { psnr, readPng } from './png.mjs';

const { COIF, ASSET, SOURCE, PAGE, WORK } = process.env;
const SIZE = { width: 480, height: 360 };
const LEAST_DB = 40;

const inWork = (name) => join(WORK, name);
// What the page shows, too.
const PLAIN = ['--lights', 'plain', '--backdrop', 'light', '--head', 'ball', '--samples', '4'];
const coif = (...words) => execFileSync(COIF, words, { encoding: 'utf8', cwd: WORK });

function rendered(asset, ...options) {
  coif('render', asset, '-o', 'reference.png', '--size', `${SIZE.width}x${SIZE.height}`, '--view', '30,5', ...PLAIN, ...options);
  return readPng(inWork('reference.png')).rgba;
}

function makePage(asset = ASSET) {
  coif('view', asset, '-o', 'page.html', '--page', PAGE);
  return inWork('page.html');
}

/** Runs `act` on a page that shows the sample; the browser must not complain. */
const withPage = (act, viewport) => onPage(makePage(), act, viewport);

const countDifferent = (a, b) => a.reduce((sum, value, i) => sum + (value !== b[i] ? 1 : 0), 0);

/** Moves a slider or chooses a word, as a visitor does. */
async function move(page, id, value) {
  await page.$eval(id, (input, wanted) => {
    input.closest('details').open = true;
    input.value = wanted;
    input.dispatchEvent(new Event('input', { bubbles: true }));
    input.dispatchEvent(new Event('change', { bubbles: true }));
  }, String(value));
}

/** Into the recipe that the sample was cooked with, as the page says. */
function merged(tuned) {
  const own = JSON.parse(readFileSync(SOURCE.replace(/\.glb$/, '.recipe.json'), 'utf8').replace(/^\s*\/\/.*$/gm, ''));
  for (const [section, keys] of Object.entries(tuned)) own[section] = { ...own[section], ...keys };
  return own;
}

const recipeOf = (page) => page.evaluate(async () => (await window.coif).recipe());

const cases = {
  async opens_from_disk() {
    await withPage(async (page) => {
      const pixels = await take(page, SIZE);
      assert.ok(new Set(pixels).size > 50, 'the picture is empty');
      assert.equal(await page.textContent('#name'), 'bob.coif');
      assert.equal((await page.$$('input:not([id]):not([aria-label]), select:not([id])')).length, 0, 'a control without a name');
    });
    const browser = await launch();
    const { page, complaints } = await openPage(browser, PAGE);  // that nobody has filled in
    assert.match(await page.textContent('#problem'), /Drop a [.]coif/);
    await page.click('#front');
    await page.setInputFiles('#file', ASSET);
    await page.waitForFunction(() => document.getElementById('problem').hidden);
    assert.ok(new Set(await take(page, SIZE)).size > 50, 'a file that was dropped is not shown');
    assert.deepEqual(complaints, []);
    await browser.close();
    const most = statSync(PAGE).size + Math.ceil(statSync(ASSET).size / 3) * 4 + 1000;
    assert.ok(statSync(inWork('page.html')).size < most, 'the page is larger than its parts');
  },

  async draws_what_render_draws() {
    await withPage(async (page) => {
      const report = [];
      for (const mode of ['blend', 'opaque', 'coverage', 'proportional', 'jittered', 'screendoor', 'checkerboard', 'bayer', 'hashed']) {
        const db = psnr(await take(page, SIZE, { transparency: mode }), rendered(ASSET, '--transparency', mode));
        report.push(`${mode} ${db.toFixed(1)} dB`);
        assert.ok(db >= LEAST_DB, `${mode}: ${db} dB`);
      }
      for (const shadows of ['none', 'plain', 'opacity', 'deep']) {
        const db = psnr(await take(page, SIZE, { transparency: 'blend', shadows }), rendered(ASSET, '--shadows', shadows));
        report.push(`${shadows} ${db.toFixed(1)} dB`);
        assert.ok(db >= LEAST_DB, `shadows ${shadows}: ${db} dB`);
      }
      const bones = { transparency: 'blend', shadows: 'deep-shadow', bones: 1, colliders: 1 };
      const db = psnr(await take(page, SIZE, bones), rendered(ASSET, '--debug', 'bones,colliders'));
      report.push(`bones ${db.toFixed(1)} dB`);
      assert.ok(db >= 35, `bones: ${db} dB`);  // lines of a pixel, drawn by two rasterizers
      console.log(report.join('\n'));
    });
  },

  async draws_without_float_targets() {
    const browser = await launch();
    const hide = () => {
      const { getSupportedExtensions, getExtension } = WebGL2RenderingContext.prototype;
      const isHidden = (name) => /color_buffer/.test(name);
      WebGL2RenderingContext.prototype.getSupportedExtensions = function () {
        return getSupportedExtensions.call(this).filter((name) => !isHidden(name));
      };
      WebGL2RenderingContext.prototype.getExtension = function (name) { return isHidden(name) ? null : getExtension.call(this, name); };
    };
    const { page, complaints } = await openPage(browser, makePage(), undefined, hide);
    for (const shadows of ['deep-shadow', 'deep']) {
      const db = psnr(await take(page, SIZE, { shadows }), rendered(ASSET, '--shadows', shadows));
      console.log(`${shadows} in bytes ${db.toFixed(1)} dB`);
      assert.ok(db >= 35, `${shadows}: ${db} dB`);
    }
    assert.deepEqual(complaints, []);
    await browser.close();
  },

  async moved_sliders_change_picture_and_recipe() {
    await withPage(async (page) => {
      await take(page, SIZE);
      assert.deepEqual(await recipeOf(page), {});
      const before = await take(page, SIZE);
      await move(page, '#control-secondary_exponent', 90);
      const after = await take(page, SIZE);
      assert.ok(countDifferent(before, after) > 2000, 'the picture stays');
      await move(page, '#control-primary_shift', 1.1);
      await move(page, '#control-base_color', '#8090ff');
      await move(page, '#control-solver', 2);
      await move(page, '#control-friction', 5);
      const recipe = await recipeOf(page);
      assert.equal(recipe.material.secondary_exponent, 90);
      assert.equal(recipe.material.primary_shift, 1.1);
      assert.equal(recipe.material.base_color.length, 4);
      assert.deepEqual(recipe.dynamics, { friction: 5, model: 'passive' });
      assert.deepEqual(Object.keys(recipe).sort(), ['dynamics', 'material']);
      await page.click('#copy-recipe');
      assert.deepEqual(JSON.parse(await page.inputValue('#recipe-text')), recipe);
      assert.match(await page.textContent('#recipe-note'), /formulas that the cook uses/);
    });
  },

  async copied_recipe_cooks_what_was_seen() {
    await withPage(async (page) => {
      await take(page, SIZE);
      for (const [id, value] of [['primary_exponent', 60], ['primary_shift', 1], ['secondary_shift', 0.2], ['base_color', '#b0a0ff']]) {
        await move(page, `#control-${id}`, value);
      }
      const seen = await take(page, SIZE);
      writeFileSync(inWork('tuned.recipe.json'), JSON.stringify(merged(await recipeOf(page))));
      coif('cook', SOURCE, '-o', 'tuned.coif', '--recipe', 'tuned.recipe.json', '--threads', '2');
      const db = psnr(seen, rendered('tuned.coif'));
      console.log(`the cooked recipe: ${db.toFixed(1)} dB; untuned: ${psnr(seen, rendered(ASSET)).toFixed(1)} dB`);
      assert.ok(db >= LEAST_DB, `${db} dB`);
      assert.ok(psnr(seen, rendered(ASSET)) < LEAST_DB - 5, 'the recipe changes nothing');
    });
  },

  async frames_need_no_more_memory() {
    await withPage(async (page) => {
      await page.evaluate(async () => {
        const view = await window.coif;
        window.made = 0;
        for (const name of ['createBuffer', 'createTexture', 'createProgram', 'createVertexArray', 'createFramebuffer', 'bufferData']) {
          const real = WebGL2RenderingContext.prototype[name];
          WebGL2RenderingContext.prototype[name] = function (...words) { ++window.made; return real.apply(this, words); };
        }
        for (const [name, value] of [['motion', 'turn'], ['plays', 1], ['samples', 1], ['shadows', 'none'], ['transparency', 'opaque']]) view.set(name, value);
      });
      const run = (frames) => page.evaluate(async (frames) => {
        const view = await window.coif;
        view.draw(48, 40, 0);  // Between runs the page draws itself, in its own size.
        const made = window.made, drawn = view.wasm.numbers().drawn;
        for (let i = 0; i < frames; ++i) view.draw(48, 40, 1 / 60);
        window.gc();
        return { made: window.made - made, drawn: view.wasm.numbers().drawn - drawn, wasm: view.wasm.module.HEAPU8.length,
                 script: performance.memory.usedJSHeapSize };
      }, frames);
      const seen = [await run(200)];
      for (let i = 0; i < 3; ++i) seen.push(await run(300));
      const grown = (name) => seen.slice(1).map((after, i) => after[name] - seen[i][name]);
      const [made, drawn] = ['made', 'drawn'].map((name) => seen.slice(1).map((run) => run[name]));
      console.log(JSON.stringify({ wasm: grown('wasm'), script: grown('script'), made }));
      assert.deepEqual(drawn, [300, 300, 300]);
      assert.deepEqual(made, [0, 0, 0], 'objects of WebGL are made in frames');
      assert.deepEqual(grown('wasm'), [0, 0, 0]);
      // What is kept of each frame is kept in each of the runs; the browser's own comes or goes once, in any of them.
      const kept = grown('script').sort((a, b) => a - b)[1];
      assert.ok(kept < 75_000, `scripts keep ${kept} bytes of 300 frames`);
    }, { width: 320, height: 240 });
  },

  async lost_context_comes_back() {
    await withPage(async (page) => {
      const before = await take(page, SIZE);
      await page.evaluate(async () => {
        const view = await window.coif;
        const event = (name) => new Promise((done) => view.canvas.addEventListener(name, () => setTimeout(done), { once: true }));
        const loses = view.canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
        const lost = event('webglcontextlost');
        loses.loseContext();
        await lost;
        view.wake();
        const restored = event('webglcontextrestored');
        loses.restoreContext();
        await restored;
      });
      assert.equal(countDifferent(before, await take(page, SIZE)), 0);
    });
  },

  async heads_move_and_rest() {
    await withPage(async (page) => {
      const still = await take(page, SIZE, { shadows: 'none' });
      const moved = await page.evaluate(async () => {
        const view = await window.coif;
        view.set('motion', 'turn');
        view.set('plays', 1);
        for (let i = 0; i < 20; ++i) view.draw(64, 48, 1 / 60);
        view.set('plays', 0);
        view.set('motion', 'still');
        view.restart();
        view.set('beside', 'thesis');
        view.draw(64, 48, 0);
        view.set('beside', 'none');
        view.draw(64, 48, 0);
        const held = view.wasm.grab(0.5, 0.5);
        view.wasm.drag(0.2, 0);
        for (let i = 0; i < 10; ++i) view.draw(64, 48, 1 / 60);
        const asleep = view.wasm.numbers().asleep;
        view.wasm.release();
        return { held, asleep, cost: view.wasm.numbers().stepNsOfBone };
      });
      assert.deepEqual([moved.held, moved.asleep], [true, 0]);
      assert.ok(moved.cost >= 0 && moved.cost < 1e5, `${moved.cost} ns a bone`);
      const rested = await page.evaluate(async () => {
        const view = await window.coif;
        for (let i = 0; i < 1200 && !view.wasm.numbers().asleep; ++i) view.draw(64, 48, 1 / 60);
        return view.wasm.numbers().asleep;
      });
      assert.equal(rested, 1, 'the hair never rests');
      assert.ok(psnr(still, await take(page, SIZE)) > 38, 'hair comes back to where it hung');
    });
  },

  async bad_files_are_refused_as_on_the_command_line() {
    const good = readFileSync(ASSET);
    const files = { 'text.coif': Buffer.from('this text is long enough for a header, and more than that'), 'cut.coif': good.subarray(0, 5000),
                    'spoilt.coif': Buffer.concat([good.subarray(0, good.length - 9), Buffer.from('spoilt!!!')]), 'empty.coif': Buffer.alloc(0) };
    const browser = await launch();
    try {
      const { page } = await openPage(browser, makePage());
      for (const [name, bytes] of Object.entries(files)) {
        writeFileSync(inWork(name), bytes);
        const told = spawnSync(COIF, ['view', name, '-o', 'no.html', '--page', PAGE], { encoding: 'utf8', cwd: WORK });
        assert.notEqual(told.status, 0, name);
        await page.setInputFiles('#file', inWork(name));
        await page.waitForFunction(() => !document.getElementById('problem').hidden);
        const shown = await page.textContent('#problem');
        assert.equal(`coif view: error: ${shown}`, told.stderr.trim());
        await page.evaluate(async () => (await window.coif).say(''));
      }
      copyFileSync(ASSET, inWork('other.coif'));
      await page.setInputFiles('#file', inWork('other.coif'));
      await page.waitForFunction(() => document.getElementById('name').textContent === 'other.coif');
      assert.ok(new Set(await take(page, SIZE)).size > 50, 'what was shown is gone');
    } finally {
      await browser.close();
    }
  },
};

const wanted = process.argv[2];
if (!(wanted in cases)) throw new Error(`no case ${wanted}; there are ${Object.keys(cases).join(', ')}`);
mkdirSync(WORK, { recursive: true });
await cases[wanted]();
