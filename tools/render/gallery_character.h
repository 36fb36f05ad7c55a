#pragma once

#include "render/gallery.h"

#include <vector>

namespace coif::render {

/// Adds what shows hair on a character, by kCoifSolver whatever `picture` has. The asset outlives the galleries.
void add_character_galleries(const Asset& asset, PictureSettings picture, std::vector<Gallery>& galleries);

}  // namespace coif::render
