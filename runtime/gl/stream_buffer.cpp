#include "gl/stream_buffer.h"

namespace coif {

bool StreamBuffer::create(std::uint32_t bytes) {
  GLint alignment = 0;
  gl_.GetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
  state_.alignment = alignment > 16 ? static_cast<std::uint32_t>(alignment) : 16;
  const std::uint32_t unit = StreamState::kParts * state_.alignment;
  state_.bytes = bytes / unit * unit;
  clear_errors(gl_);
  gl_.GenBuffers(1, &state_.buffer);
  gl_.BindBuffer(GL_UNIFORM_BUFFER, state_.buffer);
  gl_.BufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(state_.bytes), nullptr, GL_STREAM_DRAW);
  gl_.BindBuffer(GL_UNIFORM_BUFFER, 0);
  return gl_.GetError() == GL_NO_ERROR;
}

void StreamBuffer::destroy() {
  for (void*& fence : state_.fences) {
    if (fence != nullptr) gl_.DeleteSync(static_cast<GLsync>(fence));
  }
  if (state_.buffer != 0) gl_.DeleteBuffers(1, &state_.buffer);
  state_ = {};
}

void StreamBuffer::wait_for(std::uint32_t part) {
  void*& fence = state_.fences[part];
  if (fence == nullptr) return;
  constexpr GLuint64 kSecond = 1'000'000'000;  // A GPU that takes longer is lost, and what it shows with it.
  gl_.ClientWaitSync(static_cast<GLsync>(fence), GL_SYNC_FLUSH_COMMANDS_BIT, kSecond);
  gl_.DeleteSync(static_cast<GLsync>(fence));
  fence = nullptr;
}

std::byte* StreamBuffer::take(std::uint32_t bytes, std::uint32_t slack) {
  offset_ = aligned(state_.cursor);
  if (offset_ + bytes + slack > state_.bytes) {
    leave(part_of(state_.cursor), StreamState::kParts);
    offset_ = 0;
  }
  end_ = offset_ + bytes;
  for (std::uint32_t part = part_of(offset_); part <= part_of(end_ - 1); ++part) wait_for(part);
  gl_.BindBuffer(GL_UNIFORM_BUFFER, state_.buffer);
  return static_cast<std::byte*>(
      gl_.MapBufferRange(GL_UNIFORM_BUFFER, static_cast<GLintptr>(offset_), static_cast<GLsizeiptr>(bytes),
                         GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_UNSYNCHRONIZED_BIT));
}

void StreamBuffer::give() { gl_.UnmapBuffer(GL_UNIFORM_BUFFER); }

void StreamBuffer::leave(std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t part = first; part < last; ++part) {
    if (state_.fences[part] == nullptr) state_.fences[part] = gl_.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  }
}

void StreamBuffer::retire() {
  // The part that the cursor stays in gets its fence when it is left.
  const bool is_full = end_ >= state_.bytes;
  leave(part_of(offset_), is_full ? StreamState::kParts : part_of(end_));
  state_.cursor = is_full ? 0 : end_;
}

}  // namespace coif
