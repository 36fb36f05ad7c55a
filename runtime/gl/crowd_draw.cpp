#include "gl/crowd_draw.h"

#include "gl/shader_programs.h"
#include "gl/textures.h"

#include <cstring>

namespace coif {
namespace {

std::uint32_t bytes_of_head(const RendererState& renderer, const ModelState& model) {
  return renderer.stream.aligned(model.layout.rows_of_head * MatrixLayout::kRowBytes);
}

}  // namespace

CrowdDraw::CrowdDraw(RendererState& renderer, const ModelState& model, std::span<const HairInstance> instances,
                     const MaterialRecord& material, Component component, const Vec3& eye, const DrawBlock& block,
                     TriangleOrder* order, const LastFrame* last)
    : renderer_(renderer),
      model_(model),
      instances_(instances),
      material_(material),
      component_(component),
      eye_(eye),
      block_(block),
      order_(order),
      last_(last),
      layout_(last == nullptr ? model.layout : last->layout),
      visible_(model.hair, instances, eye, block.clip_from_view),
      stream_(renderer.stream),
      block_bytes_(stream_.aligned(sizeof(DrawBlock))),
      batch_bytes_(order == nullptr ? stream_.aligned(layout_.batch_bytes()) : bytes_of_head(renderer, model)) {}

bool CrowdDraw::draw(const PassList& passes) {
  if (passes.passes().empty()) return true;
  return visible_.for_each_group([&](const Group& group) { return draw_group(group, passes); });
}

bool CrowdDraw::draw_group(const Group& group, const PassList& passes) {
  for (std::size_t next = 0; next < instances_.size();) {
    Chunk chunk;
    if (!send_chunk(group, next, chunk)) return false;
    if (chunk.heads == 0) return true;
    draw_chunk(group, chunk, passes);
    stream_.retire(renderer_.gl);
    next = chunk.next;
  }
  return true;
}

std::uint64_t bytes_of_ordered_head(const RendererState& renderer, const ModelState& model) {
  const StreamBuffer& stream = renderer.stream;
  const std::uint64_t textures = model.layout.bones_in_texture ? model.hair.bone_count * sizeof(Mat34) : 0;
  return stream.aligned(sizeof(DrawBlock)) + bytes_of_head(renderer, model) + textures +
         std::uint64_t{model.hair.indices_of_order} * model.hair.index_bytes;
}

// A head with its own order is drawn alone.
std::uint32_t CrowdDraw::most_heads() const {
  if (order_ != nullptr || layout_.bones_in_texture) return 1;
  return (stream_.most() - block_bytes_) / batch_bytes_ * layout_.heads_of_batch;
}

/// Bytes of the bone texture, over all frames.
std::uint32_t CrowdDraw::texture_bytes() const {
  return layout_.bones_in_texture ? layout_.frames * model_.hair.bone_count * std::uint32_t(sizeof(Mat34)) : 0;
}

std::uint32_t CrowdDraw::bytes_of(std::uint32_t heads) const {
  const std::uint32_t batches = (heads + layout_.heads_of_batch - 1) / layout_.heads_of_batch;
  return block_bytes_ + batches * batch_bytes_ + texture_bytes();
}

void CrowdDraw::write(std::size_t instance, std::byte* block, std::byte* texture) {
  const std::size_t bytes = layout_.bones_in_texture ? model_.hair.bone_count * sizeof(Mat34) : 0;
  write_head(layout_, instances_[instance], eye_, block);
  if (bytes > 0) std::memcpy(texture, instances_[instance].palette.data(), bytes);
  if (last_ == nullptr) return;
  const HairInstance& before = last_->instances[instance];
  write_head(layout_, before, last_->eye, block + layout_.rows_of_frame() * MatrixLayout::kRowBytes);
  if (bytes > 0) std::memcpy(texture + bytes, before.palette.data(), bytes);
}

void CrowdDraw::send_texture(std::uint32_t offset) {
  const std::uint32_t bones = model_.hair.bone_count;
  const GLuint texture = last_ == nullptr ? model_.palette_texture : model_.motion_texture;
  for (std::uint32_t frame = 0; frame < layout_.frames; ++frame) {
    send_palette_texture(renderer_.gl, stream_.name(), offset + frame * bones * std::uint32_t(sizeof(Mat34)), texture,
                         bones, frame);
  }
}

// Sends the values of the draw first, then the matrices batch by batch, each at the alignment of a block. For one head
// with more bones than a block holds: its own matrix, then the matrices of the texture. Last come the indices of the
// head's own order.
bool CrowdDraw::send_chunk(const Group& group, std::size_t first, Chunk& chunk) {
  const std::uint32_t batch = layout_.heads_of_batch;
  chunk.heads = visible_.count(group, first, most_heads());
  if (chunk.heads == 0) return true;
  const std::uint32_t bytes = bytes_of(chunk.heads);
  const std::uint32_t ordered = order_ == nullptr ? 0 : model_.hair.lods[group.lod].count * model_.hair.index_bytes;
  std::byte* const memory = stream_.take(renderer_.gl, bytes + ordered, renderer_.block_bytes);
  if (memory == nullptr) return false;
  std::memcpy(memory, &block_, sizeof block_);
  std::byte* const matrices = memory + block_bytes_;
  chunk.next = first;
  for (std::uint32_t head = 0; head < chunk.heads; ++head, ++chunk.next) {
    chunk.next = visible_.find(group, chunk.next);
    const std::uint32_t place = head % batch * layout_.rows_of_head * MatrixLayout::kRowBytes;
    write(chunk.next, matrices + head / batch * batch_bytes_ + place, matrices + batch_bytes_);
    if (order_ != nullptr) order_->write(instances_[chunk.next], eye_, memory + bytes);
  }
  stream_.give(renderer_.gl);
  chunk.first_block = stream_.offset() + block_bytes_;
  chunk.first_index = order_ != nullptr ? stream_.offset() + bytes
                                        : model_.hair.first_index(group.lod, group.order) * model_.hair.index_bytes;
  if (layout_.bones_in_texture) send_texture(chunk.first_block + batch_bytes_);
  return true;
}

void CrowdDraw::draw_chunk(const Group& group, const Chunk& chunk, const PassList& passes) {
  const GlFunctions& gl = renderer_.gl;
  const std::uint32_t batch = layout_.heads_of_batch, index_bytes = model_.hair.index_bytes;
  const std::uint32_t needs = last_ == nullptr ? model_.needs : last_->needs;
  const auto indices = reinterpret_cast<const void*>(chunk.first_index);
  const GLenum index_type = index_bytes == sizeof(GLushort) ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  gl.BindBufferRange(GL_UNIFORM_BUFFER, kDrawIndex, stream_.name(), static_cast<GLintptr>(stream_.offset()),
                     sizeof(DrawBlock));
  if (order_ != nullptr) gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, stream_.name());
  for (const Pass& pass : passes.passes()) {
    const RendererState::Program& program = *renderer_.find_program(variant_of(pass, needs, material_, component_));
    set_pass_state(gl, pass);
    gl.UseProgram(program.name);
    gl.Uniform3f(program.alpha_range, pass.alpha_min, pass.alpha_max, pass.solid_from);
    std::uint32_t place = chunk.first_block;
    for (std::uint32_t drawn = 0; drawn < chunk.heads; drawn += batch, place += batch_bytes_) {
      const std::uint32_t left = chunk.heads - drawn;
      gl.BindBufferRange(GL_UNIFORM_BUFFER, kPaletteIndex, stream_.name(), static_cast<GLintptr>(place),
                         static_cast<GLsizeiptr>(renderer_.block_bytes));
      gl.DrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(model_.hair.lods[group.lod].count), index_type,
                               indices, static_cast<GLsizei>(left < batch ? left : batch));
    }
  }
  if (order_ != nullptr) gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, model_.index_buffer);
}

}  // namespace coif
