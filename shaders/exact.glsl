// Soft texels in the order of their depth: lists that are sorted, or layers that are peeled. See README.md, Exact
// order.

//// fragment_lists.glsl
// Lists of soft texels, one for each pixel, in the layout of ListHead in runtime/research/exact_lists.cpp.
struct Node {
  uint red_green;   // premultiplied, as halves
  uint blue_alpha;
  uint depth;       // bits of a positive float, which compare as the float does
  uint corner;      // of texels at one depth the one with the higher corner is in front
  uint next;        // place of the next node + 1; 0: none
};

layout(std430, binding = 0) buffer ListHeads {
  uint list_count;      // nodes asked for, more than there are if the lists overflow
  uint list_capacity;
  int list_left;        // the viewport's first pixel
  int list_bottom;
  int list_width;
  uint list_heads[];    // place of the pixel's first node + 1; 0: none
};

layout(std430, binding = 1) buffer ListNodes {
  Node list_nodes[];
};

int list_of_pixel() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - ivec2(list_left, list_bottom);
  return pixel.y * list_width + pixel.x;
}

//// list_output.glsl
// Puts a texel into its pixel's list instead of the framebuffer. After fragment_lists.glsl.

// Texels behind the host's own things or solid hair must not get into a list.
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

//// list_resolve.vert
// One triangle that covers the viewport.
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}

//// list_resolve.frag
// Sorts a pixel's list and blends it from far to near. After fragment_lists.glsl. The nearest texel behind the last one
// is looked for again and again: lists are a few dozen long, may be longer, and nothing has to be kept.
out vec4 fragment;

// Whether a is blended before b. Nodes lie in a list as they arrived, which differs from run to run; so the last word
// have colours, and nodes that are equal in everything may go in any order.
bool is_behind(Node a, Node b) {
  if (a.depth != b.depth) return a.depth > b.depth;
  if (a.corner != b.corner) return a.corner < b.corner;
  if (a.red_green != b.red_green) return a.red_green < b.red_green;
  return a.blue_alpha < b.blue_alpha;
}

// The first node behind all others that are not behind `last`, nor last itself; and how many are equal to it.
uint find_next(uint head, bool is_first, Node last, inout Node found) {
  uint equals = 0u;
  for (uint place = head; place != 0u; place = list_nodes[place - 1u].next) {
    Node node = list_nodes[place - 1u];
    if (!is_first && !is_behind(last, node)) continue;
    if (equals == 0u || is_behind(node, found)) {
      found = node;
      equals = 1u;
    } else if (!is_behind(found, node)) {
      ++equals;
    }
  }
  return equals;
}

void main() {
  uint head = list_heads[list_of_pixel()];
  if (head == 0u) discard;
  Node last = list_nodes[head - 1u];
  Node found = last;
  vec4 sum = vec4(0.0);
  uint equals = find_next(head, true, last, found);
  while (equals != 0u) {
    vec4 color = vec4(unpackHalf2x16(found.red_green), unpackHalf2x16(found.blue_alpha));
    for (uint i = 0u; i < equals; ++i) sum = color + sum * (1.0 - color.a);
    last = found;
    equals = find_next(head, false, last, found);
  }
  fragment = sum;
}

//// peel_place.glsl
// A texel's place in the order of its pixel: by depth, at one depth by its triangle's last vertex. Texels are peeled
// from the far one on.
uniform highp usampler2D peeled_layer;  // the texel drawn last: bits of its depth, corner
flat in int corner;

uint place_depth() { return floatBitsToUint(gl_FragCoord.z); }  // positive floats compare as their bits do
uint place_corner() { return uint(corner) & 0xFFFFFFu; }        // as many bits as a float holds exactly

bool is_peeled() {
  uvec2 last = texelFetch(peeled_layer, ivec2(gl_FragCoord.xy), 0).rg;
  return place_depth() > last.x || (place_depth() == last.x && place_corner() <= last.y);
}

//// peel_depth.frag
// Finds the depth of the furthest texel that is not yet peeled: the depth buffer keeps the greatest. After
// peel_place.glsl.
in vec2 uv;
out uint found_depth;

void main() {
  keep(base_at(uv).a);
  if (is_peeled()) discard;
  found_depth = place_depth();
}

//// peel_key.frag
// Finds the first of the texels at the depth that was found: the depth buffer keeps the lowest corner.
// After peel_place.glsl.
uniform highp usampler2D found_layer;
in vec2 uv;
out uvec2 found;

void main() {
  keep(base_at(uv).a);
  if (is_peeled() || place_depth() != texelFetch(found_layer, ivec2(gl_FragCoord.xy), 0).r) discard;
  found = uvec2(place_depth(), place_corner());
  gl_FragDepth = float(place_corner()) / 16777216.0;
}

//// keep_peeled.glsl
// Draws the one texel of each pixel that was peeled last. After peel_place.glsl.
uniform vec3 alpha_range;  // x <= alpha < y is drawn

float keep(float alpha) {
  uvec2 last = texelFetch(peeled_layer, ivec2(gl_FragCoord.xy), 0).rg;
  if (last != uvec2(place_depth(), place_corner()) || alpha < alpha_range.x || alpha >= alpha_range.y) discard;
  return alpha;
}
