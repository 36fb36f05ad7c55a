/* A file in memory that begins at a multiple of 64, as the asset and the hair want it: what the examples in C share. */
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

/* Null bytes where there is no memory; aligned_alloc() is not everywhere. */
static inline block allocate(size_t size) {
  block made = {NULL, NULL, size};
  made.from_malloc = malloc(size + 63);
  if (made.from_malloc != NULL) made.bytes = (unsigned char*)(((uintptr_t)made.from_malloc + 63) / 64 * 64);
  return made;
}

/* The whole file; of no bytes where it cannot be read. */
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
