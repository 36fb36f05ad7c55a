// Lists of soft texels, one for each pixel, in the layout of ListHead in runtime/gl/transparency/exact_lists.cpp.
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
