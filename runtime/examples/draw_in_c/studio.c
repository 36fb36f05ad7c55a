#include "studio.h"

#include "head.h"
#include "host.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* Key, fill and rim: the direction in the camera's axes (right, up, back), and the linear colour. */
static const float lights[STUDIO_LIGHTS][2][3] = {{{-0.3f, 1.0f, 0.2f}, {1.2f, 1.17f, 1.12f}},
                                                  {{0.4f, -0.3f, 1.0f}, {0.22f, 0.23f, 0.25f}},
                                                  {{0.9f, 0.1f, -0.6f}, {0.15f, 0.17f, 0.22f}}};

static double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* The points that have to be in the picture, in the camera's axes. */
typedef struct frame {
  double axes[3][3]; /* right, up, back */
  double low[3], high[3];
  double (*points)[3];
  size_t count;
} frame;

static void add_point(frame* seen, const float* position) {
  const double p[3] = {position[0], position[1], position[2]};
  double* const to = seen->points[seen->count];
  int i;
  for (i = 0; i < 3; ++i) {
    to[i] = dot(seen->axes[i], p);
    if (seen->count == 0 || to[i] < seen->low[i]) seen->low[i] = to[i];
    if (seen->count == 0 || to[i] > seen->high[i]) seen->high[i] = to[i];
  }
  ++seen->count;
}

static int add_points(frame* seen, const coif_asset* asset) {
  uint32_t vertices = 0, balls = 0, i;
  int at;
  float position[3], normal[3];
  const coif_vertex* const vertex = coif_asset_vertices(asset, &vertices);
  const coif_collider* const ball = coif_asset_colliders(asset, &balls);
  seen->points = malloc(sizeof *seen->points * (vertices + (size_t)balls * HEAD_VERTICES));
  if (seen->points == NULL || vertices == 0) return 0;
  for (i = 0; i < vertices; ++i) add_point(seen, vertex[i].position);
  for (i = 0; i < balls; ++i) {
    for (at = 0; head_is_shown(&ball[i]) && at < HEAD_VERTICES; ++at) {
      head_vertex(&ball[i], at, position, normal);
      add_point(seen, position);
    }
  }
  return 1;
}

/* The least distance from which all points are seen within half angles of these tangents, plus a border of 8 %. */
static double distance_to(const frame* seen, const double* center, double tan_x, double tan_y) {
  double distance = 0;
  size_t i;
  for (i = 0; i < seen->count; ++i) {
    const double x = seen->points[i][0] - center[0], y = seen->points[i][1] - center[1];
    const double z = seen->points[i][2] - center[2];
    distance = fmax(distance, fmax(fabs(x) / tan_x, fabs(y) / tan_y) + z);
  }
  return 1.08 * distance;
}

static void place_camera(coif_draw_view* view, const frame* seen, double aspect) {
  const double tan_short = tan(0.5 * 30 * pi / 180);
  const double tan_x = tan_short * fmax(aspect, 1), tan_y = tan_short / fmin(aspect, 1);
  double center[3], size[3], at[3], clip[4][4] = {{0}};
  double distance, depth, near_plane, far_plane;
  int i, row, column;
  for (i = 0; i < 3; ++i) {
    center[i] = 0.5 * (seen->low[i] + seen->high[i]);
    size[i] = seen->high[i] - seen->low[i];
  }
  distance = distance_to(seen, center, tan_x, tan_y);
  depth = size[2] + sqrt(size[0] * size[0] + size[1] * size[1]);
  near_plane = fmax(distance - depth, 0.02 * distance);
  far_plane = distance + depth;
  for (i = 0; i < 3; ++i) at[i] = center[i] + (i == 2 ? distance : 0);
  for (column = 0; column < 3; ++column) {
    const double x = seen->axes[0][column], y = seen->axes[1][column], z = seen->axes[2][column];
    clip[0][column] = x / tan_x;
    clip[1][column] = y / tan_y;
    clip[2][column] = z * (near_plane + far_plane) / (near_plane - far_plane);
    clip[3][column] = -z;
  }
  clip[0][3] = -at[0] / tan_x;
  clip[1][3] = -at[1] / tan_y;
  clip[2][3] = (2 * near_plane * far_plane - at[2] * (near_plane + far_plane)) / (near_plane - far_plane);
  clip[3][3] = at[2];
  for (row = 0; row < 4; ++row) {
    for (column = 0; column < 4; ++column) view->clip_from_world[4 * column + row] = (float)clip[row][column];
  }
  view->eye.x = (float)(seen->axes[0][0] * at[0] + seen->axes[1][0] * at[1] + seen->axes[2][0] * at[2]);
  view->eye.y = (float)(seen->axes[0][1] * at[0] + seen->axes[1][1] * at[1] + seen->axes[2][1] * at[2]);
  view->eye.z = (float)(seen->axes[0][2] * at[0] + seen->axes[1][2] * at[1] + seen->axes[2][2] * at[2]);
}

static void place_lights(studio* made, const frame* seen) {
  int i, k;
  for (i = 0; i < STUDIO_LIGHTS; ++i) {
    float from[3];
    const float *const towards = lights[i][0], *const color = lights[i][1];
    for (k = 0; k < 3; ++k) {
      from[k] = (float)(seen->axes[0][k] * towards[0] + seen->axes[1][k] * towards[1] + seen->axes[2][k] * towards[2]);
    }
    coif_light_init(&made->lights[i]);
    made->lights[i].from = (coif_vec3){from[0], from[1], from[2]};
    made->lights[i].color = (coif_vec3){color[0], color[1], color[2]};
  }
  made->view.lights = made->lights;
  made->view.light_count = STUDIO_LIGHTS;
}

static unsigned link_backdrop(void) {
  host_source vertex = host_source_begin(), fragment = host_source_begin();
  host_source_add(&vertex,
                  "out float height;\n"
                  "void main() {  // one triangle that covers the picture\n"
                  "  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
                  "  height = 0.5 * corner.y + 0.5;\n"
                  "  gl_Position = vec4(corner, 0.0, 1.0);\n"
                  "}\n");
  host_source_add(&fragment,
                  "in float height;\n"
                  "out vec4 fragment;\n"
                  "void main() {\n"
                  "  vec3 bottom = vec3(0.36, 0.36, 0.37), top = vec3(0.17, 0.19, 0.22);\n"
                  "  fragment = vec4(mix(bottom, top, smoothstep(0.0, 1.0, height)), 1.0);\n"
                  "}\n");
  return host_link(&vertex, &fragment);
}

static unsigned link_head(void) {
  host_source vertex = host_source_begin(), fragment = host_source_begin();
  host_source_add(&vertex,
                  "uniform mat4 clip_from_world;\n"
                  "layout(location = 0) in vec3 position;\n"
                  "layout(location = 1) in vec3 out_of_head;\n"
                  "out vec3 normal;\n"
                  "void main() {\n"
                  "  normal = out_of_head;\n"
                  "  gl_Position = clip_from_world * vec4(position, 1.0);\n"
                  "}\n");
  host_source_add(
      &fragment,
      "uniform vec3 towards[3];\n"
      "uniform vec3 color[3];\n"
      "in vec3 normal;\n"
      "out vec4 fragment;\n"
      "void main() {  // clay\n"
      "  vec3 light = vec3(0.12), n = normalize(gl_FrontFacing ? normal : -normal);\n"
      "  for (int i = 0; i < 3; ++i) light += color[i] * max(0.75 * dot(n, normalize(towards[i])) + 0.25, 0.0);\n"
      "  fragment = vec4(vec3(0.42, 0.33, 0.28) * light, 1.0);\n"
      "}\n");
  return host_link(&vertex, &fragment);
}

int studio_create(studio* made, const coif_asset* asset, double yaw, double pitch, double aspect) {
  const coif_skeleton* const skeleton = coif_asset_skeleton(asset);
  frame seen = {{{0}}, {0}, {0}, NULL, 0};
  int is_seen;
  if (skeleton == NULL) return 0;
  yaw = (yaw + ((skeleton->flags & COIF_FACES_BACKWARDS) != 0 ? 180 : 0)) * pi / 180;
  pitch *= pi / 180;
  seen.axes[0][0] = cos(yaw), seen.axes[0][2] = -sin(yaw);
  seen.axes[2][0] = sin(yaw) * cos(pitch), seen.axes[2][1] = sin(pitch), seen.axes[2][2] = cos(yaw) * cos(pitch);
  seen.axes[1][0] = -sin(yaw) * sin(pitch), seen.axes[1][1] = cos(pitch), seen.axes[1][2] = -cos(yaw) * sin(pitch);
  coif_draw_view_init(&made->view);
  made->view.framebuffer_is_srgb = 1; /* Ours is linear: nothing for the shader to encode. */
  is_seen = add_points(&seen, asset);
  if (is_seen) {
    place_camera(&made->view, &seen, aspect);
    place_lights(made, &seen);
  }
  free(seen.points);
  made->backdrop_program = link_backdrop();
  made->head_program = link_head();
  return is_seen && made->backdrop_program != 0 && made->head_program != 0;
}

void studio_draw(const studio* drawn, const coif_asset* asset) {
  uint32_t balls = 0, i;
  const coif_collider* const ball = coif_asset_colliders(asset, &balls);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  glUseProgram(drawn->backdrop_program);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glUseProgram(drawn->head_program);
  glUniformMatrix4fv(glGetUniformLocation(drawn->head_program, "clip_from_world"), 1, GL_FALSE,
                     drawn->view.clip_from_world);
  for (i = 0; i < STUDIO_LIGHTS; ++i) {
    const char *const towards[] = {"towards[0]", "towards[1]", "towards[2]"}, *const color[] = {"color[0]", "color[1]",
                                                                                                "color[2]"};
    glUniform3fv(glGetUniformLocation(drawn->head_program, towards[i]), 1, &drawn->lights[i].from.x);
    glUniform3fv(glGetUniformLocation(drawn->head_program, color[i]), 1, &drawn->lights[i].color.x);
  }
  for (i = 0; i < balls; ++i) {
    if (head_is_shown(&ball[i])) head_draw(&ball[i]);
  }
}

/* Adds the sample to `sum`. Light above three quarters of white approaches white without reaching it; hues stay. */
static void add_shown(const float* sample, double* sum) {
  const double shoulder = 0.75, room = 1 - shoulder;
  const double most = fmaxf(sample[0], fmaxf(sample[1], sample[2]));
  const double share = most > shoulder ? (shoulder + room * (1 - exp((shoulder - most) / room))) / most : 1;
  int i;
  for (i = 0; i < 3; ++i) sum[i] += share * fmax(sample[i], 0);
}

static unsigned char encode(double linear) {
  const double c = fmin(fmax(linear, 0), 1);
  return (unsigned char)lround(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - 0.055));
}

void studio_develop(const float* samples, int width, int height, int finer, unsigned char* rgb) {
  int x, y, i;
  for (y = 0; y < height; ++y) {
    for (x = 0; x < width; ++x) {
      double sum[3] = {0, 0, 0};
      for (i = 0; i < finer * finer; ++i) {
        const int row = (height - 1 - y) * finer + i / finer, column = x * finer + i % finer;
        add_shown(samples + 4 * ((size_t)row * (size_t)(width * finer) + (size_t)column), sum);
      }
      for (i = 0; i < 3; ++i) *rgb++ = encode(sum[i] / (finer * finer));
    }
  }
}
