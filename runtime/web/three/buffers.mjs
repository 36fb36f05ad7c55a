// An asset's mesh and textures as three's objects: copied once, so that three can upload them again after the context was lost.

import {
  BufferAttribute, ClampToEdgeWrapping, DataTexture, FloatType, IntType, LinearFilter, LinearMipmapLinearFilter, NearestFilter, RepeatWrapping,
  RGBAFormat, RGFormat, SRGBColorSpace,
} from 'three';

import { CoifError } from '../memory.mjs';
import { RECORDS } from '../records.mjs';
import { decodeRg11 } from './eac.mjs';
import { decodeEtc2 } from './etc2.mjs';

const PALETTE_WIDTH = 768;
const MATRIX_FLOATS = 12;

const PARTS = { f32: Float32Array, i16: Int16Array, u16: Uint16Array, u8: Uint8Array };

/** A member of every record in `bytes`, as an attribute. */
function gather(record, name, bytes, isNormalized = false) {
  const stride = record.size;
  const { type, offset, count } = record.fields.get(name);
  const Type = PARTS[type];
  const size = Type.BYTES_PER_ELEMENT;
  const from = new Type(bytes.buffer, bytes.byteOffset, bytes.byteLength / size);
  const to = new Type((bytes.byteLength / stride) * count);
  for (let i = 0, at = offset / size; i < to.length; i += count, at += stride / size) {
    for (let part = 0; part < count; ++part) to[i + part] = from[at + part];
  }
  return new BufferAttribute(to, count, isNormalized);
}

/** Attributes by the names of shader_code.mjs; `position` and `normal` are three's own names. */
export function attributesOf(asset) {
  const { vertices, skin } = asset;
  const { Vertex, Skin } = RECORDS;
  const normals = gather(Vertex, 'normal', vertices, true);
  const attributes = {
    position: gather(Vertex, 'position', vertices),
    normal: normals,
    rest_normal: normals,
    rest_tangent: gather(Vertex, 'tangent', vertices, true),
    texture_place: gather(Vertex, 'uv', vertices),
  };
  if (skin.length > 0) {
    attributes.bones = gather(Skin, 'bone', skin);
    attributes.bones.gpuType = IntType; // integers, which the shader turns into places
    attributes.weights = gather(Skin, 'weight', skin, true);
  }
  return attributes;
}

/** Repeats only if a vertex's place leaves 0..1; else the roots' row of texels would blend with the tips'. */
function wrapOf(places) {
  const slack = 1e-3;
  return places.array.some((place) => place < -slack || place > 1 + slack) ? RepeatWrapping : ClampToEdgeWrapping;
}

const DECODERS = { 'rg11-eac': decodeRg11, 'srgb8-alpha8-etc2': decodeEtc2 };

function textureOf(asset, role, wrap) {
  const stored = asset.texture(role);
  if (stored === null) return null;
  const { format, width, height } = stored;
  const mipmaps = stored.mips.map((bytes, mip) => {
    const size = { width: Math.max(width >> mip, 1), height: Math.max(height >> mip, 1) };
    const decode = DECODERS[format] ?? ((texels) => texels.slice());
    return { data: decode(bytes, size.width, size.height), ...size };
  });
  const isColor = format.startsWith('srgb8-alpha8');
  const texture = new DataTexture(mipmaps[0].data, width, height, isColor ? RGBAFormat : RGFormat);
  if (isColor) texture.colorSpace = SRGBColorSpace;
  texture.mipmaps = mipmaps; // the asset's own: they keep the hair's coverage
  texture.generateMipmaps = false;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.magFilter = LinearFilter;
  texture.wrapS = texture.wrapT = wrap;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}

export function texturesOf(asset, places) {
  const wrap = wrapOf(places);
  return {
    base: textureOf(asset, 'base-color', wrap),
    shiftMask: textureOf(asset, 'shift-mask', wrap),
    normals: textureOf(asset, 'normal-map', wrap),
    strands: textureOf(asset, 'strand-map', wrap),
  };
}

/** The bone matrices of all heads, in the simulation's memory: three uploads them from there without a copy. */
export function paletteTexture(coif, hair) {
  const first = hair.palette(0);
  const floats = MATRIX_FLOATS * hair.boneCount * hair.instances;
  const last = hair.palette(hair.instances - 1);
  if (last.byteOffset + last.byteLength !== first.byteOffset + 4 * floats) {
    throw new CoifError('matrices of heads do not lie one after the other');
  }
  const height = Math.ceil(floats / (4 * PALETTE_WIDTH));
  const { buffer } = coif.memory;
  const end = first.byteOffset + 16 * PALETTE_WIDTH * height; // the last row may be longer than the matrices are
  if (end > buffer.byteLength) throw new CoifError('memoryBytes is too small for so many heads', 'COIF_MEMORY_TOO_SMALL');
  const texels = new Float32Array(buffer, first.byteOffset, 4 * PALETTE_WIDTH * height);
  const texture = new DataTexture(texels, PALETTE_WIDTH, height, RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}
