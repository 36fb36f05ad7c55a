// Blocks of two-channel EAC by hand, from the format's own definition, and blocks of colours as the native code decodes them.

import { strict as assert } from 'node:assert';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { test } from 'node:test';

const { decodeRg11 } = await import(pathToFileURL(join(process.env.PACKAGE, 'three/eac.mjs')));
const { decodeEtc2 } = await import(pathToFileURL(join(process.env.PACKAGE, 'three/etc2.mjs')));

/** A channel's block: base, multiplier, row of modifiers, and which of the row each texel takes, column by column. */
function block(base, multiplier, row, picks) {
  let bits = 0n;
  for (const pick of picks) bits = (bits << 3n) | BigInt(pick);
  const bytes = [base, (multiplier << 4) | row];
  for (let shift = 40n; shift >= 0n; shift -= 8n) bytes.push(Number((bits >> shift) & 255n));
  return bytes;
}

const byteOf = (value) => Math.round((Math.min(Math.max(value, 0), 2047) * 255) / 2047);
const all = (pick) => new Array(16).fill(pick);

test('each texel takes its modifier, times the multiplier, column by column', () => {
  const picks = [...all(0).keys()].map((i) => i % 8);
  const row = [-3, -6, -9, -15, 2, 5, 8, 14]; // the format's first
  const texels = decodeRg11(Uint8Array.from([...block(100, 3, 0, picks), ...block(60, 0, 0, all(7))]), 4, 4);
  for (let x = 0; x < 4; ++x) {
    for (let y = 0; y < 4; ++y) {
      assert.equal(texels[2 * (4 * y + x)], byteOf(100 * 8 + 4 + row[picks[4 * x + y]] * 24), `${x}, ${y}`);
      assert.equal(texels[2 * (4 * y + x) + 1], byteOf(60 * 8 + 4 + 14), 'a multiplier of nought stands for an eighth');
    }
  }
});

test('values end at black and white', () => {
  const texels = decodeRg11(Uint8Array.from([...block(255, 15, 13, all(7)), ...block(0, 15, 13, all(3))]), 4, 4);
  assert.deepEqual([...texels.subarray(0, 2)], [255, 0]);
});

test('blocks beyond the edge are cut', () => {
  const one = [...block(0, 0, 0, all(4)), ...block(0, 0, 0, all(4))];
  const two = [...block(200, 0, 0, all(4)), ...block(200, 0, 0, all(4))];
  const texels = decodeRg11(Uint8Array.from([...one, ...two]), 5, 2);
  assert.equal(texels.length, 20);
  assert.deepEqual([texels[6], texels[8], texels[18]], [byteOf(6), byteOf(1606), byteOf(1606)]);
});

test('blocks of colours of every mode are what tests/models/random_blocks.h says', () => {
  const bytes = new Uint8Array(16 * 4096);
  let x = 1;
  for (let i = 0; i < bytes.length; ++i) {
    x = (Math.imul(1664525, x) + 1013904223) >>> 0;
    bytes[i] = x >>> 24;
  }
  let hash = 2166136261;
  for (const byte of decodeEtc2(bytes, 256, 256)) hash = Math.imul(hash ^ byte, 16777619) >>> 0;
  assert.equal(hash, 958072869);
  assert.equal(decodeEtc2(bytes.subarray(0, 32), 5, 2).length, 40, 'blocks beyond the edge are cut');
});
