/* Uses the whole C interface of the simulation: three heads, one asset, two seconds of nodding. Prints a hash of all
 * matrices of all frames, which is the same in every language (step_in_csharp.cs) and on every processor.
 *
 *   step_in_c bob.coif
 */
#include "asset_file.h"

#include <coif.h>

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { HEADS = 3, FRAMES = 120 };

static int fail(const char* what, const char* why) {
  fprintf(stderr, "step_in_c: %s: %s\n", what, why);
  return EXIT_FAILURE;
}

/* Nods, each head a little later than the one before. Does without sine and cosine, whose last bit differs between
 * libraries. */
static coif_head_pose head_at(int frame, int head) {
  double seconds = frame / 60.0 - 0.1 * head, part = seconds - floor(seconds);
  double tangent = 3.2 * part * (1 - part) * (0.5 - part), cosine = 1 / sqrt(1 + tangent * tangent);
  coif_head_pose pose;
  coif_head_pose_init(&pose);
  pose.position[0] = head;
  pose.position[1] = 1.7;
  pose.rotation[0] = (float)(tangent * cosine);
  pose.rotation[3] = (float)cosine;
  return pose;
}

/* FNV-1a */
static uint64_t hash_of(uint64_t hash, const void* data, size_t bytes) {
  const unsigned char* byte = data;
  for (; bytes > 0; --bytes, ++byte) hash = (hash ^ *byte) * 1099511628211u;
  return hash;
}

static coif_status play(coif_hair* hair, uint64_t* hash) {
  int frame, head;
  coif_head_pose poses[HEADS];
  coif_step_settings settings;
  coif_status status = COIF_OK;
  const size_t palette_bytes = coif_hair_bone_count(hair) * sizeof(coif_mat34);
  coif_step_settings_init(&settings);
  *hash = 14695981039346656037u;
  for (head = 0; head < HEADS && status == COIF_OK; ++head) {
    poses[head] = head_at(0, head);
    status = coif_hair_reset(hair, (uint32_t)head, &poses[head]);
  }
  for (frame = 1; frame <= FRAMES && status == COIF_OK; ++frame) {
    for (head = 0; head < HEADS; ++head) poses[head] = head_at(frame, head);
    status = coif_hair_set_heads(hair, poses, HEADS);
    if (status == COIF_OK) status = coif_hair_step(hair, &settings);
    for (head = 0; head < HEADS; ++head) *hash = hash_of(*hash, coif_hair_palette(hair, (uint32_t)head), palette_bytes);
  }
  return status;
}

static int run(const block* asset) {
  char why[160];
  coif_hair_desc desc;
  coif_hair* hair;
  coif_status status = COIF_MEMORY_TOO_SMALL;
  block memory;
  uint32_t last;
  uint64_t hash = 0;
  if (!coif_check_asset(asset->bytes, asset->size, why, sizeof why)) return fail("asset", why);
  coif_hair_desc_init(&desc);
  desc.instances = HEADS;
  memory = allocate(coif_hair_memory_need(asset->bytes, asset->size, &desc));
  if (memory.bytes != NULL) {
    status = coif_hair_create(asset->bytes, asset->size, &desc, memory.bytes, memory.size, &hair);
  }
  if (status == COIF_OK) status = play(hair, &hash);
  if (status == COIF_OK) {
    last = coif_hair_bone_count(hair) - 1;
    printf("coif %s: %u bones in %lu bytes, '%s' moved\n", coif_version(), (unsigned)last + 1,
           (unsigned long)memory.size, coif_hair_bone_name(hair, last));
    printf("matrices %08lx%08lx\n", (unsigned long)(hash >> 32), (unsigned long)(hash & 0xFFFFFFFFu));
  }
  free(memory.from_malloc);
  return status == COIF_OK ? EXIT_SUCCESS : fail("play", coif_describe(status));
}

int main(int argument_count, char** arguments) {
  block asset;
  int result;
  if (argument_count != 2) return fail("usage", "step_in_c FILE.coif");
  asset = read_file(arguments[1]);
  result = asset.size > 0 ? run(&asset) : fail(arguments[1], "cannot read, or empty");
  free(asset.from_malloc);
  return result;
}
