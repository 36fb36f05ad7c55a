// Pictures that `coif render` writes, and how far two are apart.

import { readFileSync } from 'node:fs';
import { inflateSync } from 'node:zlib';

function unfiltered(data, width, height) {
  const row = 4 * width;
  const out = new Uint8Array(row * height);
  const at = (y, x) => (x < 0 || y < 0 ? 0 : out[y * row + x]);
  for (let y = 0; y < height; ++y) {
    const kind = data[y * (row + 1)];
    for (let x = 0; x < row; ++x) {
      const a = at(y, x - 4), b = at(y - 1, x), c = x < 4 ? 0 : at(y - 1, x - 4);
      const p = a + b - c;
      const [pa, pb, pc] = [Math.abs(p - a), Math.abs(p - b), Math.abs(p - c)];
      const paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      const guess = [0, a, b, (a + b) >> 1, paeth][kind];
      out[y * row + x] = data[y * (row + 1) + 1 + x] + guess;
    }
  }
  return out;
}

/** { width, height, rgba } of a PNG of eight bits a channel, RGBA. */
export function readPng(file) {
  const bytes = readFileSync(file);
  const width = bytes.readUInt32BE(16), height = bytes.readUInt32BE(20);
  if (bytes[24] !== 8 || bytes[25] !== 6) throw new Error(`${file}: not RGBA of eight bits`);
  const pieces = [];
  for (let at = 8; at < bytes.length;) {
    const length = bytes.readUInt32BE(at);
    if (bytes.toString('latin1', at + 4, at + 8) === 'IDAT') pieces.push(bytes.subarray(at + 8, at + 8 + length));
    at += 12 + length;
  }
  return { width, height, rgba: unfiltered(inflateSync(Buffer.concat(pieces)), width, height) };
}

/** Peak signal-to-noise ratio of the colours, dB. */
export function psnr(a, b) {
  if (a.length !== b.length || a.length === 0) throw new Error('pictures of two sizes');
  let sum = 0;
  for (let i = 0; i < a.length; ++i) {
    if (i % 4 !== 3) sum += (a[i] - b[i]) ** 2;
  }
  return sum === 0 ? Infinity : 10 * Math.log10(255 ** 2 / (sum / (a.length * 0.75)));
}
