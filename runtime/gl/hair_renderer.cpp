#include "gl/renderer_state.h"

#include <cstdio>
#include <new>

namespace coif {
namespace {

constexpr std::uint32_t kLeastStream = 1u << 20, kMostStream = 256u << 20;
constexpr std::uint32_t kLeastLists = 64u << 10, kMostLists = 1u << 30;
constexpr std::uint32_t kLeastBlock = 16u << 10, kMostBlock = 64u << 10;  // OpenGL ES 3.0 promises the smaller one.
// A part of the smallest stream must hold everything that is sent at once: a full block, or the matrices of the most
// bones.
static_assert(kLeastStream / StreamBuffer::kParts >= sizeof(DrawBlock) + kMostBlock + 512);
static_assert(kLeastStream / StreamBuffer::kParts >= sizeof(DrawBlock) + 512 + (kMaxBones + 1) * sizeof(Mat34));

bool is_valid(const RendererDesc& desc) {
  if (desc.webgl != nullptr && desc.scratch.size() < desc.stream_bytes / StreamBuffer::kParts) return false;
  return desc.stream_bytes >= kLeastStream && desc.stream_bytes <= kMostStream && desc.block_bytes >= kLeastBlock &&
         desc.block_bytes <= kMostBlock && desc.list_bytes >= kLeastLists && desc.list_bytes <= kMostLists;
}

/// How many storage blocks fragment shaders may have. OpenGL ES 3.1 has storage blocks, but fragment shaders may get
/// none.
std::uint32_t storage_blocks_of(const GlFunctions& gl, GLint major, GLint minor) {
  constexpr GLenum kMaxFragmentStorageBlocks = 0x90DA;  // OpenGL ES 3.1
  GLint blocks = 0;
  if (major > 3 || minor > 0) gl.GetIntegerv(kMaxFragmentStorageBlocks, &blocks);
  return static_cast<std::uint32_t>(blocks);
}

}  // namespace

void clear_errors(const GlFunctions& gl) {
  // A lost context may report an error for ever. There are fewer than 16 kinds of error.
  for (int i = 0; i < 16 && gl.GetError() != GL_NO_ERROR; ++i) {
  }
}

Status HairRenderer::create(const GlLoader& loader, const RendererDesc& desc) {
  static_assert(sizeof(RendererState) <= kStateBytes && alignof(RendererState) <= alignof(void*));
  if (loader.get_proc == nullptr || !is_valid(desc)) return Status::kBadArgument;
  destroy();
  state_ = new (static_cast<void*>(room_)) RendererState;
  RendererState& state = *state_;
  const GlFunctions& gl = state.gl;
  if (const char* missing = state.gl.load(loader, desc.webgl == nullptr)) {
    std::snprintf(state.failure, sizeof state.failure, "%s is missing; OpenGL ES 3.0 is needed", missing);
    return Status::kDriver;
  }
  // Loaders such as glvnd's return a stub for any name, so finding the functions proves little.
  GLint major = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  if (major < 3) {
    std::snprintf(state.failure, sizeof state.failure, "the current context has version %d; OpenGL ES 3.0 is needed",
                  major);
    return Status::kDriver;
  }
  GLint minor = 0;
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  state.storage_blocks = desc.webgl != nullptr ? 0 : storage_blocks_of(gl, major, minor);
  state.has_sample_masks = major > 3 || minor >= 2;
  state.loader = loader;
  state.list_bytes = desc.list_bytes;
  state.webgl = desc.webgl;
  state.scratch = desc.scratch;
  GLint most = 0;
  gl.GetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &most);
  const auto offered = static_cast<std::uint32_t>(most);
  state.block_bytes = (offered < desc.block_bytes ? offered : desc.block_bytes) / 16 * 16;
  if (!state.stream.create(gl, desc.stream_bytes, desc.webgl != nullptr ? desc.scratch.data() : nullptr)) {
    state.stream.destroy(gl);
    std::snprintf(state.failure, sizeof state.failure, "no memory for a stream of %u bytes",
                  unsigned{desc.stream_bytes});
    return Status::kDriver;
  }
  state.is_created = true;
  return Status::kOk;
}

void HairRenderer::destroy() {
  if (state_ == nullptr) return;
  RendererState& state = *state_;
  state.failure[0] = '\0';
  if (!state.is_created) return;
  if (state.mode_memory.release != nullptr) state.mode_memory.release(state.gl, state.mode_memory);
  state.mode_memory = {};
  for (const RendererState::Program& program : std::span(state.programs).first(state.program_count)) {
    state.gl.DeleteProgram(program.name);
  }
  state.program_count = 0;
  state.stream.destroy(state.gl);
  state.is_created = false;
}

bool HairRenderer::is_created() const { return state_ != nullptr && state_->is_created; }

std::uint32_t HairRenderer::program_count() const { return state_ == nullptr ? 0 : state_->program_count; }

const char* HairRenderer::failure() const { return state_ == nullptr ? "" : state_->failure; }

}  // namespace coif
