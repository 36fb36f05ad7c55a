// The same for artists' files, cooked here, as many as cook.

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, statSync } from 'node:fs';
import { basename, extname, join } from 'node:path';
import { test } from 'node:test';
import { loadCoif } from 'coif';
import { hashLines } from './step_motions.mjs';

const folder = join(process.env.COIF_TEST_ASSETS, 'hair');
const MODELS = new Set(['.glb', '.vrm', '.fbx', '.obj']);
const LEAST = 8; // of those there, so many cook without a recipe

function* models(at) {
  for (const name of readdirSync(at).sort()) {
    const path = join(at, name);
    if (statSync(path).isDirectory()) yield* models(path);
    else if (MODELS.has(extname(name).toLowerCase())) yield path;
  }
}

if (!existsSync(folder)) {
  console.log(`skipped: no corpus of artists' files in ${folder}`);
} else {
  mkdirSync('artists_files', { recursive: true });
  const cooked = [];
  for (const source of models(folder)) {
    const asset = join('artists_files', `${basename(source, extname(source))}.coif`);
    const { status } = spawnSync(process.env.COIF, ['cook', source, '--draft', '-o', asset, '--max-seconds', '60'], { stdio: 'ignore' });
    if (status === 0) cooked.push(asset);
  }
  test('enough of them cook', () => assert.ok(cooked.length >= LEAST, `${cooked.length} cooked`));
  for (const file of cooked) {
    test(`${basename(file)}: matrices have the bits of the native build`, async () => {
      const native = execFileSync(process.env.STEP_MOTIONS, ['hashes', 'poses.bin', file], { encoding: 'utf8' });
      assert.deepEqual(hashLines(await loadCoif(), 'poses.bin', [file]), native.trim().split('\n'));
    });
  }
}
