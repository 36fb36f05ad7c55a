// Two hundred heads in Chromium beside two hundred natively, in turns, each in one thread: node crowd_test.mjs.
// PACKAGE (the npm package), ASSET and TIME_CROWD (the native program) come in the environment.

import { strict as assert } from 'node:assert';
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { launch } from './browser.mjs';

const { PACKAGE, ASSET, TIME_CROWD } = process.env;
const HEADS = 200;
const FRAMES = 150; // of a block
const ROUNDS = 3;
const MOST = 3; // times the native build for vectors as wide as WebAssembly's

/** The native frame's microseconds by instruction set. */
function timeNative() {
  const text = execFileSync(TIME_CROWD, [ASSET, HEADS, FRAMES].map(String), { encoding: 'utf8' });
  return Object.fromEntries(text.trim().split('\n').map((line) => line.split(' ')).map(([name, value]) => [name, Number(value)]));
}

/** The motion `turn` about as the native program has it; what a frame costs does not hang on its last bits. */
const poses = Array.from({ length: 1050 }, (_, frame) => {
  const yaw = 0.5 * Math.sin(2 * Math.PI * (frame / 60));
  return [0, 1.6, 0, 0, Math.sin(yaw / 2), 0, Math.cos(yaw / 2)];
});

async function openCrowd(browser) {
  const page = await browser.newPage();
  await page.route('**/*', (route) => {
    const { pathname } = new URL(route.request().url());
    const files = { '/': 'crowd.html', '/asset.coif': ASSET };
    return route.fulfill({ path: pathname.startsWith('/coif/') ? join(PACKAGE, pathname.slice(6)) : files[pathname] });
  });
  await page.goto('http://crowd.test/');
  await page.waitForFunction(() => window.timeCrowd);
  return page;
}

const browser = await launch();
try {
  const page = await openCrowd(browser);
  const native = {};
  let inBrowser = Infinity;
  for (let round = 0; round < ROUNDS; ++round) {
    for (const [name, value] of Object.entries(timeNative())) native[name] = Math.min(native[name] ?? Infinity, value);
    inBrowser = Math.min(inBrowser, await page.evaluate(([heads, frames, path]) => window.timeCrowd(heads, frames, path), [HEADS, FRAMES, poses]));
  }
  console.log(`${HEADS} heads, microseconds of a frame: in the browser ${inBrowser.toFixed(1)}`);
  for (const [name, value] of Object.entries(native)) console.log(`  native ${name} ${value.toFixed(1)}: ${(inBrowser / value).toFixed(2)} times that`);
  assert.ok(inBrowser <= MOST * native['SSE4'], `${(inBrowser / native['SSE4']).toFixed(2)} times the native frame`);
} finally {
  await browser.close();
}
