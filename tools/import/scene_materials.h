#pragma once

#include "import/source_format.h"
#include "import/source_model.h"

struct aiScene;

namespace coif {

/// Fills `materials`, one per material of the scene, and `images` with the embedded base-colour textures that they
/// use. Colours: glTF's base colour factor; else the diffuse colour, which FBX and COLLADA replace by a texture where
/// there is one. Alpha is kept for glTF only: the other exporters disagree about what their opacity means. Its use is
/// glTF's alphaMode; in other formats kBlend where a texture is connected to the opacity, else kUnknown.
void convert_materials(const aiScene& scene, SourceFormat format, SourceModel& model);

}  // namespace coif
