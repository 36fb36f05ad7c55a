// Sorts a pixel's list and blends it from far to near. After fragment_lists.glsl. The nearest texel behind the last one is
// looked for again and again: lists are a few dozen long, may be longer, and nothing has to be kept.
out vec4 fragment;

// Whether a is blended before b. Nodes lie in a list as they arrived, which differs from run to run; so the last word
// have colours, and what is equal in everything may go in any order.
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
