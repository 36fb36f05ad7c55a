// Pictures that `coif render` writes, and how far two are apart.

import { readFileSync } from 'node:fs';
import { inflateSync } from 'node:zlib';

/** The bytes of each row, without its filter. */
function unfiltered(data, row, height, channels) {
  const out = new Uint8Array(row * height);
  const at = (y, x) => (x < 0 || y < 0 ? 0 : out[y * row + x]);
  for (let y = 0; y < height; ++y) {
    const kind = data[y * (row + 1)];
    for (let x = 0; x < row; ++x) {
      const a = at(y, x - channels), b = at(y - 1, x), c = x < channels ? 0 : at(y - 1, x - channels);
      const p = a + b - c;
      const [pa, pb, pc] = [Math.abs(p - a), Math.abs(p - b), Math.abs(p - c)];
      const paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      const guess = [0, a, b, (a + b) >> 1, paeth][kind];
      out[y * row + x] = data[y * (row + 1) + 1 + x] + guess;
    }
  }
  return out;
}

/** RGBA of pixels that may lack alpha. */
function withAlpha(pixels, channels) {
  if (channels === 4) return pixels;
  const rgba = new Uint8Array(pixels.length / 3 * 4).fill(255);
  for (let i = 0; i < pixels.length / 3; ++i) rgba.set(pixels.subarray(3 * i, 3 * i + 3), 4 * i);
  return rgba;
}

/** { width, height, rgba } of a PNG of eight bits a channel, RGB or RGBA. */
export function readPng(file) {
  const bytes = readFileSync(file);
  const width = bytes.readUInt32BE(16), height = bytes.readUInt32BE(20), channels = { 2: 3, 6: 4 }[bytes[25]];
  if (bytes[24] !== 8 || !channels) throw new Error(`${file}: neither RGB nor RGBA of eight bits`);
  const pieces = [];
  for (let at = 8; at < bytes.length;) {
    const length = bytes.readUInt32BE(at);
    if (bytes.toString('latin1', at + 4, at + 8) === 'IDAT') pieces.push(bytes.subarray(at + 8, at + 8 + length));
    at += 12 + length;
  }
  const pixels = unfiltered(inflateSync(Buffer.concat(pieces)), channels * width, height, channels);
  return { width, height, rgba: withAlpha(pixels, channels) };
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
