// The page of `coif report` in a browser: node report_test.mjs CASE. COIF, ASSET and WORK come in the environment, as for view_test.mjs.

import { strict as assert } from 'node:assert';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { launch, openPage } from './browser.mjs';

const { COIF, ASSET, WORK } = process.env;
const inWork = (name) => join(WORK, name);
const coif = (...words) => execFileSync(COIF, words, { encoding: 'utf8', cwd: WORK });
const QUICK = ['--motion', 'nod', '--fps', '30,60', '--substeps', '1,2', '--seconds', '0.5', '--solver', 'coif,thesis,implicit'];

/** The page from disk; nothing may be complained of, and nothing be asked of any network. */
async function withPage(file, act) {
  const browser = await launch();
  try {
    const { page, complaints } = await openPage(browser, inWork(file), { width: 1000, height: 800 });
    await act(page);
    assert.deepEqual(complaints, [], 'the browser complains');
  } finally {
    await browser.close();
  }
}

/** How many pixels of the first chart are near this colour. */
const inked = (page, [red, green, blue]) => page.evaluate((wanted) => {
  const canvas = document.querySelector('.chart canvas');
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true });
  copy.drawImage(canvas, 0, 0);
  const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let i = 0; i < data.length; i += 4) count += wanted.every((value, k) => Math.abs(data[i + k] - value) < 12) && data[i + 3] > 200;
  return count;
}, [red, green, blue]);
const COIF_BLUE = [0x2f, 0x8f, 0xd8];

/** As the script of the page says it. */
const cellsOf = (page, table) => page.evaluate((at) =>
  [...document.querySelectorAll('table')[at].rows].map((row) => [...row.cells].map((cell) => [cell.innerText, cell.className])), table);

const cases = {
  async charts_are_drawn_and_series_switched() {
    coif('report', ASSET, 'accuracy', ...QUICK, '-o', 'report.html');
    await withPage('report.html', async (page) => {
      assert.ok(await page.locator('.chart canvas').count() >= 4);
      assert.equal(await page.locator('figure .empty').count(), 0);
      const button = page.locator('.legend').first().locator('button', { hasText: 'coif' });
      const before = await inked(page, COIF_BLUE);
      assert.ok(before > 100, `${before} pixels of coif's colour`);
      await button.click();
      assert.equal(await button.getAttribute('aria-pressed'), 'false');
      assert.equal(await inked(page, COIF_BLUE), 0, 'what was switched off is drawn');
      await button.press('Enter');
      assert.ok(await inked(page, COIF_BLUE) > 100, 'what was switched on again is not drawn');
      await button.dblclick();
      const pressed = await page.locator('.legend').first().locator('button[aria-pressed=true]').allTextContents();
      assert.deepEqual(pressed, ['coif'], 'a double click shows it alone');
    });
  },

  async a_dragged_box_zooms_and_goes_back() {
    coif('report', ASSET, 'accuracy', ...QUICK, '-o', 'report.html');
    await withPage('report.html', async (page) => {
      const canvas = page.locator('.chart canvas').first(), reset = page.locator('.reset').first();
      await canvas.scrollIntoViewIfNeeded();
      const shot = async () => (await canvas.screenshot()).toString('base64');
      await page.mouse.move(5, 5);
      const whole = await shot(), { x, y } = await canvas.boundingBox();
      assert.equal(await reset.isVisible(), false);
      await page.mouse.move(x + 150, y + 60);
      await page.mouse.down();
      await page.mouse.move(x + 400, y + 250, { steps: 5 });
      await page.mouse.up();
      await page.mouse.move(5, 5);
      assert.equal(await reset.isVisible(), true);
      assert.notEqual(await shot(), whole);
      await reset.click();
      await page.mouse.move(5, 5);
      assert.equal(await reset.isVisible(), false);
      assert.equal(await shot(), whole);
    });
  },

  async tables_say_what_the_terminal_says() {
    const printed = coif('report', ASSET, 'stability', '--solver', 'coif,thesis', '-o', 'report.html').split('\n');
    await withPage('report.html', async (page) => {
      const totals = await cellsOf(page, 0);
      assert.equal(totals.length, 3);
      for (const row of totals.slice(1)) {
        const words = row.map(([text]) => text.replace(/ %$/, ''));
        const line = printed.find((text) => text.trim().split(/ +/)[0] === words[0]);
        assert.deepEqual(line.trim().replaceAll(' %', '').split(/ +/), words);
      }
      assert.equal(totals[1][1][1], 'number good', 'ok is coloured');
      const outcomes = await cellsOf(page, 1);
      assert.deepEqual(outcomes.slice(1).map((row) => row[0]), [['ok', 'good'], ['rejected', 'neutral'], ['restless', 'warning'], ['diverged', 'warning'], ['nan', 'bad']]);
      const [titles, first] = await cellsOf(page, 2);
      assert.deepEqual(titles.map(([text]) => text), ['case', 'what happens', 'coif', 'thesis']);
      assert.match(first[2][0], /^ok\nstretch [^ ]+ %/);
    });
  },

  async every_report_is_whole() {
    const reports = { cost: ['--heads', '1,10', '--time', '0.3', '--size', '32x24', '--table1'], order: ['--size', '32x32', '--views', '3', '--orbit', '2'], shadows: ['--map-size', '64', '--spacing', '0.02'] };
    for (const [subject, words] of Object.entries(reports)) {
      coif('report', ASSET, subject, ...words, '-o', `${subject}.html`);
      await withPage(`${subject}.html`, async (page) => {
        const text = await page.innerText('body');
        assert.equal(/\{[a-z_.|]+\}|undefined|NaN|\[object/.exec(text), null, subject);
        assert.ok(await page.locator('table').count() > 2 && await page.locator('.chart canvas').count() >= 2, subject);
      });
    }
  },

  async it_is_light_on_paper() {
    coif('report', ASSET, 'accuracy', ...QUICK, '-o', 'report.html');
    await withPage('report.html', async (page) => {
      await page.emulateMedia({ colorScheme: 'dark' });
      const axis = () => page.evaluate(() => Chart.getChart(document.querySelector('.chart canvas')).options.scales.x.ticks.color);
      const becomes = async (color) => {  // Waiting by a function would need what the page's policy forbids.
        for (let i = 0; i < 200 && await axis() !== color; ++i) await new Promise((done) => { setTimeout(done, 50); });
        assert.equal(await axis(), color);
      };
      await becomes('#e3e6ea');
      await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
      await becomes('#000000');
      await page.evaluate(() => dispatchEvent(new Event('afterprint')));
      await becomes('#e3e6ea');
    });
  },

  async hostile_names_stay_text() {
    const hostile = '<img src=x onerror=alert(1)>.coif';
    mkdirSync(WORK, { recursive: true });
    execFileSync('cp', [ASSET, inWork(hostile)]);
    coif('report', hostile, 'stability', '--solver', 'coif', '-o', 'report.html');
    assert.ok(readFileSync(inWork('report.html'), 'utf8').includes('u003cimg'));
    await withPage('report.html', async (page) => {
      assert.ok((await page.innerText('h1')).includes(hostile));
      assert.equal(await page.locator('img').count(), 0);
    });
  },
};

const wanted = process.argv[2];
if (!(wanted in cases)) throw new Error(`no case ${wanted}; there are ${Object.keys(cases).join(', ')}`);
mkdirSync(WORK, { recursive: true });
await cases[wanted]();
