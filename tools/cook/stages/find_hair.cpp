#include "cook/stages/stages.h"

#include "cook/select/mesh_topology.h"
#include "cook/select/select_hair.h"
#include "cook/size/settle_size.h"
#include "cook/strands/patches.h"

namespace coif::cook {

tl::expected<SourceHair, ToolError> find_hair(const importer::SourceModel& source, const HairRecipe& recipe,
                                              const DrawnRecipe& drawn, const CookSettings& settings, CookLog& log) {
  Findings& findings = log.findings();
  SettledSource settled = log.pass("size", [&] { return settle_size(source, recipe, findings); });
  SourceHair hair{std::move(settled.model), {}, {}};
  const importer::SourceModel& model = hair.model(source);

  // The hair may have been found when the size was judged.
  auto mesh = log.pass("select", [&]() -> tl::expected<HairMesh, ToolError> {
    if (!settled.hair) return select_hair(model, recipe, findings);
    findings.append(settled.hair->findings);
    return std::move(settled.hair->mesh);
  });
  if (!mesh) return tl::unexpected(mesh.error());
  hair.mesh = std::move(*mesh);

  auto color = log.pass("base color", [&] {
    warn_of_odd_size(hair.mesh, findings);
    return find_base_color(model, hair.mesh, drawn, settings, findings);
  });
  if (!color) return tl::unexpected(color.error());
  hair.color = std::move(*color);
  return hair;
}

}  // namespace coif::cook
