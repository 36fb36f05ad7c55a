/* Stands for an engine in C: an OpenGL ES context, shaders from files, a picture to draw to. For draw_in_c.c. */
#ifndef HOST_H
#define HOST_H

#include <GLES3/gl3.h>

#include <stddef.h>

/* Makes an OpenGL ES 3.0 context without a window. 0 if the driver has none. */
int host_open(void);
void host_close(void);

/* A shader's text, put together from pieces of files. Begins with the version and the precision that hair needs. */
typedef struct host_source {
  char* text; /* Null once anything failed. */
  size_t length;
} host_source;

host_source host_source_begin(void);
void host_source_add(host_source* source, const char* text);
/* Adds the text of folder/file after the line `//// piece`, up to the next such line; the whole file if `piece` is
 * null. */
void host_source_add_piece(host_source* source, const char* folder, const char* file, const char* piece);
/* Links both shaders to a program and frees their texts. 0 on failure, with the driver's reason on stderr. */
GLuint host_link(host_source* vertex, host_source* fragment);

/* Linear colour in half floats, and depth. */
typedef struct host_target {
  GLuint framebuffer;
  int width, height;
} host_target;

/* Makes a target and binds it. 0 if the driver cannot draw to half floats. */
int host_target_create(host_target* target, int width, int height);
/* Four floats a pixel, the lowest row first. The caller frees them; null if there is no memory. */
float* host_target_read(const host_target* target);

/* `rgb`: three bytes a pixel, the highest row first. 0 if the file cannot be written. */
int host_write_ppm(const char* path, const unsigned char* rgb, int width, int height);

#endif
