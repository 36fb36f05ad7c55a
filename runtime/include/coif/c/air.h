#ifndef COIF_C_AIR_H
#define COIF_C_AIR_H
/* The air around heads, pushes, sets of dynamics that heads choose from; a part of coif.h, which hosts include. The
 * rules are those of the methods of coif::Hair of that name (coif/hair.h, coif/air.h). */

#include <coif/c/types.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The air around one head. Needs COIF_SOLVER_CHARACTER and coif_hair_desc.has_own_air, else COIF_NOT_ASKED. */
typedef struct coif_head_air {
  coif_vec3 wind; /* added to the settings' wind, world, m/s */
  float exposure; /* 0..1, share of the settings' wind and the gusts that reaches the head */
} coif_head_air;
void coif_head_air_init(coif_head_air* air);
coif_status coif_hair_set_air(coif_hair* hair, uint32_t instance, const coif_head_air* air);

/* Gusts for the whole crowd. Needs COIF_SOLVER_CHARACTER and coif_hair_desc.feels_gusts, else COIF_NOT_ASKED. */
typedef struct coif_gusts {
  float amplitude; /* m/s; 0: none */
  float length;    /* metres */
  float speed;     /* m/s */
  coif_vec3 direction;
  uint32_t seed;
} coif_gusts;
void coif_gusts_init(coif_gusts* gusts);
coif_status coif_hair_set_gusts(coif_hair* hair, const coif_gusts* gusts);
/* How far the gusts' air has come, metres. */
double coif_hair_gusts_way(const coif_hair* hair);
/* The air of the same gusts at a world place, for the host's own cloth and grass, m/s. */
coif_vec3 coif_gust_at(const coif_gusts* gusts, double way, const double place[3]);

/* Factors on the asset's dynamics: sets below coif_hair_desc.dynamics_sets. Each head chooses one of them. */
coif_status coif_hair_set_dynamics(coif_hair* hair, uint32_t set, float stiffness, float damping, float friction);
coif_status coif_hair_choose_dynamics(coif_hair* hair, uint32_t instance, uint32_t set);

/* Changes the hair's speed at once in a ball, or in a capsule where `axis` is not zero; world. */
typedef struct coif_impulse {
  double center[3];
  coif_vec3 axis;
  float radius;
  float speed;        /* m/s, away from the middle */
  coif_vec3 velocity; /* m/s */
  uint32_t strokes;   /* 1: the hair takes on `velocity`; 0: it is added */
} coif_impulse;
void coif_impulse_init(coif_impulse* impulse);
coif_status coif_hair_push(coif_hair* hair, uint32_t instance, const coif_impulse* impulse);

#ifdef __cplusplus
}
#endif
#endif
