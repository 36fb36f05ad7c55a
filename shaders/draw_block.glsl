// Values of one draw call. The same layout as DrawBlock in runtime/gl/draw_block.h. Everything is in head space: the
// host's world may be kilometres wide, a head is not, so 32-bit floats stay exact enough.
layout(std140) uniform DrawBlock {
  mat4 clip_from_head;
  vec4 eye;                // xyz: metres
  vec4 base_color;         // linear, times the base texture
  vec4 ambient;            // rgb
  vec4 primary;            // rgb, exponent
  vec4 secondary;          // rgb, exponent
  vec4 shift;              // x: primary, y: secondary, z: 1 to encode sRGB here, w: number of lights
  vec4 component;          // share of ambient, diffuse, primary, secondary: 0 or 1
  vec4 light_position[8];  // w 0: unit vector towards the light; w 1: position, metres
  vec4 light_color[8];     // rgb, linear
};
