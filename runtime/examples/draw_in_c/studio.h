/* The studio of `coif render`, in C: camera, lights, backdrop, head, and how linear light becomes a picture. So the
 * pictures of draw_in_c.c can be compared with those of `coif render`. */
#ifndef STUDIO_H
#define STUDIO_H

#include <coif.h>

#define STUDIO_LIGHTS 3

typedef struct studio {
  coif_draw_view view; /* Refers to `lights`: do not copy. */
  coif_light lights[STUDIO_LIGHTS];
  unsigned head_program, backdrop_program;
} studio;

/* The head is at the world's origin, seen from `yaw` degrees off its face and `pitch` degrees above, as near as the
 * hair and the head's ellipsoids allow. The context has to be current. 0 if there is nothing to see or the driver
 * refuses. */
int studio_create(studio* made, const coif_asset* asset, double yaw, double pitch, double aspect);

/* Draws backdrop and head into the bound framebuffer, and clears its depth. */
void studio_draw(const studio* drawn, const coif_asset* asset);

/* Turns linear light, with `finer` samples of a pixel each way and the lowest row first, into bytes of sRGB with the
 * highest row first. */
void studio_develop(const float* samples, int width, int height, int finer, unsigned char* rgb);

#endif
