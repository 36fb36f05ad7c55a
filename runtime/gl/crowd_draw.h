#pragma once

#include "gl/renderer_state.h"

#include <coif/renderer.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// The last frame's values, which motion vectors need in addition to the heads of this frame.
struct LastFrame {
  std::span<const HairInstance> instances;  ///< The same heads, in the same order.
  Vec3 eye;
  MatrixLayout layout;      ///< The layout for two frames.
  std::uint32_t needs = 0;  ///< Replaces ModelState::needs.
};

/// Sends heads of one asset to the GPU and draws them.
class CrowdDraw {
 public:
  /// Keeps references to all of its arguments. `block`: filled for this draw, with `eye` at its origin. `order`: sorts
  /// each head's triangles; null: the asset's own orders. It must fit the model, and the stream must have room for its
  /// indices.
  CrowdDraw(RendererState& renderer, const ModelState& model, std::span<const HairInstance> instances,
            const MaterialRecord& material, Component component, const Vec3& eye, const DrawBlock& block,
            TriangleOrder* order = nullptr, const LastFrame* last = nullptr);

  /// Draws every head in view with each of the passes, whose programs must exist. Sets only the state in which passes
  /// differ; the caller sets the rest. False where the driver cannot map the stream.
  COIF_API bool draw(const PassList& passes);

 private:
  using Group = VisibleCrowd::Group;

  /// The data that is on the GPU at one time: draw calls of up to a batch of heads.
  struct Chunk {
    std::uint32_t heads = 0;
    std::uint32_t first_block = 0;  ///< Offset in the stream of the first batch's matrices.
    std::size_t first_index = 0;  ///< Bytes: in the stream for a head with its own order, else in the model's indices.
    std::size_t next = 0;         ///< The instance after its last.
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
  std::uint32_t block_bytes_;  ///< Bytes of the stream for the values of the draw.
  std::uint32_t batch_bytes_;  ///< Bytes of the stream for a full batch, or for a head with its own order.
};

/// Most bytes of the stream that a head with its own order takes, whatever draws it.
[[nodiscard]] std::uint64_t bytes_of_ordered_head(const RendererState& renderer, const ModelState& model);

}  // namespace coif
