#pragma once

#include "gl/gl_functions.h"

#include <cstddef>
#include <cstdint>

namespace coif {

/// A renderer's ring buffer for a frame's data: uniform blocks of one draw after the other. A part of it is written
/// again only when the GPU has passed the fence behind its last use. So the driver need not find new memory, and nobody
/// waits, if the buffer holds some frames.
class StreamBuffer {
 public:
  static constexpr std::uint32_t kParts = 4;

  /// Leaves the uniform buffer binding empty. False where the driver has no memory. `scratch`: null, or memory of a
  /// part's size for writing where nothing can be mapped; the driver then keeps new data apart from data that the GPU
  /// still reads.
  [[nodiscard]] bool create(const GlFunctions& gl, std::uint32_t bytes, std::byte* scratch = nullptr);
  void destroy(const GlFunctions& gl);

  [[nodiscard]] GLuint name() const { return buffer_; }
  /// Most bytes that can be taken at once.
  [[nodiscard]] std::uint32_t most() const { return bytes_ / kParts; }
  [[nodiscard]] std::uint32_t aligned(std::uint32_t bytes) const {
    return (bytes + alignment_ - 1) / alignment_ * alignment_;
  }

  /// Returns room for `bytes`, at most most(), to be filled before give(). `slack` bytes behind it may be bound but not
  /// written. Null where the driver cannot map it. Binds the buffer as uniform buffer.
  std::byte* take(const GlFunctions& gl, std::uint32_t bytes, std::uint32_t slack);
  /// Where the last taken room begins in the buffer, bytes.
  [[nodiscard]] std::uint32_t offset() const { return offset_; }
  /// Ends writing; the GPU may read the data.
  void give(const GlFunctions& gl);
  /// Call it after all draw calls that read the given data.
  void retire(const GlFunctions& gl);

 private:
  [[nodiscard]] std::uint32_t part_of(std::uint32_t place) const { return place / most(); }
  void wait_for(const GlFunctions& gl, std::uint32_t part);
  /// Sets a fence behind each part from `first` up to but not including `last`.
  void leave(const GlFunctions& gl, std::uint32_t first, std::uint32_t last);

  GLuint buffer_ = 0;
  std::byte* scratch_ = nullptr;
  std::uint32_t bytes_ = 0;
  std::uint32_t cursor_ = 0;
  std::uint32_t alignment_ = 1;  ///< Alignment of uniform block bindings.
  GLsync fences_[kParts] = {};   ///< The fence behind the last use of each part, until the part is written again.
  std::uint32_t offset_ = 0;     ///< Where the last taken room begins, and where it ends.
  std::uint32_t end_ = 0;
};

}  // namespace coif
