#pragma once

#include "cook/recipe/findings.h"
#include "cook/select/hair_mesh.h"
#include "cook/texture/image.h"
#include "cook/texture/stored_textures.h"
#include "platform/stop.h"

namespace coif::cook {

struct DrawnRecipe;

/// Of textures with two channels, as the recipe wants them.
[[nodiscard]] TexelFormat two_channel_format(const DrawnRecipe& recipe);

/// Maps of how normals and strands lie on the surface (TextureRole::kNormal, kStrandAxis), each at the lowest
/// resolution that says all: from the hair's normals (two channels), and from what is known of its strands
/// (SourceMaterial::strand_texture), else from the normals too. Null: there are none. A map that says nothing where the
/// hair shows it is left out.
StoredTextures bake_relief(const Image* normals, const Image* strands, const HairMesh& hair, const DrawnRecipe& recipe,
                           const platform::Threads& threads, Findings& findings);

}  // namespace coif::cook
