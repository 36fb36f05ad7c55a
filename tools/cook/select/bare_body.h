#pragma once

#include "import/source_model.h"

#include <string>

namespace coif::cook {

/// True where the form of a model alone says that it is a head, a bust or a body, and nothing on it hair: nearly all of
/// its surface are closed, full forms, as a head is and no strip, sheet or shell of hair; or the largest part is a
/// closed figure that stands on the ground. A ball of hair in one closed form looks the same: whoever asks this has
/// looked for names before.
[[nodiscard]] bool is_bare_body(const importer::SourceModel& source, double weld_distance);

/// The first node that is called hair and holds nothing: what an exporter leaves of curves or particles that it does
/// not write. Empty where there is none.
[[nodiscard]] std::string empty_hair_node(const importer::SourceModel& source);

}  // namespace coif::cook
