/* Where `coif render` takes its pictures, in C: its camera, its lights, what is behind the hair and in it, and how
 * linear light becomes a picture. For draw_in_c.c, whose pictures can be compared with those. */
#ifndef STUDIO_H
#define STUDIO_H

#include <coif.h>

#define STUDIO_LIGHTS 3

typedef struct studio {
  coif_draw_view view; /* Refers to `lights`: do not copy. */
  coif_light lights[STUDIO_LIGHTS];
  unsigned head_program, backdrop_program;
} studio;

/* The head at the world's origin, seen from `yaw` degrees off its face and `pitch` degrees above; as near as the hair
 * and the head's ellipsoids allow. 0 where there is nothing to see, or the driver refuses. The context is current. */
int studio_create(studio* made, const coif_asset* asset, double yaw, double pitch, double aspect);

/* Backdrop and head, into the framebuffer that is bound; clears its depth. */
void studio_draw(const studio* drawn, const coif_asset* asset);

/* Linear light, `finer` samples of a pixel each way, the lowest row first, becomes bytes of sRGB, the highest row
 * first. */
void studio_develop(const float* samples, int width, int height, int finer, unsigned char* rgb);

#endif
