// Two-channel EAC, which desktop browsers do not take, as bytes. The format: Khronos Data Format Specification 1.3, chapter 22
// (RG11 EAC): per channel and block of 4 x 4 texels a base, a multiplier, one of sixteen rows of modifiers and three bits a texel.

const MODIFIERS = [
  [-3, -6, -9, -15, 2, 5, 8, 14], [-3, -7, -10, -13, 2, 6, 9, 12], [-2, -5, -8, -13, 1, 4, 7, 12], [-2, -4, -6, -13, 1, 3, 5, 12],
  [-3, -6, -8, -12, 2, 5, 7, 11], [-3, -7, -9, -11, 2, 6, 8, 10], [-4, -7, -8, -11, 3, 6, 7, 10], [-3, -5, -8, -11, 2, 4, 7, 10],
  [-2, -6, -8, -10, 1, 5, 7, 9], [-2, -5, -8, -10, 1, 4, 7, 9], [-2, -4, -8, -10, 1, 3, 7, 9], [-2, -5, -7, -10, 1, 4, 6, 9],
  [-3, -4, -7, -10, 2, 3, 6, 9], [-1, -2, -3, -10, 0, 1, 2, 9], [-4, -6, -8, -9, 3, 5, 7, 8], [-3, -5, -7, -9, 2, 4, 6, 8]];

/** The sixteen values of a channel's block, 0..2047, column by column as they are stored. */
function blockOf(bytes, at, values) {
  const base = bytes[at] * 8 + 4;
  const row = MODIFIERS[bytes[at + 1] & 15];
  const multiplier = bytes[at + 1] >> 4;
  for (let texel = 0; texel < 16; ++texel) {
    const bit = 45 - 3 * texel; // of 48, the highest first
    const low = at + 7 - (bit >> 3);
    const three = ((bytes[low] | (bytes[low - 1] << 8)) >> (bit & 7)) & 7;
    const value = base + row[three] * (multiplier === 0 ? 1 : multiplier * 8);
    values[texel] = Math.min(Math.max(value, 0), 2047);
  }
}

/** RG8 texels, row by row, of `bytes` as RG11 EAC. */
export function decodeRg11(bytes, width, height) {
  const texels = new Uint8Array(2 * width * height);
  const values = new Uint16Array(16);
  const columns = Math.ceil(width / 4);
  for (let block = 0; block * 16 < bytes.length; ++block) {
    const [x0, y0] = [4 * (block % columns), 4 * Math.floor(block / columns)];
    for (let channel = 0; channel < 2; ++channel) {
      blockOf(bytes, block * 16 + channel * 8, values);
      for (let texel = 0; texel < 16; ++texel) {
        const [x, y] = [x0 + (texel >> 2), y0 + (texel & 3)];
        if (x < width && y < height) texels[2 * (y * width + x) + channel] = Math.round((values[texel] * 255) / 2047);
      }
    }
  }
  return texels;
}
