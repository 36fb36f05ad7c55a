#pragma once
// The state of HairRenderer and HairModel, in the room that their public header reserves.

#include "gl/gl_functions.h"
#include "gl/passes.h"
#include "gl/stream_buffer.h"

#include <coif/renderer.h>

#include <cstddef>
#include <cstdint>

namespace coif {

/// The objects of kExactMode, the only way to draw that has some; made at its first draw.
struct ModeMemory {
  alignas(void*) std::byte bytes[512] = {};
  void (*release)(const GlFunctions& gl, ModeMemory& memory) = nullptr;  ///< Null: there is nothing to release.
};

struct RendererState {
  static constexpr std::uint32_t kMaxPrograms = 256;  ///< A game has some dozens.

  struct Program {
    std::uint32_t variant = 0;  ///< See shader_programs.h.
    GLuint name = 0;
    GLint alpha_range = -1;  ///< Uniform location.
  };

  /// Null before the first create().
  [[nodiscard]] static RendererState* of(const HairRenderer& renderer) { return renderer.state_; }

  [[nodiscard]] const Program* find_program(std::uint32_t variant) const;
  /// Whether a program of this code can be built here and should be used. Where not, its mode has another way.
  [[nodiscard]] COIF_API bool takes(const FragmentCode& code) const;
  /// Builds the programs of the passes that are missing. kDriver where the driver refuses one; see `failure`.
  Status build_missing(const PassList& passes, std::uint32_t needs, const MaterialRecord& material,
                       Component component);

  GlFunctions gl;
  GlLoader loader;
  StreamBuffer stream;
  ModeMemory mode_memory;
  std::uint32_t storage_blocks = 0;  ///< How many storage blocks fragment shaders may write to.
  bool has_sample_masks = false;     ///< Fragment shaders may choose which samples are drawn.
  std::uint32_t list_bytes = 0;
  std::uint32_t block_bytes = 0;  ///< Size of the matrices' uniform block.
  const WebGlCode* webgl = nullptr;
  std::span<std::byte> scratch;  ///< Used with `webgl`.
  bool is_created = false;
  char failure[512] = {};
  std::uint32_t program_count = 0;
  Program programs[kMaxPrograms];
};

struct ModelState {
  /// Null where nothing is uploaded.
  [[nodiscard]] static const ModelState* of(const HairModel& model) { return model.state_; }

  void upload_mesh(const GlFunctions& gl, const Asset& asset);
  [[nodiscard]] bool upload_indices(const GlFunctions& gl, const Asset& asset);
  void release(const GlFunctions& gl);

  RendererState* renderer = nullptr;
  DrawnHair hair;
  MatrixLayout layout;
  std::uint32_t needs = 0;  ///< Bits of `variant` that programs need for this asset, whatever its material.
  GLuint vertex_array = 0;
  GLuint vertex_buffer = 0;
  GLuint index_buffer = 0;
  GLuint base_texture = 0;
  GLuint shift_mask_texture = 0;
  GLuint normal_texture = 0;
  GLuint strand_texture = 0;
  GLuint palette_texture = 0;  ///< 0: matrices fit into a block.
  /// For two frames' matrices that do not fit into a block; made at the first motion vectors.
  mutable GLuint motion_texture = 0;
};

/// Binds what draw calls of this model need and sets the state that its passes share; unbinds and resets all of it at
/// the end.
void bind_model(const GlFunctions& gl, const ModelState& model);
void unbind_model(const GlFunctions& gl, const ModelState& model);

}  // namespace coif
