// A running `coif view` of a source and a page of it, for tests. COIF, SOURCE, PAGE and WORK come in the environment, as for view_test.mjs.

import { strict as assert } from 'node:assert';
import { spawn } from 'node:child_process';
import { copyFileSync, utimesSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { launch } from './browser.mjs';

const { COIF, SOURCE, PAGE, WORK } = process.env;
const PATIENCE = 120_000;  // milliseconds
export const inWork = (name) => join(WORK, name);

/** A running program; `address` once it is printed, `said` to the standard error, `ended` with its exit code. */
function start(...words) {
  const child = spawn(COIF, ['view', ...words, '--page', PAGE, '--format', 'json'], { cwd: WORK, stdio: ['ignore', 'pipe', 'pipe'] });
  const view = { child, said: '' };
  view.ended = new Promise((done) => { child.on('exit', done); });
  child.stderr.on('data', (text) => { view.said += text; });
  view.address = new Promise((found, failed) => {
    let text = '';
    child.stdout.on('data', (more) => { text += more; if (text.endsWith('}\n')) found(JSON.parse(text).address); });
    child.on('exit', (code) => failed(new Error(`it ended with ${code}: ${view.said}`)));
  });
  return view;
}

/** Runs `act` on the live view of bob's source and recipe; the browser must neither complain nor ask another server. */
export async function withView(act) {
  copyFileSync(SOURCE, inWork('bob.glb'));
  copyFileSync(SOURCE.replace(/\.glb$/, '.recipe.json'), inWork('bob.recipe.json'));
  const view = start('bob.glb');
  const browser = await launch();
  try {
    const page = await (await browser.newContext({ viewport: { width: 640, height: 420 } })).newPage();
    page.setDefaultTimeout(PATIENCE);
    const complaints = [];
    page.on('console', (message) => { if (['error', 'warning'].includes(message.type())) complaints.push(message.text()); });
    page.on('pageerror', (error) => complaints.push(error.message));
    const address = await view.address;
    page.on('request', (request) => {
      if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(address)) complaints.push(`asks for ${request.url()}`);
    });
    await page.goto(address);
    await page.evaluate(async () => { window.view = await window.coif; });
    await act(page, view, complaints);
    assert.deepEqual(complaints, [], 'the browser complains');
    assert.equal(await page.textContent('#problem'), '');
  } finally {
    await browser.close();
    view.child.kill('SIGTERM');
    assert.equal(await view.ended, 0, view.said);
  }
}

export const revision = (page) => page.evaluate(() => window.view.live.revision);
/** The page's policy forbids what playwright's own waiting does there. */
export async function until(page, holds, value) {
  for (const end = Date.now() + PATIENCE; Date.now() < end; await new Promise((done) => { setTimeout(done, 50); })) {
    if (await page.evaluate(holds, value)) return;
  }
  throw new Error(`never came: ${holds}, ${await page.textContent('#cooked')}`);
}

export const cooked = (page, number) => until(page, (wanted) => window.view.live.revision >= wanted && !window.view.live.state.cooking, number);
export const setUp = (page, name, value) => page.$eval(`#control-${name}`, (input, wanted) => {
  input.closest('details').open = true;
  input.value = wanted;
  input.dispatchEvent(new Event('input', { bubbles: true }));
  input.dispatchEvent(new Event('change', { bubbles: true }));
}, String(value));
export const get = (page, name) => page.evaluate((of) => window.view.get(of), name);

/** A file that is written, with a time that differs. */
export function write(name, text) {
  writeFileSync(inWork(name), text);
  const later = new Date(Date.now() + 1000);
  utimesSync(inWork(name), later, later);
}
