// Values of one draw. The same layout as DrawBlock in runtime/gl/draw_block.h. Everything is in view space, which has the
// world's axes and its origin at the eye: the host's world may be kilometres wide, so 32-bit floats are kept for what is
// near enough to be seen well.
layout(std140) uniform DrawBlock {
  mat4 clip_from_view;
  vec4 base_color;         // linear, times the base texture
  vec4 ambient;            // rgb; w: rows that one head has in PaletteBlock
  vec4 primary;            // rgb, exponent
  vec4 secondary;          // rgb, exponent
  vec4 shift;              // x: primary, y: secondary, z: 1 to encode sRGB here, w: number of lights
  vec4 component;          // share of ambient, diffuse, primary, secondary; 0: not shown
  vec4 fiber;              // x: tilt, y: roughness, radians, z: scatter
  vec4 light_position[8];  // w 0: unit vector towards the light; w 1: position, metres
  vec4 light_color[8];     // rgb, linear; w: 1 / (inner - outer cosine) of its cone
  vec4 light_spot[8];      // xyz: unit vector along the cone; w: outer cosine, -2 where there is no cone
#ifdef COIF_SHADOW
  mat4 shadow_from_view;
  vec4 shadow_depth;
  vec4 shadow_map;         // w: index of the light that it belongs to, instead of a texel's width
#endif
};
