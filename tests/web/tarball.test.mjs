// The packed tarball, installed where nothing else is, runs what its README shows.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { test } from 'node:test';

const run = (cwd, program, ...args) => execFileSync(program, args, { cwd, encoding: 'utf8' });
const NPM_ARGS = ['--no-audit', '--no-fund', '--offline', '--omit=peer'];

test('the README\'s example runs from an installed tarball', () => {
  const folder = mkdtempSync(join(tmpdir(), 'coif-tarball-'));
  try {
    const packed = JSON.parse(run(folder, process.env.NPM, 'pack', '--json', resolve('node_modules/coif')))[0];
    const files = packed.files.map(({ path }) => path).sort();
    assert.ok(['LICENSE', 'THIRD_PARTY_NOTICES.txt', 'README.md', 'coif.d.ts', 'coif.mjs', 'coif.wasm', 'coif-crowd.wasm', 'vrm.d.ts', 'vrm.mjs'].every((name) => files.includes(name)), `${files}`);
    for (const [name, most] of [['coif.wasm', 495616], ['coif-crowd.wasm', 258048]]) {
      const { size } = packed.files.find(({ path }) => path === name);
      assert.ok(size <= most, `${name}: ${size} bytes, above ${most}`);
    }
    writeFileSync(join(folder, 'package.json'), '{"private": true, "type": "module"}');
    run(folder, process.env.NPM, 'install', ...NPM_ARGS, `./${packed.filename}`);
    const readme = readFileSync(join(folder, 'node_modules/coif/README.md'), 'utf8');
    for (const [, link] of readme.matchAll(/\]\(([^)#:]+)\)/g)) assert.ok(files.includes(link), `the README points to ${link}, which is not in the package`);
    const [, example] = /```js\n([\s\S]*?)```/.exec(readme);
    writeFileSync(join(folder, 'example.mjs'), example);
    assert.match(run(folder, process.execPath, 'example.mjs', resolve('assets/bob.coif')), /^13 bones, the last at -?[0-9.]+,/);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
