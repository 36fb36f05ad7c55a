#pragma once

#include "gl/gl_functions.h"

#include <cstddef>
#include <cstdint>

namespace coif {

/// A renderer's buffer for a frame's data: uniform blocks of one draw after the other, written round and round. A part
/// of it is written again only when the GPU has passed the fence behind its last use, so that neither the driver has to
/// find new memory nor anyone to wait, if the buffer holds some frames.
class StreamBuffer {
 public:
  static constexpr std::uint32_t kParts = 4;

  /// Leaves the uniform buffer binding empty. False where the driver has no memory. `scratch`: null, or a part's bytes
  /// to write to where nothing can be mapped; what is sent from there the driver itself keeps apart from what the GPU
  /// still reads.
  [[nodiscard]] bool create(const GlFunctions& gl, std::uint32_t bytes, std::byte* scratch = nullptr);
  void destroy(const GlFunctions& gl);

  [[nodiscard]] GLuint name() const { return buffer_; }
  /// Most that can be taken at once.
  [[nodiscard]] std::uint32_t most() const { return bytes_ / kParts; }
  [[nodiscard]] std::uint32_t aligned(std::uint32_t bytes) const {
    return (bytes + alignment_ - 1) / alignment_ * alignment_;
  }

  /// Room for `bytes`, at most most(), to be filled before give(); with `slack` bytes behind it that may be bound but
  /// not written. Null where the driver cannot map it. Binds the buffer as uniform buffer.
  std::byte* take(const GlFunctions& gl, std::uint32_t bytes, std::uint32_t slack);
  /// Of the room taken last, from the buffer's start.
  [[nodiscard]] std::uint32_t offset() const { return offset_; }
  /// The GPU may read what was written.
  void give(const GlFunctions& gl);
  /// All draw calls that read what was given have been made.
  void retire(const GlFunctions& gl);

 private:
  [[nodiscard]] std::uint32_t part_of(std::uint32_t place) const { return place / most(); }
  void wait_for(const GlFunctions& gl, std::uint32_t part);
  /// Sets a fence behind each part from `first` up to before `last`.
  void leave(const GlFunctions& gl, std::uint32_t first, std::uint32_t last);

  GLuint buffer_ = 0;
  std::byte* scratch_ = nullptr;
  std::uint32_t bytes_ = 0;
  std::uint32_t cursor_ = 0;
  std::uint32_t alignment_ = 1;  ///< Of what a uniform block may be bound to.
  GLsync fences_[kParts] = {};   ///< Behind the last use of each part, until it is written again.
  std::uint32_t offset_ = 0;     ///< The room taken last, and where it ends.
  std::uint32_t end_ = 0;
};

}  // namespace coif
