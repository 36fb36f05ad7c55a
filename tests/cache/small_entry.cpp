#include "cache/small_entry.h"

namespace coif::cache {

CacheEntry small_entry() {
  CacheEntry entry;
  entry.dependencies = {{Dependency::Base::kSource, "wig.mtl", 0xFEDCBA9876543210u},
                        {Dependency::Base::kRecipe, "maps/mask.png", std::nullopt}};
  entry.questions = {{cook::TextureQuestion::Kind::kColors, {"wig"}, {"hair.png"}}};
  entry.report.passes = {{"import", 12.5}};
  entry.report.warnings = {{"C144", "name \xFF of no encoding"}};
  entry.report.notes = {"a note"};
  entry.report.left_out = {{"twist", "not needed", 1, 2, 3.5}};
  entry.report.triangles = 7;
  entry.report.simulated_bones = 9;
  entry.report.order = {8, 45.5, 46, 40, 44, 12, 3, 5, 0.25};
  entry.asset = {std::byte{1}, std::byte{2}, std::byte{3}};
  return entry;
}

}  // namespace coif::cache
