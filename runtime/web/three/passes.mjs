// Ways to draw hair with three: the passes of each, and their materials, after the table in shaders/README.md, "Passes".

import {
  BackSide, DoubleSide, FrontSide, MeshBasicMaterial, MeshDepthMaterial, MeshDistanceMaterial, MeshStandardMaterial, RGBADepthPacking,
} from 'three';

import { keepHair, shadeHair } from './shader_code.mjs';

const DOUBLE_SIDED = 1; // MaterialRecord::flags
const FACES_TOGETHER = 2;
const VOLUME_NORMALS = 4;
const NO_LIMIT = 3.402823466e38;
const DEPTH_ALPHA = 0.5; // from this alpha on, missing depth would be the larger error for things that are drawn later

/** A pass of texels with `from` <= alpha < `to`; from `solid` on they cover everything behind them. */
const pass = (name, from, to, solid, more = {}) => ({
  name, from, to, solid, keep: 'keep_range.glsl', side: DoubleSide, blended: false, writesColor: true, writesDepth: true, ...more });

const thinned = (name, keep, before) => ({ discard, opaque }) => [pass(name, discard, NO_LIMIT, opaque, { keep, before, thins: true })];

/** The passes for a material's thresholds and flags, in order. */
export const MODES = {
  blend({ discard, opaque, both, together }) {
    const soft = (name, side) => pass(name, discard, opaque, NO_LIMIT, { side, blended: true, writesDepth: false });
    return [
      pass('solid', opaque, NO_LIMIT, opaque),
      ...(both && !together ? [soft('far sides', BackSide)] : []),
      soft('near sides', together ? DoubleSide : FrontSide),
      pass('depth', Math.max(discard, DEPTH_ALPHA), opaque, 0, { writesColor: false, blended: true }),
    ];
  },
  opaque: ({ opaque }) => [pass('cut', opaque, NO_LIMIT, opaque)],
  hashed: thinned('hashed', 'keep_hashed.glsl'),
  bayer: thinned('bayer', 'keep_bayer.glsl', 'bayer_square.glsl'),
  coverage: ({ discard, opaque }) => [pass('coverage', Math.min(opaque, Math.max(discard, DEPTH_ALPHA)), NO_LIMIT, opaque,
    { keep: 'keep_sharpened.glsl', toCoverage: true, thins: true })],
};

/** The passes that draw something of a material whose texture's alpha lies between two values. */
export function passesOf(mode, material, { lowest, highest }) {
  if (!(mode in MODES)) throw new RangeError(`'${mode}' is no way to draw hair; there are ${Object.keys(MODES).join(', ')}`);
  const ends = [lowest * material.baseColor[3], highest * material.baseColor[3]];
  const [least, most] = [Math.min(...ends), Math.max(...ends)];
  const both = (material.flags & DOUBLE_SIDED) !== 0;
  const together = both && (material.flags & FACES_TOGETHER) !== 0;
  return MODES[mode]({ discard: material.discardThreshold, opaque: material.opaqueThreshold, both, together })
    .filter(({ from, to }) => from < to && most >= from && least < to)
    .map((each) => ({
      ...each,
      side: each.side === DoubleSide && !both ? FrontSide : each.side,
      tests: least < each.from || most >= each.to || (each.thins && least < each.solid),
    }));
}

/** The defines for an asset's features. */
function definesOf(hair, each) {
  const { skinning, textures, material } = hair;
  const lit = (color) => color.some((part) => part !== 0) || material.shading >= 2; // fibres' highlights have no colour of their own
  const defines = { HAIR_BONES: [0, 1, 4][skinning] };
  if (each.tests) defines.COIF_ALPHA_TEST = '';
  if ((material.flags & VOLUME_NORMALS) !== 0) defines.COIF_VOLUME_NORMALS = '';
  if (textures.base) defines.COIF_BASE_TEXTURE = '';
  if (textures.shiftMask) defines.COIF_SHIFT_MASK = '';
  if (textures.normals) defines.COIF_NORMAL_MAP = '';
  if (textures.strands) defines.COIF_STRAND_MAP = '';
  if (lit(material.primaryColor)) defines.COIF_PRIMARY = '';
  if (lit(material.secondaryColor)) defines.COIF_SECONDARY = '';
  return defines;
}

function finish(material, hair, each, change) {
  const { textures, uniforms } = hair;
  const range = { value: [each.from, each.to, each.solid] };
  material.defines = { ...material.defines, ...definesOf(hair, each) };
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms, { alpha_range: range });
    change(shader, hair.material.shading, textures.normals !== null || textures.strands !== null);
  };
  material.customProgramCacheKey = () => `coif ${each.keep} ${hair.material.shading}`;
  return material;
}

const state = (each) => ({
  side: each.side,
  shadowSide: DoubleSide,
  transparent: each.blended,
  premultipliedAlpha: true,
  alphaToCoverage: each.toCoverage === true,
  depthWrite: each.writesDepth,
  colorWrite: each.writesColor,
  forceSinglePass: true,
});

/** The material of a pass. `hair`: a CoifHair's textures, uniforms and record. */
export function passMaterial(hair, each) {
  if (!each.writesColor) return finish(new MeshBasicMaterial(state(each)), hair, each, (shader) => keepHair(shader, each));
  return finish(new MeshStandardMaterial(state(each)), hair, each, (shader, model, maps) => shadeHair(shader, each, model, maps));
}

/** The material that draws hair into three's shadow maps: texels that are more solid than transparent. */
export function shadowMaterials(hair) {
  const each = { ...pass('shadow', DEPTH_ALPHA, NO_LIMIT, 0), tests: true };
  const kept = (material) => finish(material, hair, each, (shader) => keepHair(shader, each));
  return { depth: kept(new MeshDepthMaterial({ depthPacking: RGBADepthPacking })), distance: kept(new MeshDistanceMaterial()) };
}
