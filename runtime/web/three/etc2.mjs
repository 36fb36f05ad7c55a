// ETC2 colour with EAC alpha, which desktop browsers do not take, as bytes. The format: Khronos Data Format Specification 1.3, chapters
// 21 and 22; formats/texel_blocks.cpp decodes the same.

const STEPS = [[2, 8], [5, 17], [9, 29], [13, 42], [18, 60], [24, 80], [33, 106], [47, 183]];
const DISTANCES = [3, 6, 11, 16, 23, 32, 41, 64];
const MODIFIERS = [
  [-3, -6, -9, -15], [-3, -7, -10, -13], [-2, -5, -8, -13], [-2, -4, -6, -13], [-3, -6, -8, -12], [-3, -7, -9, -11], [-4, -7, -8, -11],
  [-3, -5, -8, -11], [-2, -6, -8, -10], [-2, -5, -8, -10], [-2, -4, -8, -10], [-2, -5, -7, -10], [-3, -4, -7, -10], [-1, -2, -3, -10],
  [-4, -6, -8, -9], [-3, -5, -7, -9]];

const clamped = (value) => Math.min(Math.max(value, 0), 255);
const moved = (color, by) => color.map((channel) => clamped(channel + by));
const expanded = (value, bits) => (value << (8 - bits)) | (value >> (2 * bits - 8));
const signedThree = (value) => (value >= 4 ? value - 8 : value);

/** The colours of a block: `high` and `low` are its 64 bits. Calls `put` with column, row and colour of each texel. */
function decodeColor(high, low, put) {
  const bits = (lowest, count) => ((lowest >= 32 ? high >>> (lowest - 32) : low >>> lowest) & ((1 << count) - 1));
  const each = (colorOf) => {
    for (let texel = 0; texel < 16; ++texel) put(texel >> 2, texel & 3, colorOf(texel >> 2, texel & 3, (bits(16 + texel, 1) << 1) | bits(texel, 1)));
  };
  const four = (...channels) => channels.map((channel) => expanded(channel, 4));
  const halves = (first, second) => {
    const flipped = bits(32, 1);
    each((x, y, index) => {
      const side = (flipped ? y : x) >> 1;
      const step = STEPS[bits(side === 0 ? 37 : 34, 3)][index & 1];
      return moved(side === 0 ? first : second, index & 2 ? -step : step);
    });
  };
  const paints = (list) => each((x, y, index) => list[index]);
  if (bits(33, 1) === 0) {
    const part = (from) => [0, 1, 2].map((k) => expanded(bits(from - 8 * k, 4), 4));
    return halves(part(60), part(56));
  }
  const first = [0, 1, 2].map((k) => bits(59 - 8 * k, 5));
  const second = first.map((channel, k) => channel + signedThree(bits(56 - 8 * k, 3)));
  const outside = second.findIndex((channel) => channel < 0 || channel > 31);
  if (outside === -1) return halves(first.map((c) => expanded(c, 5)), second.map((c) => expanded(c, 5)));
  if (outside === 0) {
    const a = four((bits(59, 2) << 2) | bits(56, 2), bits(52, 4), bits(48, 4));
    const b = four(bits(44, 4), bits(40, 4), bits(36, 4));
    const distance = DISTANCES[(bits(34, 2) << 1) | bits(32, 1)];
    return paints([a, moved(b, distance), b, moved(b, -distance)]);
  }
  if (outside === 1) {
    const one = [bits(59, 4), (bits(56, 3) << 1) | bits(52, 1), (bits(51, 1) << 3) | bits(47, 3)];
    const two = [bits(43, 4), bits(39, 4), bits(35, 4)];
    const order = (c) => (c[0] << 8) | (c[1] << 4) | c[2];
    const distance = DISTANCES[(bits(34, 1) << 2) | (bits(32, 1) << 1) | (order(one) >= order(two) ? 1 : 0)];
    const [a, b] = [four(...one), four(...two)];
    return paints([moved(a, distance), moved(a, -distance), moved(b, distance), moved(b, -distance)]);
  }
  const corner = (red, green, blue) => [expanded(red, 6), expanded(green, 7), expanded(blue, 6)];
  const origin = corner(bits(57, 6), (bits(56, 1) << 6) | bits(49, 6), (bits(48, 1) << 5) | (bits(43, 2) << 3) | bits(39, 3));
  const right = corner((bits(34, 5) << 1) | bits(32, 1), bits(25, 7), bits(19, 6));
  const below = corner(bits(13, 6), bits(6, 7), bits(0, 6));
  each((x, y) => origin.map((o, k) => clamped((x * (right[k] - o) + y * (below[k] - o) + 4 * o + 2) >> 2)));
}

/** RGBA texels, row by row, of `bytes` as ETC2 with EAC alpha. */
export function decodeEtc2(bytes, width, height) {
  const texels = new Uint8Array(4 * width * height);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const columns = Math.ceil(width / 4);
  for (let at = 0; at < bytes.length; at += 16) {
    const [x0, y0] = [4 * ((at / 16) % columns), 4 * Math.floor(at / 16 / columns)];
    const place = (x, y) => (x0 + x < width && y0 + y < height ? 4 * ((y0 + y) * width + x0 + x) : -1);
    decodeColor(view.getUint32(at + 8), view.getUint32(at + 12), (x, y, color) => {
      if (place(x, y) >= 0) texels.set(color, place(x, y));
    });
    const [base, multiplier, row] = [bytes[at], bytes[at + 1] >> 4, MODIFIERS[bytes[at + 1] & 15]];
    for (let texel = 0; texel < 16; ++texel) {
      const bit = 45 - 3 * texel; // of 48, the highest first
      const low = at + 7 - (bit >> 3);
      const index = ((bytes[low] | (bytes[low - 1] << 8)) >> (bit & 7)) & 7;
      const modifier = index < 4 ? row[index] : -row[index & 3] - 1;
      if (place(texel >> 2, texel & 3) >= 0) texels[place(texel >> 2, texel & 3) + 3] = clamped(base + modifier * multiplier);
    }
  }
  return texels;
}
