#include "gl/stream_buffer.h"

namespace coif {

bool StreamBuffer::create(const GlFunctions& gl, std::uint32_t bytes, std::byte* scratch) {
  scratch_ = scratch;
  GLint alignment = 0;
  gl.GetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
  alignment_ = alignment > 16 ? static_cast<std::uint32_t>(alignment) : 16;
  const std::uint32_t unit = kParts * alignment_;
  bytes_ = bytes / unit * unit;
  clear_errors(gl);
  gl.GenBuffers(1, &buffer_);
  gl.BindBuffer(GL_UNIFORM_BUFFER, buffer_);
  gl.BufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes_), nullptr, GL_STREAM_DRAW);
  gl.BindBuffer(GL_UNIFORM_BUFFER, 0);
  return gl.GetError() == GL_NO_ERROR;
}

void StreamBuffer::destroy(const GlFunctions& gl) {
  for (GLsync& fence : fences_) {
    if (fence != nullptr) gl.DeleteSync(fence);
  }
  if (buffer_ != 0) gl.DeleteBuffers(1, &buffer_);
  *this = StreamBuffer();
}

void StreamBuffer::wait_for(const GlFunctions& gl, std::uint32_t part) {
  GLsync& fence = fences_[part];
  if (fence == nullptr) return;
  constexpr GLuint64 kSecond = 1'000'000'000;  // Nanoseconds. A GPU that takes longer is lost, and so is its picture.
  gl.ClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, kSecond);
  gl.DeleteSync(fence);
  fence = nullptr;
}

std::byte* StreamBuffer::take(const GlFunctions& gl, std::uint32_t bytes, std::uint32_t slack) {
  offset_ = aligned(cursor_);
  if (offset_ + bytes + slack > bytes_) {
    leave(gl, part_of(cursor_), kParts);
    offset_ = 0;
  }
  end_ = offset_ + bytes;
  for (std::uint32_t part = part_of(offset_); part <= part_of(end_ - 1); ++part) wait_for(gl, part);
  gl.BindBuffer(GL_UNIFORM_BUFFER, buffer_);
  if (scratch_ != nullptr) return scratch_;
  return static_cast<std::byte*>(
      gl.MapBufferRange(GL_UNIFORM_BUFFER, static_cast<GLintptr>(offset_), static_cast<GLsizeiptr>(bytes),
                        GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_UNSYNCHRONIZED_BIT));
}

void StreamBuffer::give(const GlFunctions& gl) {
  if (scratch_ == nullptr) {
    gl.UnmapBuffer(GL_UNIFORM_BUFFER);
  } else {
    gl.BufferSubData(GL_UNIFORM_BUFFER, static_cast<GLintptr>(offset_), static_cast<GLsizeiptr>(end_ - offset_),
                     scratch_);
  }
}

void StreamBuffer::leave(const GlFunctions& gl, std::uint32_t first, std::uint32_t last) {
  if (scratch_ != nullptr) return;
  for (std::uint32_t part = first; part < last; ++part) {
    if (fences_[part] == nullptr) fences_[part] = gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  }
}

void StreamBuffer::retire(const GlFunctions& gl) {
  // A part gets its fence when the cursor leaves it.
  const bool is_full = end_ >= bytes_;
  leave(gl, part_of(offset_), is_full ? kParts : part_of(end_));
  cursor_ = is_full ? 0 : end_;
}

}  // namespace coif
