#include "gl/crowd_draw.h"

#include "gl/shader_programs.h"
#include "gl/textures.h"

#include <cstring>

namespace coif {

CrowdDraw::CrowdDraw(RendererState& renderer, const ModelState& model, std::span<const HairInstance> instances,
                     const MaterialRecord& material, Component component, const Vec3& eye, const DrawBlock& block)
    : renderer_(renderer),
      model_(model),
      instances_(instances),
      material_(material),
      component_(component),
      eye_(eye),
      block_(block),
      visible_(model.hair, instances, eye, block.clip_from_view),
      stream_(renderer.stream),
      block_bytes_(stream_.aligned(sizeof(DrawBlock))),
      batch_bytes_(stream_.aligned(model.layout.batch_bytes())) {}

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

std::uint32_t CrowdDraw::bytes_of(std::uint32_t heads) const {
  const MatrixLayout& layout = model_.layout;
  const std::uint32_t batches = (heads + layout.heads_of_batch - 1) / layout.heads_of_batch;
  const std::uint32_t textures =
      layout.bones_in_texture ? model_.hair.bone_count * std::uint32_t(sizeof(Mat34)) : 0;
  return block_bytes_ + batches * batch_bytes_ + textures;
}

// Values of the draw first, then the matrices batch by batch, each where a block may begin; or, of one head whose bones
// are too many for a block, its own matrix and then those of the texture.
bool CrowdDraw::send_chunk(const Group& group, std::size_t first, Chunk& chunk) {
  const MatrixLayout& layout = model_.layout;
  const std::uint32_t batch = layout.heads_of_batch;
  const std::uint32_t most = layout.bones_in_texture ? 1 : (stream_.most() - block_bytes_) / batch_bytes_ * batch;
  chunk.heads = visible_.count(group, first, most);
  if (chunk.heads == 0) return true;
  std::byte* const memory = stream_.take(renderer_.gl, bytes_of(chunk.heads), renderer_.block_bytes);
  if (memory == nullptr) return false;
  std::memcpy(memory, &block_, sizeof block_);
  std::byte* const matrices = memory + block_bytes_;
  chunk.next = first;
  for (std::uint32_t head = 0; head < chunk.heads; ++head, ++chunk.next) {
    chunk.next = visible_.find(group, chunk.next);
    const HairInstance& instance = instances_[chunk.next];
    write_head(layout, instance, eye_,
               matrices + head / batch * batch_bytes_ + head % batch * layout.rows_of_head * MatrixLayout::kRowBytes);
    if (layout.bones_in_texture) {
      std::memcpy(matrices + batch_bytes_, instance.palette.data(), instance.palette.size_bytes());
    }
  }
  stream_.give(renderer_.gl);
  chunk.first_block = stream_.offset() + block_bytes_;
  if (layout.bones_in_texture) {
    send_palette_texture(renderer_.gl, stream_.name(), chunk.first_block + batch_bytes_, model_.palette_texture,
                         model_.hair.bone_count);
  }
  return true;
}

void CrowdDraw::draw_chunk(const Group& group, const Chunk& chunk, const PassList& passes) {
  const GlFunctions& gl = renderer_.gl;
  const std::uint32_t batch = model_.layout.heads_of_batch, index_bytes = model_.hair.index_bytes;
  const auto indices = reinterpret_cast<const void*>(model_.hair.first_index(group.lod, group.order) * index_bytes);
  const GLenum index_type = index_bytes == sizeof(GLushort) ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  gl.BindBufferRange(GL_UNIFORM_BUFFER, kDrawIndex, stream_.name(), static_cast<GLintptr>(stream_.offset()),
                     sizeof(DrawBlock));
  for (const Pass& pass : passes.passes()) {
    const RendererState::Program& program =
        *renderer_.find_program(variant_of(pass, model_.needs, material_, component_));
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
}

}  // namespace coif
