#include "cook/provenance.h"

#include "payload_hash.h"

#include <algorithm>

namespace coif {

namespace {

/// Of the complete recipe as print_recipe() writes it.
std::uint64_t recipe_hash(const Recipe& recipe) {
  const std::string text = print_recipe(recipe);
  return xxh64(std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace

ProvenanceRecord make_provenance(const SourceModel& source, const Recipe& recipe, std::uint64_t source_hash) {
  ProvenanceRecord record{};
  record.source_hash = source_hash;
  record.recipe_hash = recipe_hash(recipe);
  record.tool_version[0] = COIF_VERSION_MAJOR;
  record.tool_version[1] = COIF_VERSION_MINOR;
  record.tool_version[2] = COIF_VERSION_PATCH;
  std::copy_n(source.importer_version, 3, record.importer_version);
  return record;
}

}  // namespace coif
