#include "gl/crowd_draw.h"

#include "gl/binding_points.h"
#include "gl/draw_state.h"
#include "gl/palette_texture.h"
#include "gl/shader_variant.h"

#include <coif/view_cells.h>

#include <cstring>

namespace coif {
namespace {

constexpr std::uint32_t kRowBytes = 4 * sizeof(float);
constexpr std::uint32_t kMatrixRows = 3;

bool has_bones_in_block(std::uint32_t needs) {
  return (needs & (variant::kFourBones | variant::kOneBone)) != 0 && (needs & variant::kBonesInTexture) == 0;
}

bool has_bones_in_texture(std::uint32_t needs) { return (needs & variant::kBonesInTexture) != 0; }

}  // namespace

std::uint32_t CrowdDraw::rows_of_head(const HairModel& model) {
  return kMatrixRows * (1 + (has_bones_in_block(model.needs_) ? model.bone_count_ : 0));
}

CrowdDraw::CrowdDraw(HairRenderer& renderer, const HairModel& model, std::span<const HairInstance> instances,
                     const DrawDesc& desc, const DrawBlock& block)
    : renderer_(renderer),
      model_(model),
      instances_(instances),
      desc_(desc),
      block_(block),
      material_(desc.material != nullptr ? *desc.material : model.material_),
      frustum_(block.clip_from_view),
      stream_(renderer.functions(), renderer.stream_),
      rows_of_head_(rows_of_head(model)),
      heads_of_batch_(has_bones_in_texture(model.needs_) ? 1 : renderer.block_bytes_ / (rows_of_head_ * kRowBytes)),
      batch_bytes_(stream_.aligned(heads_of_batch_ * rows_of_head_ * kRowBytes)) {
  find_groups();
}

bool CrowdDraw::is_seen(const HairInstance& instance) const {
  const HeadMatrix head = head_matrix(instance.head, desc_.eye);
  float center[3];
  for (int i = 0; i < 3; ++i) {
    center[i] = head.rows[i][3];
    for (int k = 0; k < 3; ++k) center[i] += head.rows[i][k] * model_.reach_center_[k];
  }
  return frustum_.may_show(center, model_.reach_);
}

CrowdDraw::Group CrowdDraw::group_of(const HairInstance& instance) const {
  if (model_.order_count_ < 2) return {instance.lod, 0};
  const HeadMatrix head = head_matrix(instance.head, desc_.eye);
  float towards_eye[3] = {};  // head space
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) towards_eye[i] -= head.rows[k][i] * head.rows[k][3];
  }
  return {instance.lod, model_.order_of_view_[view_cell(towards_eye)]};
}

void CrowdDraw::find_groups() {
  for (const HairInstance& instance : instances_) {
    if (!is_seen(instance)) continue;
    const Group group = group_of(instance);
    orders_of_lod_[group.lod] |= 1u << group.order;
  }
}

bool CrowdDraw::draw(const PassList& passes) {
  if (passes.passes().empty()) return true;
  for (std::uint32_t lod = kMaxLods; lod-- > 0;) {  // Coarse levels are far away.
    for (std::uint32_t order = 0; orders_of_lod_[lod] >> order != 0; ++order) {
      if ((orders_of_lod_[lod] >> order & 1) != 0 && !draw_group({lod, order}, passes)) return false;
      if (order == kMaxOrders - 1) break;
    }
  }
  return true;
}

bool CrowdDraw::draw_group(const Group& group, const PassList& passes) {
  for (std::size_t next = 0; next < instances_.size();) {
    Chunk chunk;
    if (!send_chunk(group, next, chunk)) return false;
    if (chunk.heads == 0) return true;
    draw_chunk(group, chunk, passes);
    stream_.retire();
    next = chunk.next;
  }
  return true;
}

std::uint32_t CrowdDraw::count_heads(const Group& group, std::size_t first, std::uint32_t most) const {
  std::uint32_t heads = 0;
  for (std::size_t i = first; i < instances_.size() && heads < most; ++i) {
    if (is_seen(instances_[i]) && group_of(instances_[i]) == group) ++heads;
  }
  return heads;
}

std::uint32_t CrowdDraw::bytes_of(std::uint32_t heads) const {
  const std::uint32_t batches = (heads + heads_of_batch_ - 1) / heads_of_batch_;
  const std::uint32_t textures =
      has_bones_in_texture(model_.needs_) ? model_.bone_count_ * std::uint32_t(sizeof(Mat34)) : 0;
  return stream_.aligned(sizeof(DrawBlock)) + batches * batch_bytes_ + textures;
}

// Values of the draw first, then the matrices batch by batch, each where a block may begin; or, of one head whose bones
// are too many for a block, its own matrix and then those of the texture.
bool CrowdDraw::send_chunk(const Group& group, std::size_t first, Chunk& chunk) {
  const std::uint32_t first_batch = stream_.aligned(sizeof(DrawBlock));
  const bool in_texture = has_bones_in_texture(model_.needs_);
  const std::uint32_t most = in_texture ? 1 : (stream_.most() - first_batch) / batch_bytes_ * heads_of_batch_;
  chunk.heads = count_heads(group, first, most);
  if (chunk.heads == 0) return true;
  std::byte* const memory = stream_.take(bytes_of(chunk.heads), renderer_.block_bytes_);
  if (memory == nullptr) return false;
  std::memcpy(memory, &block_, sizeof block_);
  std::uint32_t head = 0;
  for (chunk.next = first; head < chunk.heads; ++chunk.next) {
    const HairInstance& instance = instances_[chunk.next];
    if (!is_seen(instance) || !(group_of(instance) == group)) continue;
    const std::uint32_t place =
        first_batch + head / heads_of_batch_ * batch_bytes_ + head % heads_of_batch_ * rows_of_head_ * kRowBytes;
    write_head(memory + place, instance);
    if (in_texture) {
      std::memcpy(memory + first_batch + batch_bytes_, instance.palette.data(), instance.palette.size_bytes());
    }
    ++head;
  }
  stream_.give();
  chunk.first_block = stream_.offset() + first_batch;
  if (in_texture) {
    send_palette_texture(renderer_.functions(), renderer_.stream_.buffer, chunk.first_block + batch_bytes_,
                         model_.palette_texture_, model_.bone_count_);
  }
  return true;
}

void CrowdDraw::write_head(std::byte* to, const HairInstance& instance) const {
  const HeadMatrix head = head_matrix(instance.head, desc_.eye);
  std::memcpy(to, &head, sizeof head);
  if (rows_of_head_ > kMatrixRows)
    std::memcpy(to + sizeof head, instance.palette.data(), instance.palette.size_bytes());
}

void CrowdDraw::draw_chunk(const Group& group, const Chunk& chunk, const PassList& passes) {
  const GlFunctions& gl = renderer_.functions();
  const HairModel::IndexRange range = model_.lods_[group.lod];
  const std::size_t first = std::size_t{group.order} * model_.indices_of_order_ + range.first;
  const void* const indices = reinterpret_cast<const void*>(first * model_.index_bytes_);
  gl.BindBufferRange(GL_UNIFORM_BUFFER, kDrawIndex, renderer_.stream_.buffer, static_cast<GLintptr>(stream_.offset()),
                     sizeof(DrawBlock));
  for (const Pass& pass : passes.passes()) {
    const HairRenderer::Program& program =
        *renderer_.find_program(variant_of(pass, model_.needs_, material_, desc_.component));
    set_pass_state(gl, pass);
    gl.UseProgram(program.name);
    gl.Uniform3f(program.alpha_range, pass.alpha_min, pass.alpha_max, pass.solid_from);
    std::uint32_t place = chunk.first_block;
    for (std::uint32_t drawn = 0; drawn < chunk.heads; drawn += heads_of_batch_, place += batch_bytes_) {
      const std::uint32_t left = chunk.heads - drawn;
      gl.BindBufferRange(GL_UNIFORM_BUFFER, kPaletteIndex, renderer_.stream_.buffer, static_cast<GLintptr>(place),
                         static_cast<GLsizeiptr>(renderer_.block_bytes_));
      gl.DrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(range.count), model_.index_type_, indices,
                               static_cast<GLsizei>(left < heads_of_batch_ ? left : heads_of_batch_));
    }
  }
}

}  // namespace coif
