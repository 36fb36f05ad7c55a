// What a page loads when a bundler for browsers has made it one file: nothing for node alone, and no more bytes than promised.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';

const MOST_BYTES = 209_000; // compressed: simulation with everything, hair for three, and what joins them
const ofPackage = (name) => readFileSync(join('node_modules/coif', name));
const compressed = (bytes) => gzipSync(bytes, { level: 9 }).length;

/** The bundle of these lines, as esbuild makes it for browsers; anything it complains of fails. */
function bundle(folder, lines) {
  writeFileSync(join(folder, 'entry.mjs'), lines);
  const out = join(folder, 'bundle.mjs');
  execFileSync('esbuild', [join(folder, 'entry.mjs'), '--bundle', '--minify', '--format=esm', '--platform=browser', '--external:three',
    '--log-level=warning', '--log-limit=0', `--outfile=${out}`], { stdio: ['ignore', 'pipe', 'pipe'] });
  return out;
}

/** A folder beside node_modules, where `coif` is found. */
function inFolder(act) {
  const folder = mkdtempSync(join(resolve('.'), 'bundle-'));
  return Promise.resolve(act(folder)).finally(() => rmSync(folder, { recursive: true }));
}

test('what a page loads stays small', () => inFolder((folder) => {
  const scripts = compressed(readFileSync(bundle(folder, "export { loadCoif } from 'coif';\nexport * from 'coif/three';")));
  for (const [name, most] of [['coif.wasm', MOST_BYTES], ['coif-crowd.wasm', MOST_BYTES * 0.61]]) {
    const bytes = compressed(ofPackage(name));
    console.log(`${name} ${bytes} + scripts with coif/three ${scripts} = ${bytes + scripts} bytes, compressed`);
    assert.ok(bytes + scripts <= most, `${name} and scripts: ${bytes + scripts} bytes, above ${most}`);
  }
}));

test('the bundle works', () => inFolder(async (folder) => {
  const { loadCoif } = await import(pathToFileURL(bundle(folder, "export { loadCoif } from 'coif';")));
  const coif = await loadCoif({ wasm: ofPackage('coif.wasm'), memoryBytes: 16 << 20 });
  const hair = coif.openAsset(readFileSync('assets/bob.coif')).createHair({ instances: 1 });
  hair.step({ dt: 1 / 60 });
  assert.equal(hair.boneCount, 13);
}));
