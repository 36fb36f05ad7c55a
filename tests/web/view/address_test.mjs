// Settings in the address of a page of `coif view`: node address_test.mjs CASE. COIF, ASSET, PAGE and WORK come in the environment, as
// for view_test.mjs.

import { strict as assert } from 'node:assert';
import { execFileSync } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { launch, openPage } from './browser.mjs';

const { COIF, ASSET, PAGE, WORK } = process.env;
const inWork = (name) => join(WORK, name);
const coif = (...words) => execFileSync(COIF, words, { encoding: 'utf8', cwd: WORK });

/** A page with this behind its address's '#'; nothing may be complained of. */
async function withAddress(hash, act) {
  const browser = await launch();
  try {
    const { page, complaints } = await openPage(browser, inWork('page.html'));
    page.on('dialog', (dialog) => { complaints.push(`a dialog: ${dialog.message()}`); dialog.dismiss(); });
    await page.goto('about:blank');
    await page.goto(`${pathToFileURL(inWork('page.html')).href}${hash}`);
    await page.evaluate(async () => { window.view = await window.coif; });
    await act(page);
    assert.deepEqual(complaints, [], 'the browser complains');
    assert.equal(await page.textContent('#problem'), '');
  } finally {
    await browser.close();
  }
}

const get = (page, name) => page.evaluate((of) => window.view.get(of), name);
const word = (page, name) => page.evaluate((of) => window.view.word(of), name);
const settings = (page) => page.evaluate(() => Array.from(window.view.wasm.settings()));
const note = (page) => page.textContent('#address-note');

const cases = {
  async known_settings_are_set_and_others_are_named() {
    await withAddress('#motion=turn&rate=30&beside=thesis&base_color=1,0.5,0.25&yaw=-90&wheels=4', async (page) => {
      assert.deepEqual([await word(page, 'motion'), await word(page, 'beside'), await get(page, 'rate'), await get(page, 'yaw')], ['turn', 'thesis', 30, -90]);
      assert.equal(await get(page, 'plays'), 1, 'a motion that is asked for plays');
      assert.equal(await page.inputValue('#control-rate'), '30');
      assert.match(await page.textContent('#compared'), /Left: coif. Right: thesis/);
      assert.match(await note(page), /wheels=4[.]$/);
      assert.equal((await note(page)).includes('motion'), false);
      const at = await page.evaluate(() => window.view.control('base_color').at);
      assert.deepEqual((await settings(page)).slice(at, at + 3), [1, 0.5, 0.25]);
      await page.evaluate(() => { location.hash = '#motion=nod&plays=0'; });
      await page.waitForFunction(() => window.view.word('motion') === 'nod');
      assert.equal(await get(page, 'plays'), 0);
      assert.equal(await note(page), '');
    });
  },

  async hostile_addresses_change_nothing() {
    let own;
    await withAddress('', async (page) => { own = await settings(page); assert.equal(await note(page), ''); });
    const hostile = [
      'yaw=<img src=x onerror=alert(1)>', 'yaw=NaN', 'yaw=Infinity', 'yaw=1e999', 'yaw=0x10', 'yaw=', 'yaw', 'yaw=181', 'pitch=-90', 'rate=1', 'lod=-1', 'lod=99', 'samples=1000000',
      'motion=<script>alert(1)</script>', 'motion=0', 'motion=', 'solver=toString', 'beside=constructor', 'base_color=1,1', 'base_color=1,1,1,1', 'base_color=1,1,1e9', 'yaw=1,2',
      '__proto__=1', 'constructor=1', 'toString=1', 'prototype[x]=1', '<img src=x onerror=alert(1)>=1', '%', '%E0%A4%A', '=', '&&&', '#', 'YAW=3', `${'a'.repeat(100000)}=1`,
    ];
    await withAddress(`#${hostile.join('&')}`, async (page) => {
      for (const text of [hostile.join('&'), ...hostile]) {
        assert.deepEqual(await settings(page), own, text.slice(0, 80));
        assert.equal(await page.$('#title *:not(b):not(span)'), null, 'markup came in');
        assert.equal(await page.$('#address-note *'), null);
        assert.ok((await note(page)).length < 400, 'the note is as long as the address');
        await page.evaluate((hash) => {
          history.replaceState(null, '', `#${hash}`);
          dispatchEvent(new HashChangeEvent('hashchange'));
        }, text);
        if (text.includes('=1')) assert.match(await note(page), /^Left out/);
      }
    });
  },

  async reports_open_it_with_what_they_measured() {
    coif('report', ASSET, 'accuracy', '--motion', 'turn', '--fps', '30,60', '--substeps', '1', '--seconds', '0.5', '--solver', 'coif,thesis', '-o', 'report.html',
      '--view', 'a page #1.html', '--page', PAGE);
    const browser = await launch();
    try {
      const { page, complaints } = await openPage(browser, inWork('report.html'));
      const follow = async (text) => {
        await page.click(`a:text-is("${text}")`);
        await page.waitForURL(/#motion=turn/);
        await page.evaluate(async () => { window.view = await window.coif; });
      };
      await follow('a page #1.html');
      assert.deepEqual([await word(page, 'motion'), await word(page, 'beside'), await get(page, 'rate')], ['turn', 'thesis', 60]);
      assert.equal(await note(page), '');
      await page.goBack();
      await follow('30');
      assert.equal(await get(page, 'rate'), 30);
      assert.deepEqual(complaints, []);
    } finally {
      await browser.close();
    }
  },
};

const wanted = process.argv[2];
if (!(wanted in cases)) throw new Error(`no case ${wanted}; there are ${Object.keys(cases).join(', ')}`);
mkdirSync(WORK, { recursive: true });
coif('view', ASSET, '-o', 'page.html', '--page', PAGE);
await cases[wanted]();
