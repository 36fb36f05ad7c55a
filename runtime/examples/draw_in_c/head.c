#include "head.h"

#include <GLES3/gl3.h>

#include <math.h>
#include <stddef.h>

#define RINGS 48
#define SECTORS 96
#define ROW (SECTORS + 1)
#define INDICES (6 * RINGS * SECTORS)

int head_is_shown(const coif_collider* ball) {
  const int is_ball = ball->shape == COIF_SPHERE || ball->shape == COIF_ELLIPSOID;
  const float* const r = ball->radii;
  return is_ball && (ball->flags & COIF_KEEPS_INSIDE) == 0 && r[0] < 0.5f && r[1] < 0.5f && r[2] < 0.5f;
}

static void rotate(const float* q, const float* v, float* out) {
  const float t[3] = {2 * (q[1] * v[2] - q[2] * v[1]), 2 * (q[2] * v[0] - q[0] * v[2]),
                      2 * (q[0] * v[1] - q[1] * v[0])};
  out[0] = v[0] + q[3] * t[0] + q[1] * t[2] - q[2] * t[1];
  out[1] = v[1] + q[3] * t[1] + q[2] * t[0] - q[0] * t[2];
  out[2] = v[2] + q[3] * t[2] + q[0] * t[1] - q[1] * t[0];
}

void head_vertex(const coif_collider* ball, int vertex, float* position, float* normal) {
  const double pi = 3.14159265358979323846;
  const int ring = vertex / ROW;
  const double polar = pi * ring / RINGS, around = 2 * pi * (vertex % ROW) / SECTORS;
  const double unit[3] = {sin(polar) * sin(around), cos(polar), sin(polar) * cos(around)};
  float at[3], out[3], length;
  int i;
  for (i = 0; i < 3; ++i) {
    const double radius = 0.98 * ball->radii[i];
    at[i] = (float)(unit[i] * radius);
    out[i] = (float)(unit[i] / radius);
  }
  rotate(ball->rotation, at, position);
  rotate(ball->rotation, out, normal);
  length = sqrtf(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  for (i = 0; i < 3; ++i) {
    position[i] += ball->center[i];
    normal[i] /= length;
  }
}

void head_draw(const coif_collider* ball) {
  static float vertices[HEAD_VERTICES][6];
  static GLushort indices[INDICES];
  GLuint array = 0, buffers[2] = {0, 0};
  GLushort* next = indices;
  int ring, sector, i;
  for (i = 0; i < HEAD_VERTICES; ++i) {
    head_vertex(ball, i, &vertices[i][0], &vertices[i][3]);
  }
  for (ring = 0; ring < RINGS; ++ring) {
    for (sector = 0; sector < SECTORS; ++sector) {
      const int a = ring * ROW + sector, b = a + ROW, corners[6] = {a, b, b + 1, a, b + 1, a + 1};
      for (i = 0; i < 6; ++i) *next++ = (GLushort)corners[i];
    }
  }
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
  for (i = 0; i < 2; ++i) {
    glVertexAttribPointer((GLuint)i, 3, GL_FLOAT, GL_FALSE, sizeof vertices[0],
                          (const void*)(3 * sizeof(float) * (size_t)i));
    glEnableVertexAttribArray((GLuint)i);
  }
  glDrawElements(GL_TRIANGLES, INDICES, GL_UNSIGNED_SHORT, NULL);
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &array);
  glDeleteBuffers(2, buffers);
}
