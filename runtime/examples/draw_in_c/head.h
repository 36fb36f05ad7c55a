/* A plain head, made of the ellipsoids that hair collides with. For studio.c. */
#ifndef HEAD_H
#define HEAD_H

#include <coif.h>

#define HEAD_VERTICES (49 * 97)

/* Whether it is part of a head, and not a floor or what keeps hair in. This studio knows balls and ellipsoids. */
int head_is_shown(const coif_collider* ball);

/* Position and normal of one of HEAD_VERTICES, a little inside: hair rests on the collider itself. Head space, metres.
 */
void head_vertex(const coif_collider* ball, int vertex, float* position, float* normal);

/* Positions are attribute 0, normals 1. Uploads, draws and forgets it: a picture is drawn once. */
void head_draw(const coif_collider* ball);

#endif
