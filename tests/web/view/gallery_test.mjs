// `coif gallery -o sheet.html` as its visitors meet it: node gallery_test.mjs CASE. COIF, ASSET, PAGE and WORK come in the environment,
// as for view_test.mjs.

import { strict as assert } from 'node:assert';
import { execFileSync } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { launch, openPage } from './browser.mjs';
import { psnr, readPng } from './png.mjs';

const { COIF, ASSET, PAGE, WORK } = process.env;
const SIDE = 160;  // pixels of a tile
const WIDE = { width: 1100, height: 700 };  // room for six of them

const inWork = (name) => join(WORK, name);
const gallery = (out, ...options) => JSON.parse(execFileSync(COIF, ['gallery', ASSET, '-o', out, '--size', `${SIDE}x${SIDE}`, '--format', 'json', ...options],
  { encoding: 'utf8', cwd: WORK }));
const makeSheet = (...options) => gallery('sheet.html', '--page', PAGE, ...options);

/** Before a page's scripts: how many canvases get a WebGL context. */
function countContexts() {
  window.contexts = new Set();
  for (const canvas of [HTMLCanvasElement, OffscreenCanvas]) {
    const real = canvas.prototype.getContext;
    canvas.prototype.getContext = function (kind, ...words) {
      if (/webgl/.test(kind)) window.contexts.add(this);
      return real.call(this, kind, ...words);
    };
  }
}

/** Runs `act` on sheet.html; the browser must not complain. */
async function withSheet(act, viewport = WIDE, before = countContexts) {
  const browser = await launch();
  try {
    const { page, complaints } = await openPage(browser, inWork('sheet.html'), viewport, before);
    page.setDefaultTimeout(120_000);
    await page.evaluate(async () => { window.view = await window.coif; window.sheet = window.view.sheet; });
    await act(page);
    assert.deepEqual(complaints, [], 'the browser complains');
    assert.equal(await page.textContent('#sheet-problem'), '');
    assert.equal(await page.textContent('#problem'), '');
  } finally {
    await browser.close();
  }
}

const pause = (page) => page.evaluate(() => window.sheet.playAll(false));
/** Until all tiles that are seen are as they should be; nothing plays. */
const drawn = (page) => page.waitForFunction(() => {
  const seen = window.sheet.tiles.filter((tile) => tile.isSeen);
  return seen.length > 0 && seen.every((tile) => tile.drawn > 0 && !tile.wantsDrawing());
});
const scrollTo = (page, number) => page.evaluate((n) => window.sheet.tiles[n].figure.scrollIntoView({ block: 'center' }), number);

/** Pixels of a tile, RGBA. */
async function pixelsOf(page, number) {
  const values = await page.evaluate((n) => {
    const { canvas } = window.sheet.tiles[n];
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
    copy.drawImage(canvas, 0, 0);
    return Array.from(copy.getImageData(0, 0, canvas.width, canvas.height).data);
  }, number);
  return Uint8Array.from(values);
}

/** One picture of the PNG's first row: there are 8 pixels around everything, and a title's line above. */
function pictureOf(sheet, column) {
  const left = 8 + column * (SIDE + 8), top = 8 + 24 + 8;
  const out = new Uint8Array(4 * SIDE * SIDE);
  for (let y = 0; y < SIDE; ++y) {
    const begin = 4 * ((top + y) * sheet.width + left);
    out.set(sheet.rgba.subarray(begin, begin + 4 * SIDE), 4 * SIDE * y);
  }
  return out;
}

const cases = {
  async shows_every_picture_or_says_which_not() {
    const told = makeSheet();
    const { pictures } = gallery('sheet.png');
    await withSheet(async (page) => {
      const shown = await page.evaluate(() => window.sheet.plan.galleries.flatMap((g) => g.tiles.map((tile) => Math.max(tile.moments.length, 1))));
      assert.equal(shown.length, told.tiles);
      assert.equal((await page.$$('.tile canvas')).length, told.tiles);
      assert.equal(shown.reduce((sum, n) => sum + n, 0) + told.pictures_left_out, pictures);
      assert.match(await page.textContent('#sheet-note'), /Left out.*a hand through hair.*\(18 pictures\)/);
      assert.equal((await page.$$('.moments button')).length, shown.filter((n) => n > 1).reduce((sum, n) => sum + n, 0));
      await pause(page);
      const looks = new Set();
      for (let i = 0; i < told.tiles; ++i) {
        await scrollTo(page, i);
        await page.waitForFunction((n) => window.sheet.tiles[n].drawn > 0 && !window.sheet.tiles[n].wantsDrawing(), i);
        looks.add(Buffer.from(await pixelsOf(page, i)).toString('base64'));
      }
      // Three of gallery 2 and of gallery 3 are of the same material as one of gallery 1.
      assert.ok(looks.size >= told.tiles - 6, `${looks.size} different pictures in ${told.tiles} tiles`);
      assert.equal(await page.evaluate(() => window.contexts.size), 1, 'contexts of WebGL');
    });
  },

  async still_tiles_are_the_pictures_of_the_png() {
    for (const only of [1, 2, 3, 4]) {
      makeSheet('--only', String(only));
      gallery('sheet.png', '--only', String(only));
      const sheet = readPng(inWork('sheet.png'));
      await withSheet(async (page) => {
        await drawn(page);
        for (let column = 0; column < 6; ++column) {
          const db = psnr(await pixelsOf(page, column), pictureOf(sheet, column));
          console.log(`gallery ${only}, ${column}: ${db.toFixed(1)} dB`);
          assert.ok(db >= 38, `gallery ${only}, tile ${column}: ${db} dB`);
        }
      });
    }
  },

  async only_tiles_that_are_seen_are_drawn() {
    makeSheet();
    await withSheet(async (page) => {
      await page.waitForFunction(() => window.sheet.tiles.every((tile) => !tile.isSeen || tile.drawn > 0));
      const state = () => page.evaluate(() => window.sheet.tiles.map(({ drawn: times, view, isSeen, plays }) => ({ times, view, isSeen, plays })));
      const before = await state();
      assert.ok(before.filter((tile) => !tile.isSeen).length > 10, 'all fit the window');
      for (const tile of before.filter((t) => !t.isSeen)) assert.deepEqual([tile.times, tile.view], [0, 0], 'one out of sight is drawn, or has a view');
      assert.ok(before.some((tile) => tile.plays && !tile.isSeen), 'nothing that plays is out of sight');

      await scrollTo(page, before.length - 1);
      const last = before.length - 1;
      await page.waitForFunction((n) => window.sheet.tiles[n].drawn > 3, last);
      const gone = await state();
      assert.equal(gone[0].isSeen, false);
      await page.waitForFunction(([n, times]) => window.sheet.tiles[n].drawn > times + 3, [last, gone[last].times]);
      const later = await state();
      assert.equal(later[0].times, gone[0].times, 'one that went out of sight is drawn');

      await scrollTo(page, 0);
      await page.waitForFunction(() => window.sheet.tiles.at(-1).isSeen === false);
      const { times } = (await state())[last];
      await page.evaluate(() => { window.sheet.tiles[0].change(); });
      await drawn(page);
      assert.equal((await state())[last].times, times, 'motion goes on out of sight');
    });
  },

  async opens_a_tile_and_goes_back_by_keyboard() {
    makeSheet('--only', '3');
    await withSheet(async (page) => {
      await drawn(page);
      const before = await pixelsOf(page, 2);
      await page.focus('.tile:nth-of-type(3) canvas');
      await page.keyboard.press('ArrowRight');
      await page.keyboard.press('Enter');
      assert.equal(await page.evaluate(() => document.activeElement.id), 'picture');
      assert.equal(await page.isVisible('#panel'), true);
      assert.equal(await page.isVisible('#sheet'), false);
      assert.match(await page.textContent('#name'), /^bob[.]coif: primary 1000, secondary 70$/);
      assert.equal(await page.evaluate(() => window.view.get('yaw')), 35);
      assert.equal(await page.evaluate(() => window.view.get('primary_exponent')), 1000);
      assert.equal((await page.evaluate(() => window.view.recipe())).material.primary_exponent, 1000, 'an artist goes on from here');
      assert.equal(await page.inputValue('#control-primary_exponent'), '1000');
      const picture = await page.evaluate(() => new Set(window.view.take(320, 240)).size);
      assert.ok(picture > 50, 'the picture is empty');

      await page.evaluate(() => { window.view.set('primary_exponent', 5); });
      await page.click('#copy-recipe');
      await page.keyboard.press('Escape');  // of the dialog alone
      assert.equal(await page.isVisible('#panel'), true);
      await page.focus('#picture');
      await page.keyboard.press('Escape');
      assert.equal(await page.isVisible('#panel'), false);
      assert.equal(await page.isVisible('#sheet'), true);
      assert.equal(await page.evaluate(() => document.activeElement.className), 'tile-open');
      await page.click('#sheet-face');
      await drawn(page);
      assert.equal(Buffer.compare(Buffer.from(before), Buffer.from(await pixelsOf(page, 2))), 0, 'the tile is not what it was');

      await page.focus('.tile:nth-of-type(3) .tile-open');
      await page.keyboard.press('Enter');
      assert.equal(await page.evaluate(() => window.view.get('primary_exponent')), 1000, 'a tile opens as it is');
      await page.click('#leave-tile');
      assert.equal(await page.isVisible('#sheet'), true);
    });
  },

  async tiles_turn_together_or_alone() {
    makeSheet('--only', '1');
    await withSheet(async (page) => {
      await drawn(page);
      const all = async () => Promise.all([0, 1, 2, 3, 4, 5].map(async (n) => Buffer.from(await pixelsOf(page, n)).toString('base64')));
      const still = await all();
      const drag = async () => {
        const box = await (await page.$('.tile canvas')).boundingBox();
        await page.mouse.move(box.x + 40, box.y + 40);
        await page.mouse.down();
        await page.mouse.move(box.x + 90, box.y + 40, { steps: 3 });
        await page.mouse.up();
        await drawn(page);
      };
      await drag();
      const together = await all();
      assert.ok(together.every((picture, n) => picture !== still[n]), 'not all turn');
      await page.uncheck('#sheet-together');
      await drag();
      const alone = await all();
      assert.deepEqual(alone.map((picture, n) => picture !== together[n]), [true, false, false, false, false, false]);
      await page.click('#sheet-face');
      await drawn(page);
      assert.deepEqual(await all(), still);
    });
  },

  async motion_waits_for_a_click_where_less_of_it_is_wanted() {
    makeSheet('--only', '5');
    await withSheet(async (page) => {
      assert.ok(await page.evaluate(() => window.sheet.tiles.every((tile) => tile.plays)), 'motion plays by itself');
      await page.waitForFunction(() => window.sheet.tiles.every((tile) => tile.drawn > 4 && tile.time > 0));
      await page.emulateMedia({ reducedMotion: 'reduce' });
      await page.waitForFunction(() => window.sheet.tiles.every((tile) => !tile.plays));
      await page.reload();
      await page.evaluate(async () => { window.view = await window.coif; window.sheet = window.view.sheet; });
      await drawn(page);
      assert.ok(await page.evaluate(() => window.sheet.tiles.every((tile) => !tile.plays && tile.time > 0)), 'a moment of the motion is shown');
      assert.equal(await page.textContent('#sheet-play'), 'Play all');

      await page.click('.tile-play');
      assert.deepEqual(await page.evaluate(() => window.sheet.tiles.map((tile) => tile.plays)), [true, false, false, false]);
      await page.waitForFunction(() => window.sheet.tiles[0].time > 0.1);
      await page.click('.moments button:nth-child(3)');
      await drawn(page);
      const moment = await page.evaluate(() => window.sheet.tiles[0].time);
      assert.equal(moment, 0.3);
      assert.equal(await page.getAttribute('.moments button:nth-child(3)', 'aria-pressed'), 'true');
      const held = await pixelsOf(page, 0);
      await page.click('.moments button:nth-child(1)');
      await drawn(page);
      assert.ok(psnr(held, await pixelsOf(page, 0)) < 35, 'two moments look alike');
      await page.click('.moments button:nth-child(3)');
      await drawn(page);
      assert.equal(Buffer.compare(Buffer.from(held), Buffer.from(await pixelsOf(page, 0))), 0, 'a moment is not what it was');
    });
  },

  async rounds_need_no_more_memory() {
    makeSheet();
    await withSheet(async (page) => {
      await scrollTo(page, 30);
      await page.waitForFunction(() => window.sheet.tiles[30].drawn > 0);
      const grown = await page.evaluate(() => {
        const { sheet, view } = window;
        cancelAnimationFrame(sheet.waiting);
        sheet.wake = () => {};
        let made = 0;
        for (const name of ['createBuffer', 'createTexture', 'createProgram', 'createVertexArray', 'createFramebuffer', 'bufferData']) {
          const real = WebGL2RenderingContext.prototype[name];
          WebGL2RenderingContext.prototype[name] = function (...words) { ++made; return real.apply(this, words); };
        }
        const used = () => { window.gc(); return performance.memory.usedJSHeapSize; };
        const moving = sheet.tiles.filter((tile) => tile.moves());
        const run = (rounds) => { for (let i = 0; i < rounds; ++i) for (const tile of moving) tile.draw(1 / 5); };
        run(20);
        const before = { script: used(), wasm: view.wasm.module.HEAPU8.length };
        made = 0;
        run(40);  // each motion begins anew
        return { made, tiles: moving.length, script: used() - before.script, wasm: view.wasm.module.HEAPU8.length - before.wasm };
      });
      console.log(JSON.stringify(grown));
      assert.ok(grown.tiles >= 6);
      assert.equal(grown.made, 0, 'objects of WebGL are made in frames');
      assert.equal(grown.wasm, 0);
      assert.ok(grown.script < 500_000, `scripts keep ${grown.script} bytes`);
    });
  },

  async other_files_take_the_place_of_the_sheet() {
    makeSheet('--only', '1');
    await withSheet(async (page) => {
      await drawn(page);
      const bad = { name: 'notes.coif', mimeType: 'text/plain', buffer: Buffer.from('this text is long enough for a header, and more than that') };
      await page.setInputFiles('#file', bad);  // as a file that is dropped
      await page.waitForFunction(() => !document.getElementById('sheet-problem').hidden);
      assert.match(await page.textContent('#sheet-problem'), /^notes[.]coif: not a cooked hair asset/);
      assert.equal(await page.isVisible('#sheet'), true, 'what was shown is gone');
      await page.setInputFiles('#file', ASSET);
      await page.waitForFunction(() => document.getElementById('sheet').hidden);
      assert.ok(await page.evaluate(() => new Set(window.view.take(320, 240)).size) > 50, 'the picture is empty');
      await page.keyboard.press('Escape');
      assert.equal(await page.isVisible('#sheet'), false, 'there is none of this asset');
    });
  },

  async lost_context_comes_back() {
    makeSheet('--only', '1');
    await withSheet(async (page) => {
      await drawn(page);
      const before = await pixelsOf(page, 1);
      await page.evaluate(async () => {
        const { view } = window;
        const event = (name) => new Promise((done) => { view.canvas.addEventListener(name, () => setTimeout(done), { once: true }); });
        const loses = view.canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
        const lost = event('webglcontextlost');
        loses.loseContext();
        await lost;
        window.sheet.tiles[1].change();
        const restored = event('webglcontextrestored');
        loses.restoreContext();
        await restored;
        window.sheet.turn(window.sheet.tiles[1], 10, 0);
      });
      await drawn(page);
      assert.notEqual(Buffer.compare(Buffer.from(before), Buffer.from(await pixelsOf(page, 1))), 0, 'nothing is drawn any more');
      await page.click('#sheet-face');
      await drawn(page);
      assert.equal(Buffer.compare(Buffer.from(before), Buffer.from(await pixelsOf(page, 1))), 0);
    });
  },
};

const wanted = process.argv[2];
if (!(wanted in cases)) throw new Error(`no case ${wanted}; there are ${Object.keys(cases).join(', ')}`);
mkdirSync(WORK, { recursive: true });
await cases[wanted]();
