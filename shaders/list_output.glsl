// Puts a texel into its pixel's list instead of the framebuffer. After fragment_lists.glsl.

// What is behind the host's own things or solid hair must not get into a list.
layout(early_fragment_tests) in;

flat in int corner;

void write_fragment(vec3 linear, float coverage) {
  uint place = atomicAdd(list_count, 1u);
  if (place >= list_capacity) return;
  vec3 color = encoded(linear) * coverage;
  uint next = atomicExchange(list_heads[list_of_pixel()], place + 1u);
  list_nodes[place] = Node(packHalf2x16(color.rg), packHalf2x16(vec2(color.b, coverage)), floatBitsToUint(gl_FragCoord.z),
                           uint(corner), next);
}
