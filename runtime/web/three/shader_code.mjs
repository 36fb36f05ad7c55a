// Puts coif's shaders into three's: three's code handles lights, shadows, fog and colour spaces, coif's skins vertices, keeps or
// drops texels and reflects light. shaders/README.md documents the pieces and the names that they read.

import { pieces } from './shaders.mjs';

const MODELS = ['thesis', 'kajiya_kay', 'marschner', 'volume'];

/** Vertices: bones of all heads in one texture, head after head; each instance has a number and a matrix of its own. */
const VERTEX = /* glsl */ `
attribute vec4 rest_normal;
attribute vec4 rest_tangent;
attribute vec2 texture_place;
attribute vec4 head_x;
attribute vec4 head_y;
attribute vec4 head_z;
attribute float head;
varying vec2 hair_uv;
varying float hair_openness;
varying vec3 hair_tangent;
varying vec3 rest_place;
invariant gl_Position;
vec3 posed_position, posed_normal, posed_tangent;

vec3 hair_times(vec4 x, vec4 y, vec4 z, vec4 v) { return vec3(dot(x, v), dot(y, v), dot(z, v)); }

#if HAIR_BONES > 0
attribute uvec4 bones;
attribute vec4 weights;
uniform highp sampler2D palette_texture;  // 256 bones to a row
uniform int bone_count;

vec4 hair_row(uint bone, int row) {
  int index = int(head) * bone_count + int(bone);
  return texelFetch(palette_texture, ivec2(index % 256 * 3 + row, index / 256), 0);
}
#endif
#if HAIR_BONES == 4
vec4 blended_row(int row) {
  return weights.x * hair_row(bones.x, row) + weights.y * hair_row(bones.y, row) + weights.z * hair_row(bones.z, row) +
         weights.w * hair_row(bones.w, row);
}
#elif HAIR_BONES == 1
vec4 blended_row(int row) { return hair_row(bones.x, row); }
#else
vec4 blended_row(int row) { return vec4(row == 0, row == 1, row == 2, 0.0); }
#endif

void pose_vertex() {
  vec4 x = blended_row(0), y = blended_row(1), z = blended_row(2);
  posed_position = hair_times(head_x, head_y, head_z, vec4(hair_times(x, y, z, vec4(position, 1.0)), 1.0));
  posed_normal = hair_times(head_x, head_y, head_z, vec4(hair_times(x, y, z, vec4(rest_normal.xyz, 0.0)), 0.0));
  posed_tangent = hair_times(head_x, head_y, head_z, vec4(hair_times(x, y, z, vec4(rest_tangent.xyz, 0.0)), 0.0));
  hair_uv = texture_place;
  hair_openness = rest_normal.w;
  rest_place = position;
}
`;

const VERTEX_MAIN = {
  '#include <common>': `#include <common>\n${VERTEX}`,
  '#include <uv_vertex>': 'pose_vertex();',
  '#include <beginnormal_vertex>': 'vec3 objectNormal = posed_normal;',
  '#include <begin_vertex>': 'vec3 transformed = posed_position;',
  '#include <project_vertex>': '#include <project_vertex>\n  hair_tangent = (modelViewMatrix * vec4(posed_tangent, 0.0)).xyz;',
};

/** Which texels are drawn. `in` of the pieces are three's varyings here. */
const keeping = (pass) => /* glsl */ `
varying vec2 hair_uv;
varying vec3 rest_place;
uniform vec4 base_color;
${pieces['hair_base.glsl']}
${pass.before === undefined ? '' : pieces[pass.before]}
${pieces[pass.keep].replace(/^in vec3 rest_place;.*$/m, '')}
`;

/** Light on a strand. Some names of the pieces are also three's, so defines rename them within the pieces. */
const shading = (model, maps) => /* glsl */ `
varying vec3 hair_tangent;
varying float hair_openness;
uniform vec4 primary, secondary, shift, component, fiber;
#define position (-vViewPosition)
#define uv hair_uv
#define pow2 hair_pow2
float head_scale() { return 1.0; }
${maps ? pieces['relief.glsl'] : ''}
${pieces['shading.glsl']}
${pieces[`shading_${MODELS[model]}.glsl`]}
#ifndef COIF_MANY_FIBERS
vec3 sky_reflected(Strand strand, float openness) { return openness * strand.color; }
#endif
#undef pow2
#undef uv
#undef position
#ifdef COIF_SHIFT_MASK
uniform sampler2D shift_mask_texture;
#endif

struct HairMaterial { vec3 color; };
Strand hair_strand;
Reflected hair_sum;

// three's light is an irradiance, coif's the radiance of a white matte surface.
void RE_Direct_Hair(const in IncidentLight light, const in vec3 at, const in vec3 normal, const in vec3 view, const in vec3 clearcoat,
                    const in HairMaterial material, inout ReflectedLight reflected) {
  add_light(hair_sum, hair_strand, light.direction, light.color * RECIPROCAL_PI);
}
void RE_IndirectDiffuse_Hair(const in vec3 irradiance, const in vec3 at, const in vec3 normal, const in vec3 view, const in vec3 clearcoat,
                             const in HairMaterial material, inout ReflectedLight reflected) {
  reflected.indirectDiffuse += component.x * irradiance * RECIPROCAL_PI * sky_reflected(hair_strand, hair_openness);
}
#define RE_Direct RE_Direct_Hair
#define RE_IndirectDiffuse RE_IndirectDiffuse_Hair
`;

/** Before any discard: mips and the axes of maps need the neighbours. */
const strandMain = (maps) => /* glsl */ `
  vec4 hair_texel = base_at(hair_uv);
#ifdef COIF_SHIFT_MASK
  vec2 shift_mask = texture(shift_mask_texture, hair_uv).rg;
#else
  vec2 shift_mask = vec2(0.5, 1.0);
#endif
#ifdef COIF_VOLUME_NORMALS
  vec3 along = normalize(hair_tangent), outward = normalize(vNormal);
#else
  vec3 along = normalize(hair_tangent), outward = normal;
#endif
  ${maps ? 'follow_relief(along, outward);' : ''}
  hair_strand = Strand(along, outward, normalize(vViewPosition), hair_texel.rgb, shift_mask.x - 0.5, shift_mask.y);
  hair_sum = Reflected(vec3(0.0), vec3(0.0), vec3(0.0));
  HairMaterial material = HairMaterial(hair_texel.rgb);
  diffuseColor.a = keep(hair_texel.a);
`;

// From revision 186 on, three's own material reads a table for its reflections before it adds up lights. Hair has no such members.
const LIGHTS_MAIN = /* glsl */ `
#undef STANDARD
#include <lights_fragment_begin>
#define STANDARD
`;

const SUM_MAIN = /* glsl */ `
#include <lights_fragment_end>
#if defined(USE_ENVMAP) && (defined(ENVMAP_TYPE_CUBE_UV) || defined(ENVMAP_TYPE_PMREM))
  reflectedLight.indirectDiffuse += component.x * iblIrradiance * RECIPROCAL_PI * sky_reflected(hair_strand, hair_openness);
#endif
  reflectedLight.directDiffuse += (component.y * hair_sum.diffuse + component.z * hair_sum.primary + component.w * hair_sum.secondary) *
                                  tint(hair_strand);
`;

const replaced = (code, table) => Object.entries(table).reduce((text, [what, by]) => {
  if (!text.includes(what)) throw new Error(`coif/three: this version of three has no '${what}' in its shaders`);
  return text.replace(what, by);
}, code);

/** For MeshStandardMaterial, whose lighting is replaced; it alone has three's scene.environment. `maps`: normals or strands come from textures. */
export function shadeHair(shader, pass, model, maps) {
  shader.vertexShader = replaced(shader.vertexShader, VERTEX_MAIN);
  shader.fragmentShader = replaced(shader.fragmentShader, {
    '#include <lights_physical_pars_fragment>': keeping(pass) + shading(model, maps),
    '#include <lights_physical_fragment>': strandMain(maps),
    '#include <lights_fragment_begin>': LIGHTS_MAIN,
    '#include <lights_fragment_end>': SUM_MAIN,
  });
}

/** For MeshBasicMaterial, MeshDepthMaterial and MeshDistanceMaterial: coif keeps or drops texels, and three writes its own output. */
export function keepHair(shader, pass) {
  const { '#include <beginnormal_vertex>': normal, ...main } = VERTEX_MAIN;
  shader.vertexShader = replaced(shader.vertexShader, main);
  shader.fragmentShader = replaced(shader.fragmentShader, {
    '#include <alphatest_pars_fragment>': keeping(pass),
    '#include <alphatest_fragment>': 'keep(base_at(hair_uv).a);',
  });
}
