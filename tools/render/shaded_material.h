#pragma once

#include <coif/asset.h>

namespace coif {

/// The asset's material with another shading model; where it has none, that of the thesis's first gallery. Numbers that the
/// model needs and the material lacks get a recipe's defaults; a cut of the lights' sum that was made for another model is
/// dropped.
[[nodiscard]] MaterialRecord shaded_material(const Asset& asset, ShadingModel model);

}  // namespace coif
