#pragma once

#include "cook/recipe/findings.h"
#include "import/source_model.h"
#include "render/stage_renderer.h"

namespace coif::render {

/// The base textures that a source's materials name, embedded or beside it, reduced to what a picture shows; for
/// PictureSettings. What cannot be had is a warning of `findings`. Only those of materials that some mesh has are read.
[[nodiscard]] BodyTextures read_body_textures(const importer::SourceModel& model, cook::Findings& findings);

}  // namespace coif::render
