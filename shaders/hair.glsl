// Code that all shaders of hair share, in pieces; README.md lists the pieces of each shader.

//// draw_block.glsl
// Values of one draw. The same layout as DrawBlock in coif/drawing.h. Everything is in view space, which has the
// world's axes and its origin at the eye. The host's world may be kilometres wide, so the precision of 32-bit floats is
// kept for things near the eye.
layout(std140) uniform DrawBlock {
  mat4 clip_from_view;
  vec4 base_color;         // linear, times the base texture
  vec4 ambient;            // rgb; w: rows that one head has in PaletteBlock
  vec4 primary;            // rgb, exponent
  vec4 secondary;          // rgb, exponent
  vec4 shift;              // x: primary, y: secondary, z: 1 to encode sRGB here, w: number of lights
  vec4 component;          // share of ambient, diffuse, primary, secondary; 0: not shown
  vec4 fiber;              // x: tilt, y: roughness, radians, z: scatter
  vec4 strands;            // x: glow, y: root shade, z: variation
  vec4 light_position[8];  // w 0: unit vector towards the light; w 1: position, metres
  vec4 light_color[8];     // rgb, linear; w: 1 / (inner - outer cosine) of its cone
  vec4 light_spot[8];      // xyz: unit vector along the cone; w: outer cosine, -2 where there is no cone
  vec4 sky[9];             // rgb: times 1, y, z, x, xy, yz, 3zz - 1, xz, xx - yy of a normal; first w: 1 if there is a sky
#ifdef COIF_SHADOW
  mat4 shadow_from_view;
  vec4 shadow_depth;
  vec4 shadow_map;         // w: index of the light that it belongs to, instead of a texel's width
#elif defined(COIF_MOTION)
  mat4 previous_clip_from_view;  // the last frame's, from axes around the last frame's eye
#endif
};

//// hair_base.glsl
// The base colour of a texel.
#ifdef COIF_BASE_TEXTURE
uniform sampler2D base_texture;  // sRGB decoded by the sampler; alpha not premultiplied

vec4 base_at(vec2 uv) { return texture(base_texture, uv) * base_color; }
#else
vec4 base_at(vec2 uv) { return base_color; }
#endif

//// hair_depth.frag
// Depth only, for the texels that the pass keeps.
in vec2 uv;

void main() {
  keep(base_at(uv).a);
}

//// hair_encode.glsl
// Encodes a colour for the framebuffer.
vec3 encode_srgb(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

vec3 encoded(vec3 linear) { return shift.z > 0.5 ? encode_srgb(linear) : linear; }

//// hair_output.glsl
// Writes a colour to the framebuffer.
out vec4 fragment;

void write_fragment(vec3 linear, float coverage) {
  // Premultiplied last, after encoding: the blend unit then adds colour * alpha to what is there * (1 - alpha), and the
  // target's own alpha becomes coverage.
  fragment = vec4(encoded(linear) * coverage, coverage);
}

//// hair_surface.glsl
// The point on the hair, for shaders that write colour.
in vec3 position;
in vec3 normal;
in vec3 tangent;
in vec2 uv;
in float place;
in float openness;

// Normals leave the vertex shader as long as the head's scale.
float head_scale() { return length(normal); }

// A card is a sheet of strands without thickness. From behind we see its back, so light and highlight belong to the side
// that faces us. Normals of the hair's volume belong to both sides.
vec3 seen_normal() {
#ifdef COIF_VOLUME_NORMALS
  return normalize(normal);
#else
  return normalize(gl_FrontFacing ? normal : -normal);
#endif
}
