// A body under the hair on the page of `coif view`: node body_test.mjs CASE. COIF, ASSET, PAGE and WORK come in the environment, as for
// view_test.mjs, and BODY, a model with textures.

import { strict as assert } from 'node:assert';
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { onPage, take } from './browser.mjs';
import { psnr, readPng } from './png.mjs';

const { COIF, ASSET, BODY, PAGE, WORK } = process.env;
const SIZE = { width: 360, height: 300 };
const SETTINGS = { shadows: 'plain', transparency: 'opaque', samples: 1 };

const inWork = (name) => join(WORK, name);
const coif = (...words) => execFileSync(COIF, words, { encoding: 'utf8', cwd: WORK });

/** What `coif render` draws in the light of the page. */
function rendered(...options) {
  coif('render', ASSET, '-o', 'reference.png', '--size', `${SIZE.width}x${SIZE.height}`, '--view', '30,5', '--lights', 'plain', '--backdrop', 'light',
    '--shadows', SETTINGS.shadows, '--transparency', SETTINGS.transparency, '--samples', '4', ...options);
  return readPng(inWork('reference.png')).rgba;
}

/** Runs `act` on a page of the sample on the body; the browser must not complain. */
async function withBody(act) {
  coif('view', ASSET, '-o', 'page.html', '--page', PAGE, '--body', BODY);
  await onPage(inWork('page.html'), act);
}

const cases = {
  async is_what_render_draws() {
    await withBody(async (page) => {
      const seen = await take(page, SIZE, SETTINGS), db = psnr(seen, rendered('--body', BODY));
      console.log(`with the body: ${db.toFixed(1)} dB; with the collider: ${psnr(seen, rendered('--head', 'ball')).toFixed(1)} dB`);
      assert.ok(db > 33, `${db} dB`);  // fewer triangles and smaller images
      assert.ok(psnr(seen, rendered('--head', 'ball')) < db - 8, 'the body is not seen');
    });
    coif('view', ASSET, '-o', 'without.html', '--page', PAGE);
    const more = statSync(inWork('page.html')).size - statSync(inWork('without.html')).size;
    assert.ok(more < 450_000, `${more} bytes of a body`);
  },

  async turns_with_the_head() {
    await withBody(async (page) => {
      await page.evaluate(async (settings) => {
        const view = await window.coif;
        for (const [name, value] of Object.entries({ ...settings, motion: 'turn', plays: 1 })) view.set(name, value);
        for (let i = 0; i < 8; ++i) view.draw(48, 40, 1 / 20);
        view.set('plays', 0);
      }, SETTINGS);
      const turned = await take(page, SIZE, SETTINGS);
      const db = psnr(turned, rendered('--body', BODY));
      console.log(`turned, beside the picture at rest: ${db.toFixed(1)} dB`);
      assert.ok(db < 22, `the body turns with the head: ${db} dB`);
    });
  },

  async leaves_with_another_hair() {
    copyFileSync(ASSET, inWork('other.coif'));
    await withBody(async (page) => {
      const before = await take(page, SIZE, SETTINGS);
      await page.setInputFiles('#file', inWork('other.coif'));
      await page.waitForFunction(() => document.getElementById('name').textContent === 'other.coif');
      const after = await take(page, SIZE, SETTINGS);
      const plain = rendered('--head', 'ball');
      assert.ok(psnr(after, plain) > psnr(before, plain) + 8, 'the body stays under the hair of another file');
    });
  },
};

const wanted = process.argv[2];
if (!(wanted in cases)) throw new Error(`no case ${wanted}; there are ${Object.keys(cases).join(', ')}`);
mkdirSync(WORK, { recursive: true });
await cases[wanted]();
