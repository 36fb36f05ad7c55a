#include "host.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static EGLDisplay display = EGL_NO_DISPLAY;
static EGLContext context = EGL_NO_CONTEXT;

int host_open(void) {
  static const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
  static const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  EGLConfig config = NULL;
  EGLint found = 0;
  display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_ES_API)) return 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &found) || found == 0) return 0;
  context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

void host_close(void) {
  if (display == EGL_NO_DISPLAY) return;
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
  eglTerminate(display);
}

static void add_range(host_source* source, const char* begin, size_t length) {
  char* const longer = source->text == NULL ? NULL : realloc(source->text, source->length + length + 1);
  if (longer == NULL) free(source->text);
  source->text = longer;
  if (longer == NULL) return;
  memcpy(longer + source->length, begin, length);
  source->length += length;
  longer[source->length] = 0;
}

void host_source_add(host_source* source, const char* text) { add_range(source, text, strlen(text)); }

host_source host_source_begin(void) {
  host_source source = {NULL, 0};
  source.text = calloc(1, 1);
  host_source_add(&source,
                  "#version 300 es\n"
                  "precision highp float;\n"
                  "precision highp int;\n"
                  "precision highp sampler2D;\n");
  return source;
}

static char* read_text(const char* path) {
  char* text = NULL;
  FILE* const file = fopen(path, "rb");
  long end = 0;
  if (file == NULL) return NULL;
  if (fseek(file, 0, SEEK_END) == 0 && (end = ftell(file)) > 0) text = malloc((size_t)end + 1);
  rewind(file);
  if (text != NULL) text[fread(text, 1, (size_t)end, file)] = 0;
  fclose(file);
  return text;
}

/* The beginning of the piece's text, after the line that names it. */
static const char* find_piece(const char* text, const char* piece) {
  const size_t length = strlen(piece);
  const char* at = text;
  while ((at = strstr(at, "\n//// ")) != NULL) {
    at += 6;
    if (strncmp(at, piece, length) == 0 && (at[length] == '\n' || at[length] == ' ')) return strchr(at, '\n') + 1;
  }
  return NULL;
}

void host_source_add_piece(host_source* source, const char* folder, const char* file, const char* piece) {
  char path[1024];
  char* text;
  const char *begin, *end = NULL;
  snprintf(path, sizeof path, "%s/%s", folder, file);
  text = read_text(path);
  begin = text == NULL || piece == NULL ? text : find_piece(text, piece);
  if (begin == NULL) {
    fprintf(stderr, "%s: there is no %s\n", path, piece == NULL ? "such file" : piece);
    free(source->text);
    source->text = NULL;
  } else {
    if (piece != NULL) end = strstr(begin, "\n//// ");
    add_range(source, begin, end == NULL ? strlen(begin) : (size_t)(end + 1 - begin));
  }
  free(text);
}

static GLuint compile(GLenum stage, host_source* source) {
  const GLuint shader = glCreateShader(stage);
  const GLchar* const text = source->text == NULL ? "" : source->text;
  char log[512] = "";
  glShaderSource(shader, 1, &text, NULL);
  glCompileShader(shader);
  glGetShaderInfoLog(shader, sizeof log, NULL, log);
  if (log[0] != 0) fprintf(stderr, "%s\n", log);
  free(source->text);
  source->text = NULL;
  return shader;
}

GLuint host_link(host_source* vertex, host_source* fragment) {
  const GLuint program = glCreateProgram();
  const GLuint shaders[2] = {compile(GL_VERTEX_SHADER, vertex), compile(GL_FRAGMENT_SHADER, fragment)};
  GLint linked = GL_FALSE;
  int i;
  for (i = 0; i < 2; ++i) glAttachShader(program, shaders[i]);
  glLinkProgram(program);
  for (i = 0; i < 2; ++i) glDeleteShader(shaders[i]);
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  return linked ? program : 0;
}

static void attach(GLenum attachment, GLenum format, int width, int height) {
  GLuint buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

int host_target_create(host_target* target, int width, int height) {
  target->width = width;
  target->height = height;
  glGenFramebuffers(1, &target->framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
  attach(GL_COLOR_ATTACHMENT0, GL_RGBA16F, width, height);
  attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height);
  glViewport(0, 0, width, height);
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

float* host_target_read(const host_target* target) {
  float* const pixels = malloc(sizeof(float) * 4 * (size_t)target->width * (size_t)target->height);
  if (pixels != NULL) glReadPixels(0, 0, target->width, target->height, GL_RGBA, GL_FLOAT, pixels);
  return pixels;
}

int host_write_ppm(const char* path, const unsigned char* rgb, int width, int height) {
  const size_t bytes = 3 * (size_t)width * (size_t)height;
  FILE* const file = fopen(path, "wb");
  int is_written;
  if (file == NULL) return 0;
  is_written = fprintf(file, "P6\n%d %d\n255\n", width, height) > 0 && fwrite(rgb, 1, bytes, file) == bytes;
  return fclose(file) == 0 && is_written;
}
