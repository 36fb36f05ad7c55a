#include "research/exact.h"

#include "gl/shader_programs.h"
#include "gl/textures.h"

#include <hair_shaders.h>

#include <cstdio>
#include <cstring>

namespace coif {
namespace {

constexpr std::uint32_t kStorageBlocks = 2;
constexpr std::uint32_t kNodeBytes = 5 * sizeof(std::uint32_t);

/// The beginning of ListHeads in shaders/exact.glsl; the heads follow.
struct ListHead {
  std::uint32_t count;
  std::uint32_t capacity;
  std::int32_t left, bottom, width;
};

GLuint make_buffer(const GlFunctions& gl, GLsizeiptr bytes, GLenum usage) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  gl.BufferData(GL_SHADER_STORAGE_BUFFER, bytes, nullptr, usage);
  gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  return buffer;
}

GLsizeiptr head_bytes(std::uint32_t pixels) {
  return static_cast<GLsizeiptr>(sizeof(ListHead) + std::size_t{pixels} * sizeof(std::uint32_t));
}

bool build_resolve(const ModeDraw& draw, ListMemory& lists) {
  constexpr const char* kVertex[] = {kShaderListResolveVert};
  constexpr const char* kFragment[] = {kShaderFragmentListsGlsl, kShaderListResolveFrag};
  if (lists.program == 0)
    lists.program = build_program(draw.renderer.gl, kGlsl310, kVertex, kFragment, draw.renderer.failure);
  return lists.program != 0;
}

/// Empties all lists.
bool clear(const GlFunctions& gl, const PixelArea& area, const ListMemory& lists) {
  gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, lists.heads);
  const GLsizeiptr bytes = head_bytes(static_cast<std::uint32_t>(area.width * area.height));
  void* const memory =
      gl.MapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
  if (memory == nullptr) return false;
  std::memset(memory, 0, static_cast<std::size_t>(bytes));
  const ListHead head{0, lists.capacity, area.left, area.bottom, area.width};
  std::memcpy(memory, &head, sizeof head);
  gl.UnmapBuffer(GL_SHADER_STORAGE_BUFFER);
  return true;
}

/// Waits until the lists are written. False where they cannot be read.
bool read_count(const GlFunctions& gl, const ListMemory& lists, std::uint32_t& count) {
  gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, lists.heads);
  const void* const memory = gl.MapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, sizeof count, GL_MAP_READ_BIT);
  if (memory == nullptr) return false;
  std::memcpy(&count, memory, sizeof count);
  gl.UnmapBuffer(GL_SHADER_STORAGE_BUFFER);
  return true;
}

void resolve(const GlFunctions& gl, const ExactMemory& memory) {
  gl.Enable(GL_BLEND);  // As in set_draw_state(): the lists hold premultiplied colours.
  gl.Disable(GL_DEPTH_TEST);
  gl.Disable(GL_CULL_FACE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.UseProgram(memory.lists.program);
  memory.functions.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.Enable(GL_DEPTH_TEST);
}

Listed fill_and_resolve(const ModeDraw& draw, const PassList& listed, const ExactMemory& memory) {
  if (!draw.crowd.draw(listed)) return Listed::kDriver;
  memory.memory_barrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  std::uint32_t count = 0;
  if (!read_count(draw.renderer.gl, memory.lists, count)) return Listed::kDriver;
  if (count > memory.lists.capacity) return Listed::kOverflow;
  if (count > 0) resolve(draw.renderer.gl, memory);
  return Listed::kDrawn;
}

}  // namespace

const FragmentCode kListCode = {.id = 4,
                                .keep = kShaderKeepRangeGlsl,
                                .output = kShaderListOutputGlsl,
                                .shared = kShaderFragmentListsGlsl,
                                .vertex = "#define COIF_CORNER\n",
                                .storage_blocks = kStorageBlocks};

bool has_lists(const ModeDraw& draw, const ExactMemory& memory) {
  return draw.renderer.storage_blocks >= kStorageBlocks && memory.memory_barrier != nullptr;
}

bool make_lists(const ModeDraw& draw, const PixelArea& area, ListMemory& lists) {
  const GlFunctions& gl = draw.renderer.gl;
  const auto pixels = static_cast<std::uint32_t>(area.width * area.height);
  if (!build_resolve(draw, lists)) return false;
  if (lists.nodes != 0 && pixels <= lists.pixels) return true;
  clear_errors(gl);
  if (lists.nodes == 0) {
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    const auto offered = static_cast<std::uint32_t>(most);
    lists.capacity = (offered < draw.renderer.list_bytes ? offered : draw.renderer.list_bytes) / kNodeBytes;
    lists.nodes = make_buffer(gl, static_cast<GLsizeiptr>(lists.capacity) * GLsizeiptr{kNodeBytes}, GL_DYNAMIC_COPY);
  }
  gl.DeleteBuffers(1, &lists.heads);
  lists.heads = make_buffer(gl, head_bytes(pixels), GL_DYNAMIC_READ);
  lists.pixels = pixels;
  if (gl.GetError() == GL_NO_ERROR) return true;
  std::snprintf(draw.renderer.failure, sizeof draw.renderer.failure, "no memory for lists of %u texels",
                unsigned{lists.capacity});
  release(gl, lists);
  return false;
}

Listed draw_lists(const ModeDraw& draw, const PassList& listed, const PixelArea& area, ExactMemory& memory) {
  const GlFunctions& gl = draw.renderer.gl;
  if (!clear(gl, area, memory.lists)) return Listed::kDriver;
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kListHeadIndex, memory.lists.heads);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kListNodeIndex, memory.lists.nodes);
  const Listed listed_all = fill_and_resolve(draw, listed, memory);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kListHeadIndex, 0);
  gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, kListNodeIndex, 0);
  gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  return listed_all;
}

void release(const GlFunctions& gl, ListMemory& lists) {
  gl.DeleteBuffers(1, &lists.heads);
  gl.DeleteBuffers(1, &lists.nodes);
  if (lists.program != 0) gl.DeleteProgram(lists.program);
  lists = {};
}

}  // namespace coif
