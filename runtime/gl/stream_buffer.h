#pragma once

#include "gl/gl_functions.h"

#include <coif/renderer.h>

#include <cstddef>
#include <cstdint>

namespace coif {

/// Writes a renderer's stream: uniform blocks of one draw after the other, round and round in one buffer. A part of the
/// buffer is written again only when the GPU has passed the fence behind its last use, so that neither the driver has to
/// find new memory nor anyone to wait, if the buffer holds some frames.
class StreamBuffer {
 public:
  StreamBuffer(const GlFunctions& gl, StreamState& state) : gl_(gl), state_(state) {}

  /// Leaves the uniform buffer binding empty. False where the driver has no memory.
  bool create(std::uint32_t bytes);
  void destroy();

  /// Most that can be taken at once.
  [[nodiscard]] std::uint32_t most() const { return state_.bytes / StreamState::kParts; }
  [[nodiscard]] std::uint32_t aligned(std::uint32_t bytes) const {
    return (bytes + state_.alignment - 1) / state_.alignment * state_.alignment;
  }

  /// Room for `bytes`, at most most(), to be filled before give(); with `slack` bytes behind it that may be bound but not
  /// written. Null where the driver cannot map it. Binds the buffer as uniform buffer.
  std::byte* take(std::uint32_t bytes, std::uint32_t slack);
  /// Of the room taken last, from the buffer's start.
  [[nodiscard]] std::uint32_t offset() const { return offset_; }
  /// The GPU may read what was written.
  void give();
  /// All draw calls that read what was given have been made.
  void retire();

 private:
  [[nodiscard]] std::uint32_t part_of(std::uint32_t place) const { return place / most(); }
  void wait_for(std::uint32_t part);
  /// Sets a fence behind each part from `first` up to before `last`.
  void leave(std::uint32_t first, std::uint32_t last);

  const GlFunctions& gl_;
  StreamState& state_;
  std::uint32_t offset_ = 0;
  std::uint32_t end_ = 0;
};

}  // namespace coif
