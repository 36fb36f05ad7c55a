// Chromium without a window, with a software renderer, and a page of `coif view` in it.

import { strict as assert } from 'node:assert';
import { existsSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const PROGRAM = process.env.CHROMIUM ?? ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);
const ARGUMENTS = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox', '--js-flags=--expose-gc',
                   '--enable-precise-memory-info'];

export async function launch(more = []) {
  if (!PROGRAM) throw new Error('no Chromium: tools/install_packages.sh web installs it');
  return chromium.launch({ executablePath: PROGRAM, args: [...ARGUMENTS, ...more] });
}

/** The page from disk, after `before` ran in it, and whatever the browser complained of. Nothing may be asked of any network. */
export async function openPage(browser, file, viewport = { width: 640, height: 420 }, before = undefined) {
  const context = await browser.newContext({ viewport, offline: true });
  const page = await context.newPage();
  if (before) await page.addInitScript(before);
  const complaints = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push(`asks for ${request.url()}`);
  });
  await page.goto(pathToFileURL(file).href);
  await page.evaluate(async () => { await window.coif; });
  return { page, complaints };
}

/** Runs `act` on a page of `coif view`; neither the browser nor the page may complain. */
export async function onPage(file, act, viewport = undefined) {
  const browser = await launch();
  try {
    const { page, complaints } = await openPage(browser, file, viewport);
    await act(page);
    assert.deepEqual(complaints, [], 'the browser complains');
    assert.equal(await page.textContent('#problem'), '');
  } finally {
    await browser.close();
  }
}

/** Pixels of a picture with these settings ({name: value or word}), at the camera of `coif render`. */
export async function take(page, size, settings = {}) {
  const text = await page.evaluate(async ([{ width, height }, changes]) => {
    const view = await window.coif;
    for (const [name, value] of Object.entries({ zoom: 1, ...changes })) view.set(name, value);
    const pixels = view.take(width, height);
    let latin = '';
    for (let i = 0; i < pixels.length; i += 8192) latin += String.fromCharCode(...pixels.subarray(i, i + 8192));
    return btoa(latin);
  }, [size, settings]);
  return new Uint8Array(Buffer.from(text, 'base64'));
}
