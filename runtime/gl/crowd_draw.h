#pragma once

#include "gl/draw_block.h"
#include "gl/frustum.h"
#include "gl/passes.h"
#include "gl/stream_buffer.h"

#include <coif/renderer.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// Heads of one asset on their way to the GPU: those in view, in groups that share what a draw call cannot vary.
class CrowdDraw {
 public:
  /// Refers to all of its arguments. `block`: filled for this draw.
  CrowdDraw(HairRenderer& renderer, const HairModel& model, std::span<const HairInstance> instances,
            const DrawDesc& desc, const DrawBlock& block);

  /// Draws every head in view with each of the passes, whose programs exist. State is set as far as passes differ; the
  /// rest is the caller's. False where the driver cannot map the stream.
  bool draw(const PassList& passes);

  /// vec4 that one head has in the matrices' block.
  [[nodiscard]] static std::uint32_t rows_of_head(const HairModel& model);

 private:
  /// Heads that one draw call can show.
  struct Group {
    std::uint32_t lod;
    std::uint32_t order;
    bool operator==(const Group&) const = default;
  };

  /// What is on the GPU at once: draw calls of up to `heads_of_batch` heads.
  struct Chunk {
    std::uint32_t heads = 0;
    std::uint32_t first_block = 0;  ///< Offset in the stream, of the first batch's matrices.
    std::size_t next = 0;           ///< The instance after its last.
  };

  [[nodiscard]] Group group_of(const HairInstance& instance) const;
  [[nodiscard]] bool is_seen(const HairInstance& instance) const;
  void find_groups();
  bool draw_group(const Group& group, const PassList& passes);
  [[nodiscard]] std::uint32_t count_heads(const Group& group, std::size_t first, std::uint32_t most) const;
  [[nodiscard]] std::uint32_t bytes_of(std::uint32_t heads) const;
  bool send_chunk(const Group& group, std::size_t first, Chunk& chunk);
  void write_head(std::byte* to, const HairInstance& instance) const;
  void draw_chunk(const Group& group, const Chunk& chunk, const PassList& passes);

  HairRenderer& renderer_;
  const HairModel& model_;
  std::span<const HairInstance> instances_;
  const DrawDesc& desc_;
  const DrawBlock& block_;
  const MaterialRecord& material_;
  Frustum frustum_;
  StreamBuffer stream_;
  std::uint32_t rows_of_head_;
  std::uint32_t heads_of_batch_;
  std::uint32_t batch_bytes_;                   ///< Of the stream, for a full batch.
  std::uint32_t orders_of_lod_[kMaxLods] = {};  ///< Bit k: some head in view is drawn in order k.
};

}  // namespace coif
