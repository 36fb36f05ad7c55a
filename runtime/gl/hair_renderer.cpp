#include "gl/draw_block.h"
#include "gl/gl_functions.h"
#include "gl/stream_buffer.h"

#include <coif/renderer.h>

#include <cstdio>
#include <new>

namespace coif {
namespace {

constexpr std::uint32_t kLeastStream = 1u << 20, kMostStream = 256u << 20;
constexpr std::uint32_t kLeastLists = 64u << 10, kMostLists = 1u << 30;
constexpr std::uint32_t kLeastBlock = 16u << 10, kMostBlock = 64u << 10;  // the least: what OpenGL ES 3.0 promises
// A part of the smallest stream holds what is sent at once: a full block, or the matrices of the most bones.
static_assert(kLeastStream / StreamState::kParts >= sizeof(DrawBlock) + kMostBlock + 512);
static_assert(kLeastStream / StreamState::kParts >= sizeof(DrawBlock) + 512 + (kMaxBones + 1) * sizeof(Mat34));

bool is_valid(const RendererDesc& desc) {
  return desc.stream_bytes >= kLeastStream && desc.stream_bytes <= kMostStream && desc.block_bytes >= kLeastBlock &&
         desc.block_bytes <= kMostBlock && desc.list_bytes >= kLeastLists && desc.list_bytes <= kMostLists;
}

/// Of fragment shaders. OpenGL ES 3.1 has the kind, but may offer none to them.
std::uint32_t storage_blocks_of(const GlFunctions& gl, GLint major) {
  constexpr GLenum kMaxFragmentStorageBlocks = 0x90DA;  // OpenGL ES 3.1
  GLint minor = 0, blocks = 0;
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  if (major > 3 || minor > 0) gl.GetIntegerv(kMaxFragmentStorageBlocks, &blocks);
  return static_cast<std::uint32_t>(blocks);
}

}  // namespace

const GlFunctions& HairRenderer::functions() const {
  static_assert(sizeof(GlFunctions) <= kFunctionBytes);
  return *std::launder(reinterpret_cast<const GlFunctions*>(functions_));
}

Status HairRenderer::create(const GlLoader& loader, const RendererDesc& desc) {
  if (loader.get_proc == nullptr || !is_valid(desc)) return Status::kBadArgument;
  destroy();
  GlFunctions* gl = new (static_cast<void*>(functions_)) GlFunctions;
  if (const char* missing = load_gl_functions(loader, *gl)) {
    std::snprintf(failure_, sizeof failure_, "%s is missing; OpenGL ES 3.0 is needed", missing);
    return Status::kDriver;
  }
  // Loaders such as glvnd's return a stub for any name, so finding the functions proves little.
  GLint major = 0;
  gl->GetIntegerv(GL_MAJOR_VERSION, &major);
  if (major < 3) {
    std::snprintf(failure_, sizeof failure_, "the current context has version %d; OpenGL ES 3.0 is needed", major);
    return Status::kDriver;
  }
  storage_blocks_ = storage_blocks_of(*gl, major);
  loader_ = loader;
  list_bytes_ = desc.list_bytes;
  GLint most = 0;
  gl->GetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &most);
  const auto offered = static_cast<std::uint32_t>(most);
  block_bytes_ = (offered < desc.block_bytes ? offered : desc.block_bytes) / 16 * 16;
  StreamBuffer stream(*gl, stream_);
  if (!stream.create(desc.stream_bytes)) {
    stream.destroy();
    std::snprintf(failure_, sizeof failure_, "no memory for a stream of %u bytes", unsigned{desc.stream_bytes});
    return Status::kDriver;
  }
  created_ = true;
  return Status::kOk;
}

void HairRenderer::destroy() {
  failure_[0] = '\0';
  if (!created_) return;
  const GlFunctions& gl = functions();
  if (mode_memory_.release != nullptr) mode_memory_.release(gl, mode_memory_);
  mode_memory_ = {};
  for (const Program& program : std::span(programs_).first(program_count_)) gl.DeleteProgram(program.name);
  program_count_ = 0;
  StreamBuffer(gl, stream_).destroy();
  created_ = false;
}

}  // namespace coif
