/* The C interface from one end to the other: one head, one asset, two seconds of a head that nods.
 *
 *   step_in_c bob.coif
 */
#include <coif.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static int fail(const char* what, const char* why) {
  fprintf(stderr, "step_in_c: %s: %s\n", what, why);
  return EXIT_FAILURE;
}

/* Memory at a multiple of 64, as the asset and the hair want it. */
static void* allocate(size_t bytes) { return aligned_alloc(64, (bytes + 63) / 64 * 64); }

/* The whole file, for the caller to free; null where it cannot be read. */
static void* read_file(const char* path, size_t* bytes) {
  FILE* file = fopen(path, "rb");
  void* memory = NULL;
  long end;
  if (file == NULL) return NULL;
  if (fseek(file, 0, SEEK_END) == 0 && (end = ftell(file)) > 0) {
    *bytes = (size_t)end;
    rewind(file);
    memory = allocate(*bytes);
    if (memory != NULL && fread(memory, 1, *bytes, file) != *bytes) {
      free(memory);
      memory = NULL;
    }
  }
  fclose(file);
  return memory;
}

static coif_head_pose head_at(double seconds) {
  double angle = 0.4 * sin(3.14159265 * seconds);
  coif_head_pose pose = {{0, 1.7, 0}, {0, 0, 0, 1}};
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

static int run(const void* asset, size_t asset_bytes) {
  char why[160];
  coif_hair_desc desc;
  coif_hair* hair;
  coif_status status;
  void* memory;
  size_t need;
  uint32_t last;
  if (!coif_check_asset(asset, asset_bytes, why, sizeof why)) return fail("asset", why);
  coif_hair_desc_init(&desc);
  need = coif_hair_memory_need(asset, asset_bytes, &desc);
  memory = allocate(need);
  status = memory == NULL ? COIF_MEMORY_TOO_SMALL : coif_hair_create(asset, asset_bytes, &desc, memory, need, &hair);
  if (status == COIF_OK) status = play(hair);
  if (status == COIF_OK) {
    last = coif_hair_bone_count(hair) - 1;
    printf("coif %s: %u bones in %lu bytes, '%s' moved\n", coif_version(), (unsigned)last + 1, (unsigned long)need,
           coif_hair_bone_name(hair, last));
  }
  free(memory);
  return status == COIF_OK ? EXIT_SUCCESS : fail("play", coif_describe(status));
}

int main(int argument_count, char** arguments) {
  size_t bytes = 0;
  void* asset;
  int result;
  if (argument_count != 2) return fail("usage", "step_in_c FILE.coif");
  asset = read_file(arguments[1], &bytes);
  if (asset == NULL) return fail(arguments[1], "cannot read, or empty");
  result = run(asset, bytes);
  free(asset);
  return result;
}
