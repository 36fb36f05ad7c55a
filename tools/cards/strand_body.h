#pragma once

// The head and body that strands belong to, which come in a file of their own.

#include "cook/recipe/recipe.h"
#include "groom/groom.h"
#include "import/source_model.h"

namespace coif::cards {

/// Strands and body are in metres with Y up as their files say, and one of the files may say nothing, or what its
/// exporter always says. Where roots do not lie on the body, but would if the strands' file were of another usual unit
/// or up axis, the strands are turned and scaled so, with a warning; where none fits, the warning says how far off they
/// are. What the recipe gives stays as it is.
void place_on_body(const importer::SourceModel& body, groom::Groom& groom);

/// Adds the body's nodes and meshes to a model of cards, without its hair, springs and textures. The cards hang from
/// its head: the node that is called so, else one that is made up where the skull is found, which what is above the
/// chin follows. Warns where none is found.
void add_body(importer::SourceModel body, importer::SourceModel& cards);

}  // namespace coif::cards
