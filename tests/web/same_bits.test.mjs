// The package computes what the native library computes, to the bit: every solver, every motion, the project's samples.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { loadCoif } from 'coif';
import { hashLines } from './step_motions.mjs';

const nativeLines = (files) => execFileSync(process.env.STEP_MOTIONS, ['hashes', 'poses.bin', ...files], { encoding: 'utf8' }).trim().split('\n');

for (const name of ['bob', 'long']) {
  test(`${name}: matrices have the bits of the native build`, async () => {
    const files = [`assets/${name}.coif`];
    const lines = hashLines(await loadCoif(), 'poses.bin', files);
    assert.equal(lines.length, 55, 'five solvers and eleven motions');
    assert.equal(new Set(lines.map((line) => line.split(' ').at(-1))).size >= 36, true, 'motions and solvers differ, but for those of one model');
    assert.deepEqual(lines, nativeLines(files));
  });
}
