#pragma once

#include "gl/renderer_state.h"

#include <coif/renderer.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// What vectors of motion are drawn with, beside the heads of this frame.
struct LastFrame {
  std::span<const HairInstance> instances;  ///< The same heads, in the same order.
  Vec3 eye;
  MatrixLayout layout;      ///< Of two frames.
  std::uint32_t needs = 0;  ///< Instead of ModelState's.
};

/// Heads of one asset on their way to the GPU.
class CrowdDraw {
 public:
  /// Refers to all of its arguments. `block`: filled for this draw, with `eye` at its origin.
  /// `order`: makes each head's order; null: the asset's own. It fits the model, and the stream has room for its
  /// indices.
  CrowdDraw(RendererState& renderer, const ModelState& model, std::span<const HairInstance> instances,
            const MaterialRecord& material, Component component, const Vec3& eye, const DrawBlock& block,
            TriangleOrder* order = nullptr, const LastFrame* last = nullptr);

  /// Draws every head in view with each of the passes, whose programs exist. State is set as far as passes differ; the
  /// rest is the caller's. False where the driver cannot map the stream.
  COIF_API bool draw(const PassList& passes);

 private:
  using Group = VisibleCrowd::Group;

  /// What is on the GPU at once: draw calls of up to a batch of heads.
  struct Chunk {
    std::uint32_t heads = 0;
    std::uint32_t first_block = 0;  ///< Offset in the stream, of the first batch's matrices.
    std::size_t first_index = 0;    ///< Bytes: in the stream with an order of its own, else in the model's indices.
    std::size_t next = 0;           ///< The instance after its last.
  };

  bool draw_group(const Group& group, const PassList& passes);
  [[nodiscard]] std::uint32_t bytes_of(std::uint32_t heads) const;
  [[nodiscard]] std::uint32_t texture_bytes() const;
  void write(std::size_t instance, std::byte* block, std::byte* texture);
  void send_texture(std::uint32_t offset);
  [[nodiscard]] std::uint32_t most_heads() const;
  bool send_chunk(const Group& group, std::size_t first, Chunk& chunk);
  void draw_chunk(const Group& group, const Chunk& chunk, const PassList& passes);

  RendererState& renderer_;
  const ModelState& model_;
  std::span<const HairInstance> instances_;
  const MaterialRecord& material_;
  Component component_;
  const Vec3& eye_;
  const DrawBlock& block_;
  TriangleOrder* order_;
  const LastFrame* last_;
  const MatrixLayout& layout_;
  VisibleCrowd visible_;
  StreamBuffer& stream_;
  std::uint32_t block_bytes_;  ///< Of the stream, for the values of the draw,
  std::uint32_t batch_bytes_;  ///< and for a full batch, or a head with an order of its own.
};

/// Bytes of the stream that a head with an order of its own takes at most, whatever it is drawn by.
[[nodiscard]] std::uint64_t bytes_of_ordered_head(const RendererState& renderer, const ModelState& model);

}  // namespace coif
