/* The C interface from one end to the other: one head, one asset, two seconds of a head that nods.
 *
 *   step_in_c bob.coif
 */
#include <coif.h>

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static int fail(const char* what, const char* why) {
  fprintf(stderr, "step_in_c: %s: %s\n", what, why);
  return EXIT_FAILURE;
}

/* Memory that begins at a multiple of 64, as the asset and the hair want it; aligned_alloc() is not everywhere. */
typedef struct block {
  void* from_malloc;
  unsigned char* bytes;
  size_t size;
} block;

static block allocate(size_t size) {
  block made = {NULL, NULL, size};
  made.from_malloc = malloc(size + 63);
  if (made.from_malloc != NULL) made.bytes = (unsigned char*)(((uintptr_t)made.from_malloc + 63) / 64 * 64);
  return made;
}

/* The whole file; of no bytes where it cannot be read. */
static block read_file(const char* path) {
  block content = {NULL, NULL, 0};
  FILE* file = fopen(path, "rb");
  long end;
  if (file == NULL) return content;
  if (fseek(file, 0, SEEK_END) == 0 && (end = ftell(file)) > 0) {
    rewind(file);
    content = allocate((size_t)end);
    if (content.bytes == NULL || fread(content.bytes, 1, content.size, file) != content.size) content.size = 0;
  }
  fclose(file);
  return content;
}

static coif_head_pose head_at(double seconds) {
  double angle = 0.4 * sin(3.14159265 * seconds);
  coif_head_pose pose = {{0, 1.7, 0}, {0, 0, 0, 1}, 1, 0};
  pose.rotation[0] = (float)sin(angle / 2);
  pose.rotation[3] = (float)cos(angle / 2);
  return pose;
}

static coif_status play(coif_hair* hair) {
  int frame;
  coif_step_settings settings;
  coif_head_pose pose = head_at(0);
  coif_status status = coif_hair_reset(hair, 0, &pose);
  coif_step_settings_init(&settings);
  for (frame = 1; frame <= 120 && status == COIF_OK; ++frame) {
    pose = head_at(frame / 60.0);
    status = coif_hair_set_head(hair, 0, &pose);
    if (status == COIF_OK) status = coif_hair_step(hair, &settings);
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
  if (!coif_check_asset(asset->bytes, asset->size, why, sizeof why)) return fail("asset", why);
  coif_hair_desc_init(&desc);
  memory = allocate(coif_hair_memory_need(asset->bytes, asset->size, &desc));
  if (memory.bytes != NULL) {
    status = coif_hair_create(asset->bytes, asset->size, &desc, memory.bytes, memory.size, &hair);
  }
  if (status == COIF_OK) status = play(hair);
  if (status == COIF_OK) {
    last = coif_hair_bone_count(hair) - 1;
    printf("coif %s: %u bones in %lu bytes, '%s' moved\n", coif_version(), (unsigned)last + 1,
           (unsigned long)memory.size, coif_hair_bone_name(hair, last));
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
