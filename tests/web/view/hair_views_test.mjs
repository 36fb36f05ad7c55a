// What the page of `coif view` shows beside the hair itself, and what it says of it: node hair_views_test.mjs CASE. The environment is
// that of view_test.mjs.

import { strict as assert } from 'node:assert';
import { execFileSync, spawn } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { launch, onPage, take } from './browser.mjs';
import { psnr, readPng } from './png.mjs';

const { COIF, ASSET, SOURCE, PAGE, WORK } = process.env;
const SIZE = { width: 480, height: 360 };
const PIXELS = SIZE.width * SIZE.height;

const inWork = (name) => join(WORK, name);
// What the page shows, too.
const PLAIN = ['--lights', 'plain', '--backdrop', 'light', '--head', 'ball', '--samples', '4'];
const coif = (...words) => execFileSync(COIF, words, { encoding: 'utf8', cwd: WORK });

function rendered(view, ...options) {
  coif('render', ASSET, '-o', 'reference.png', '--size', `${SIZE.width}x${SIZE.height}`, '--view', view, ...PLAIN, ...options);
  return readPng(inWork('reference.png')).rgba;
}

/** Runs `act` on a page that shows the sample, made with these options; the browser must not complain. */
async function withPage(act, ...options) {
  coif('view', ASSET, '-o', 'page.html', '--page', PAGE, ...options);
  await onPage(inWork('page.html'), act);
}

const colour = (pixels, i) => (pixels[4 * i] << 16) | (pixels[4 * i + 1] << 8) | pixels[4 * i + 2];
const channels = (number) => [number >> 16, (number >> 8) & 255, number & 255];
const isNear = (a, b, most = 1) => channels(a).every((v, k) => Math.abs(v - channels(b)[k]) <= most);
const linear = (v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4);

/** { colour: pixels of exactly it }. */
function histogram(pixels) {
  const counts = new Map();
  for (let i = 0; i < PIXELS; ++i) counts.set(colour(pixels, i), (counts.get(colour(pixels, i)) ?? 0) + 1);
  return counts;
}

/** The page's legend below the picture: { hidden, title, texts, colours }; colours as numbers. */
async function legend(page) {
  await page.waitForFunction(async () => { const view = await window.coif; view.showNumbers(); return true; });
  return page.$eval('#legend', (box) => ({
    hidden: box.hidden, title: box.querySelector('b').textContent,
    texts: [...box.querySelectorAll('li')].map((line) => line.textContent),
    colours: [...box.querySelectorAll('i')].map((swatch) => getComputedStyle(swatch).backgroundColor.match(/\d+/g).map(Number)),
  })).then((found) => ({ ...found, colours: found.colours.map(([r, g, b]) => (r << 16) | (g << 8) | b) }));
}

/** Index of each pixel's colour among `colours`; -1: none of them, as where a pixel's samples differ. */
const classes = (pixels, colours) => Array.from({ length: PIXELS }, (_, i) => colours.findIndex((c) => isNear(c, colour(pixels, i))));

/** A head at a grown-up's height that turns a quarter about Y and slides, within a second. */
function writeClip(name) {
  const floats = Float32Array.of(0, 0.5, 1, 0, 0, 0, 1, 0, Math.SQRT1_2, 0, Math.SQRT1_2, 0, 0, 0, 1, 0, 1.6, 0, 0, 1.8, 0.1, 0, 1.6, 0);
  writeFileSync(inWork(name), JSON.stringify({
    asset: { version: '2.0' }, nodes: [{ name: 'rig:head' }],
    animations: [{ samplers: [{ input: 0, output: 1 }, { input: 0, output: 2 }],
                   channels: [{ sampler: 0, target: { node: 0, path: 'rotation' } }, { sampler: 1, target: { node: 0, path: 'translation' } }] }],
    bufferViews: [[0, 12], [12, 48], [60, 36]].map(([byteOffset, byteLength]) => ({ buffer: 0, byteOffset, byteLength })),
    accessors: ['SCALAR', 'VEC4', 'VEC3'].map((type, bufferView) => ({ bufferView, type, componentType: 5126, count: 3 })),
    buffers: [{ byteLength: floats.byteLength, uri: `data:application/octet-stream;base64,${Buffer.from(floats.buffer).toString('base64')}` }],
  }));
}

const cases = {
  async patches_have_the_colours_of_the_command_line() {
    await withPage(async (page) => {
      const hair = await take(page, SIZE);
      assert.equal((await legend(page)).hidden, true);
      const seen = [];
      for (const yaw of [30, -40]) {
        const patches = await take(page, SIZE, { view: 'patches', yaw });
        assert.ok(psnr(hair, patches) < 25, 'they look like hair');
        const said = await legend(page);
        assert.equal(said.hidden, false);
        const count = Number(said.title.match(/^(\d+) patches/)[1]);
        const reference = rendered(`${yaw},5`, '--component', 'patches', '--shadows', 'none');
        // Flat colours that many pixels have: those of patches, of which there are no more.
        const flat = [...histogram(patches)].filter(([, pixels]) => pixels >= 30).map(([value]) => value);
        const vivid = new Set(flat.filter((value) => Math.max(...channels(value)) - Math.min(...channels(value)) > 60));
        console.log(`yaw ${yaw}: ${vivid.size} of ${count} patches are seen`);
        assert.ok(vivid.size >= count / 5 && vivid.size <= count, `${vivid.size} colours of ${count} patches`);
        let compared = 0, same = 0;
        for (let i = 0; i < PIXELS; ++i) {
          if (!vivid.has(colour(patches, i))) continue;
          const [a, b] = [channels(colour(patches, i)), channels(colour(reference, i))].map((rgb) => rgb.map(linear));
          const [sumA, sumB] = [a, b].map((rgb) => rgb[0] + rgb[1] + rgb[2]);
          ++compared;
          if (a.every((v, k) => Math.abs(v / sumA - b[k] / sumB) < 0.06)) ++same;
        }
        console.log(`${same} of ${compared} pixels have the hue of coif render`);
        assert.ok(compared > 10_000 && same > 0.95 * compared);
        seen.push(vivid);
      }
      const both = [...seen[0]].filter((value) => seen[1].has(value));
      assert.ok(both.length >= 5, 'no patch keeps its colour when the camera turns');
    });
  },

  async overdraw_counts_layers() {
    await withPage(async (page) => {
      const hair = await take(page, SIZE);
      const overdraw = await take(page, SIZE, { view: 'overdraw' });
      const { title, texts, colours, hidden } = await legend(page);
      assert.equal(hidden, false);
      assert.match(title, /[Ll]ayers/);
      assert.deepEqual(texts, ['1', '2', '3 to 4', '5 to 8', '9 to 16', '17 to 32', '33 and more']);
      const layers = classes(overdraw, colours);
      assert.ok(layers.filter((c) => c >= 1).length > 3000, 'nothing has two layers');
      assert.ok(layers.filter((c) => c === 0).length > 100, 'nothing has one layer');
      // Where there is no hair the picture is as it was: the backdrop along its borders.
      for (let y = 0; y < SIZE.height; ++y) {
        for (const x of [0, 1, SIZE.width - 1]) {
          const i = y * SIZE.width + x;
          assert.equal(colour(overdraw, i), colour(hair, i), `${x}, ${y} has hair`);
        }
      }
      // Less hair is not more layers; a second head has as many.
      const less = classes(await take(page, SIZE, { view: 'overdraw', discard_threshold: 0.8 }), colours);
      const both = layers.map((c, i) => [c, less[i]]).filter(([a, b]) => a >= 0 && b >= 0);
      assert.ok(both.every(([a, b]) => b <= a), 'layers come from leaving texels out');
      assert.ok(both.some(([a, b]) => b < a), 'what is left out counts');
      const otherWay = await take(page, SIZE, { view: 'overdraw', discard_threshold: 0.8, transparency: 'opaque' });
      assert.deepEqual(classes(otherWay, colours), less, 'it depends on how edges are drawn');
    });
  },

  async draw_order_goes_from_first_to_last() {
    await withPage(async (page) => {
      const fromLeft = await take(page, SIZE, { view: 'draw order', yaw: 60 });
      const { title, texts, colours, hidden } = await legend(page);
      assert.equal(hidden, false);
      assert.match(title, /drawn/);
      assert.deepEqual([texts[0], texts.at(-1)], ['first', 'last']);
      // Shares of the order, by the nearest colour of the ramp that the legend has five of.
      const ramp = [];
      for (let piece = 0; piece < 4; ++piece) {
        const [a, b] = [channels(colours[piece]), channels(colours[piece + 1])];
        for (let t = 0; t < 100; ++t) ramp.push(a.map((v, k) => v + (t / 100) * (b[k] - v)));
      }
      const share = (rgb) => {
        const off = ramp.map((c) => c.reduce((sum, v, k) => sum + (v - rgb[k]) ** 2, 0));
        const best = off.indexOf(Math.min(...off));
        return off[best] < 12 ? best / (ramp.length - 1) : undefined;
      };
      const shares = (pixels) => [...histogram(pixels)].map(([value, count]) => [share(channels(value)), count]).filter(([s]) => s !== undefined);
      const found = shares(fromLeft);
      const pixels = found.reduce((sum, [, count]) => sum + count, 0);
      const mean = found.reduce((sum, [s, count]) => sum + s * count, 0) / pixels;
      console.log(`${pixels} pixels of ${found.length} places, ${mean.toFixed(2)} of the order in the mean`);
      assert.ok(pixels > 10_000 && found.length > 50);
      assert.ok(mean > 0.55, 'what is in front is drawn later than the mean');
      assert.ok(found.some(([s]) => s < 0.4) && found.some(([s]) => s > 0.95));
      const patches = await take(page, SIZE, { view: 'patches', yaw: 60 });
      assert.ok(psnr(patches, fromLeft) < 25);
    });
  },

  async views_follow_motion_level_and_memory() {
    await withPage(async (page) => {
      for (const view of ['patches', 'overdraw', 'draw order']) {
        const still = await take(page, SIZE, { view, motion: 'turn', lod: 0 });
        const moved = await page.evaluate(async (size) => {
          const view = await window.coif;
          view.set('plays', 1);
          const run = (frames) => { for (let i = 0; i < frames; ++i) view.draw(size.width, size.height, 1 / 60); };
          run(8);
          let made = 0;
          const real = {};
          for (const name of ['createBuffer', 'createTexture', 'createProgram', 'createFramebuffer', 'bufferData']) {
            real[name] = WebGL2RenderingContext.prototype[name];
            WebGL2RenderingContext.prototype[name] = function (...words) { ++made; return real[name].apply(this, words); };
          }
          run(5);
          Object.assign(WebGL2RenderingContext.prototype, real);
          view.set('plays', 0);
          return { made, triangles: view.wasm.numbers().triangles, levels: view.wasm.numbers().levels };
        }, SIZE);
        assert.equal(moved.made, 0, `${view}: objects of WebGL are made in frames`);
        const after = await take(page, SIZE);
        assert.ok(psnr(still, after) < 30, `${view}: nothing moves`);
        const coarse = await take(page, SIZE, { lod: moved.levels - 1 });
        if (moved.levels > 1) assert.ok(psnr(coarse, after) < 40, `${view}: the level changes nothing`);
        await page.evaluate(async () => (await window.coif).restart());
      }
    });
  },

  async views_outlive_a_lost_context() {
    await withPage(async (page) => {
      for (const view of ['overdraw', 'draw order']) {
        const before = await take(page, SIZE, { view });
        await page.evaluate(async () => {
          const view = await window.coif;
          const event = (name) => new Promise((done) => view.canvas.addEventListener(name, () => setTimeout(done), { once: true }));
          const loses = view.canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
          const [lost, restored] = [event('webglcontextlost'), event('webglcontextrestored')];
          loses.loseContext();
          await lost;
          loses.restoreContext();
          await restored;
        });
        assert.equal(psnr(before, await take(page, SIZE)), Infinity, view);
      }
    });
  },

  async the_error_is_what_was_measured() {
    const known = JSON.parse(coif('info', ASSET, '--format', 'json')).quality;
    assert.ok(known.length > 0);
    await withPage(async (page) => {
      const said = async (settings) => {
        await take(page, { width: 64, height: 48 }, settings);
        return page.evaluate(async () => {
          const view = await window.coif;
          view.showNumbers();
          const cell = [...document.querySelectorAll('#numbers span')].find((span) => span.textContent.endsWith('tip error'));
          return { text: cell.querySelector('b').textContent, title: cell.title, substeps: view.wasm.numbers().substeps };
        });
      };
      const percent = (value) => `${Number(value.toPrecision(2))} %`;
      const rates = [...new Set(known.map((row) => row.frame_rate))].filter((rate) => rate >= 15 && rate <= 240);
      for (const rate of rates) {
        const { text, title, substeps } = await said({ rate });
        const row = known.find((r) => r.frame_rate === rate && r.substeps === substeps);
        assert.ok(row, `nobody measured ${substeps} sub-steps at ${rate} Hz`);
        assert.equal(text, `${percent(row.rms_error_pct)}, at most ${percent(row.max_error_pct)}`, `${rate} Hz`);
        assert.match(title, /this rate/);
      }
      console.log(rates.join(', '), (await said({ rate: 60 })).text, (await said({ rate: 100 })).text);
      const between = await said({ rate: Math.max(...rates) - 1 });
      assert.match(between.text, /^\u2264 [\d.]+ %, at most [\d.]+ %$/);
      assert.match(between.title, /slower rate/);
      const friction = await page.evaluate(async () => (await window.coif).get('friction'));
      for (const [settings, why] of [[{ solver: 'thesis' }, /solver coif/], [{ solver: 'coif', friction: friction + 1 }, /own numbers/], [{ friction, rate: 15 }, /finer/]]) {
        const unknown = await said(settings);
        assert.equal(unknown.text, '-');
        assert.match(unknown.title, why);
      }
    });
  },

  async clips_move_the_head() {
    writeClip('shake.gltf');
    const begin = (page) => page.evaluate(async () => {
      const view = await window.coif;
      const began = { motion: view.word('motion'), plays: view.get('plays') };
      cancelAnimationFrame(view.waiting);
      view.waiting = -1;  // from here on time is the test's
      view.restart();
      return began;
    });
    const run = (page, frames) => page.evaluate(async (count) => {
      const view = await window.coif;
      for (let i = 0; i < count; ++i) view.draw(64, 48, 1 / 60 + 1e-9);
      return view.wasm.numbers();
    }, frames);
    coif('simulate', ASSET, '-o', 'shake.csv', '--motion', 'shake.gltf', '--fps', '60', '--seconds', '1');
    const rows = readFileSync(inWork('shake.csv'), 'utf8').trim().split('\n').slice(1).map((line) => line.split(','));
    /** How far the bones are from where the program has them, were they in the page's head as they are in the program's. */
    const off = (n, frame) => {
      const [x, y, z, w] = [n.headQx, n.headQy, n.headQz, n.headQw];
      const turned = ([a, b, c]) => {  // q v q*
        const [s, t, u] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
        return [a + w * s + y * u - z * t, b + w * t + z * s - x * u, c + w * u + x * t - y * s];
      };
      const bones = rows.filter((row) => Number(row[0]) === frame).map((row) => row.slice(-6).map(Number));
      assert.ok(bones.length > 3, `no frame ${frame}`);
      return Math.max(...bones.map((bone) => {
        const world = turned(bone.slice(0, 3)).map((v, k) => v + [n.headX, n.headY, n.headZ][k]);
        return Math.hypot(...world.map((v, k) => v - bone[3 + k]));
      }));
    };
    await withPage(async (page) => {
      assert.deepEqual(await begin(page), { motion: 'clip', plays: 1 });
      assert.match(await page.textContent('#hint'), /shake[.]gltf:rig:head/);
      const before = await take(page, SIZE, { shadows: 'none' });
      for (const frame of [6, 18, 30, 47]) {
        const numbers = await run(page, frame - Math.round(60 * (await run(page, 0)).time));
        console.log(`${numbers.time.toFixed(3)} s: ${(1000 * off(numbers, frame)).toFixed(4)} mm`);
        assert.ok(off(numbers, frame) < 1e-5 && off(numbers, frame - 1) > 1e-3, `${frame}: the head is elsewhere`);
      }
      assert.ok(psnr(before, await take(page, SIZE)) < 30, 'nobody sees it');
      const again = await run(page, 60);
      assert.ok(Math.abs(again.time - 47 / 60) < 1e-3 && off(again, 47) < 1e-5, 'the clip does not begin again');
      // From the origin to where the clip begins, and back, heads are put: no hair is thrown.
      const restart = (settings) => page.evaluate(async (all) => {
        const view = await window.coif;
        for (const [name, value] of Object.entries(all)) view.set(name, value);
        view.restart();
      }, settings);
      await restart({ motion: 'still', plays: 0 });
      const still = await take(page, SIZE);
      await take(page, SIZE, { motion: 'clip', plays: 1 });
      await run(page, 1);
      const begun = psnr(still, await take(page, SIZE));
      await restart({ motion: 'clip', plays: 0 });
      await take(page, SIZE, { motion: 'still' });
      await run(page, 1);
      const gone = psnr(still, await take(page, SIZE));
      console.log(`put: ${begun.toFixed(1)} and ${gone.toFixed(1)} dB`);
      assert.ok(begun > 30 && gone > 30, 'hair is thrown by the way to the clip');
    }, '--motion', 'shake.gltf:rig:head');
    await withPage(async (page) => {
      assert.deepEqual(await begin(page), { motion: 'nod', plays: 1 });
      assert.ok(!(await page.$eval('#control-motion', (list) => list.textContent)).includes('clip'));
    }, '--motion', 'nod');
  },

  async clips_move_heads_whose_hair_is_cooked_meanwhile() {
    writeClip('shake.gltf');
    copyFileSync(SOURCE, inWork('bob.glb'));
    const child = spawn(COIF, ['view', 'bob.glb', '--motion', 'shake.gltf', '--page', PAGE, '--format', 'json'],
                        { cwd: WORK, stdio: ['ignore', 'pipe', 'inherit'] });
    const browser = await launch();
    try {
      const address = await new Promise((found, failed) => {
        let text = '';
        child.stdout.on('data', (more) => { text += more; if (text.endsWith('}\n')) found(JSON.parse(text).address); });
        child.on('exit', (code) => failed(new Error(`it ended with ${code}`)));
      });
      const page = await browser.newPage();
      await page.goto(address);
      const shown = await page.evaluate(async () => {
        const view = await window.coif;
        for (let i = 0; i < 3; ++i) view.draw(64, 48, 1 / 60);
        view.showNumbers();
        return { motion: view.word('motion'), turned: Math.abs(view.wasm.numbers().headQy),
                 error: document.getElementById('numbers').textContent };
      });
      assert.equal(shown.motion, 'clip');
      assert.ok(shown.turned > 1e-4, 'the head stands still');
      assert.match(shown.error, /- tip error/, 'drafts are not measured');
    } finally {
      await browser.close();
      child.kill('SIGTERM');
    }
  },
};

const wanted = process.argv[2];
if (!(wanted in cases)) throw new Error(`no case ${wanted}; there are ${Object.keys(cases).join(', ')}`);
mkdirSync(WORK, { recursive: true });
await cases[wanted]();
