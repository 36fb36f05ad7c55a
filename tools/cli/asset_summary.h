#pragma once

#include "base/json.h"
#include "cook/select/hair_candidates.h"
#include "import/source_model.h"
#include "render/picture.h"

#include <coif/asset.h>

#include <CLI/CLI.hpp>

#include <string>

namespace coif::cli {

/// Counts, chunk sizes and settings of an open asset as JSON; the keys are stable.
[[nodiscard]] std::string asset_json(const Asset& asset);

/// The summary as a table for people. `name`: the file's.
[[nodiscard]] std::string asset_text(const std::string& name, const Asset& asset);

/// The tuning of the asset, errors in percent of the chain's length; null where it was not tuned. The keys are stable.
[[nodiscard]] nlohmann::ordered_json tuning_json(const Asset& asset);

/// One entry for each frame rate and number of sub-steps that was measured. The keys are stable.
[[nodiscard]] nlohmann::ordered_json quality_json(const Asset& asset);

/// Tuning and quality as lines for people; empty where the asset has neither.
[[nodiscard]] std::string tuning_text(const Asset& asset);

/// The names that a recipe can speak of: meshes, materials, and nodes as a tree with the bones marked.
[[nodiscard]] std::string list_text(const importer::SourceModel& model);
[[nodiscard]] std::string list_json(const importer::SourceModel& model);

/// The parts of a model that may be hair, each with its probability, the reason and the recipe's line.
[[nodiscard]] std::string candidates_text(const importer::SourceModel& model, const cook::HairCandidates& candidates);
/// The same with all features, and with middles of triangles, for scripts.
[[nodiscard]] std::string candidates_json(const importer::SourceModel& model, const cook::HairCandidates& candidates);
/// They from three sides, each in its own colour, with a legend; everything else is grey.
[[nodiscard]] render::Picture candidates_chart(const importer::SourceModel& model,
                                               const cook::HairCandidates& candidates);

/// The program's manual page, in roff for man(1): the help of each command, and more for which help has no room.
[[nodiscard]] std::string manual_page(const CLI::App& program);

}  // namespace coif::cli
