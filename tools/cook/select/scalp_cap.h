#pragma once

#include "cook/select/select_hair.h"

#include <vector>

namespace coif::cook {

/// Meshes that lie close under the hair that is chosen already, within a tenth of its width, on a good part of the
/// head, and nowhere else: the caps that artists paint between strips so that no skin shows. A head comes out of its
/// hair at the face, lashes and teeth are small beside it, a body reaches beyond it. Per mesh of the source; false for
/// those that gave hair.
[[nodiscard]] std::vector<bool> find_scalp_caps(const importer::SourceModel& source, const HairChoice& choice);

}  // namespace coif::cook
