/* A plain head, made of the ellipsoids that hair collides with. For studio.c. */
#ifndef HEAD_H
#define HEAD_H

#include <coif.h>

#define HEAD_VERTICES (49 * 97)

/* Whether the collider is part of a head, not a floor or one that keeps hair inside. Knows spheres and ellipsoids. */
int head_is_shown(const coif_collider* ball);

/* Position and normal of one of HEAD_VERTICES. Head space, metres; a little inside the collider, where hair rests. */
void head_vertex(const coif_collider* ball, int vertex, float* position, float* normal);

/* Attribute 0 is the position, 1 the normal. Uploads, draws and deletes the mesh, since a picture is drawn once. */
void head_draw(const coif_collider* ball);

#endif
