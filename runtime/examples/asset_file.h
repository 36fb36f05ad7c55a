/* Memory aligned to 64 bytes, as assets and hair want it, and a file read into it. Shared by the examples in C. */
#ifndef ASSET_FILE_H
#define ASSET_FILE_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct block {
  void* from_malloc;
  unsigned char* bytes;
  size_t size;
} block;

/* `bytes` is null if there is no memory. Not every platform has aligned_alloc(). */
static inline block allocate(size_t size) {
  block made = {NULL, NULL, size};
  made.from_malloc = malloc(size + 63);
  if (made.from_malloc != NULL) made.bytes = (unsigned char*)(((uintptr_t)made.from_malloc + 63) / 64 * 64);
  return made;
}

/* The whole file; `size` is 0 if it cannot be read. */
static inline block read_file(const char* path) {
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

#endif
