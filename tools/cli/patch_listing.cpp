#include "cli/cook_job.h"

#include "base/json.h"
#include "base/text.h"
#include "cli/options.h"
#include "render/gallery.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif::cli {
namespace {

std::string root_text(const cook::PatchListing& patch) {
  if (patch.root.empty()) return patch.is_unsure ? "?" : "-";
  return patch.root + (patch.is_unsure ? " ?" : "");
}

/// "3+7": the recipe's entry for the patch, if any.
std::string said_text(const cook::PatchListing& patch) {
  std::string text;
  for (const std::uint32_t o : patch.overrides) text += fmt::format("{}[{}]", text.empty() ? "" : " ", o);
  return text + (patch.kept ? "" : " left out");
}

std::string listing_text(const std::string& source, const std::vector<cook::PatchListing>& patches) {
  const auto unsure = std::ranges::count(patches, true, &cook::PatchListing::is_unsure);
  std::string text = fmt::format("{}: {}, {} unsure where the root is (?)\n", source,
                                 counted(patches.size(), "patch", "patches"), unsure);
  text += fmt::format("{:>6} {:>9}  {:^22} {:^19} {:>6}  {:<9} {:<14} {}\n", "index", "triangles", "middle (m)",
                      "size (m)", "island", "root", "chain", "mesh, material, overrides");
  for (const cook::PatchListing& patch : patches) {
    const Eigen::Vector3d &m = patch.middle, &s = patch.size;
    text += fmt::format(
        "{:>6} {:>9}  {:>6.3f}, {:>6.3f}, {:>6.3f} {:>5.3f} x {:>5.3f} x {:>5.3f} {:>6}  {:<9} {:<14} {}, {} {}\n",
        patch.number, patch.triangles, m.x(), m.y(), m.z(), s.x(), s.y(), s.z(), patch.island, root_text(patch),
        patch.chain.empty() ? "-" : patch.chain, patch.mesh, patch.material.empty() ? "-" : patch.material,
        said_text(patch));
  }
  return text;
}

nlohmann::ordered_json listing_json(const std::string& source, const std::vector<cook::PatchListing>& patches) {
  auto list = nlohmann::ordered_json::array();
  for (const cook::PatchListing& patch : patches) {
    list.push_back({{"index", patch.number},
                    {"mesh", patch.mesh},
                    {"material", patch.material},
                    {"island", patch.island},
                    {"triangles", patch.triangles},
                    {"middle", {patch.middle.x(), patch.middle.y(), patch.middle.z()}},
                    {"size", {patch.size.x(), patch.size.y(), patch.size.z()}},
                    {"root", patch.root},
                    {"unsure", patch.is_unsure},
                    {"chain", patch.chain},
                    {"overrides", patch.overrides},
                    {"kept", patch.kept}});
  }
  return {{"path", source}, {"patches", std::move(list)}};
}

/// The patches of the asset's finest level, by their numbers.
std::vector<render::PatchLabel> labels_of(const Asset& asset, const cook::ListedPatches& listed) {
  std::vector<render::PatchLabel> labels;
  for (const PatchRecord& patch : asset.lod_patches(0)) {
    const cook::PatchListing& known = listed.patches[listed.number_of_place[patch.file_place]];
    labels.push_back({std::to_string(known.number) + (known.is_unsure ? "?" : ""), known.is_unsure});
  }
  return labels;
}

tl::expected<void, ToolError> draw_chart(const CookOptions& options, const cook::CookResult& cooked) {
  const auto file = AssetFile::open(options.source(), FileBytes::copy(cooked.asset));
  if (!file) return tl::unexpected(file.error());
  render::PatchChartSettings settings;
  settings.title = fmt::format("{}: patches by index; ? unsure where the root is",
                               printable_ascii(std::filesystem::path(options.source()).filename().string()));
  ProgressLine line(options.source());
  const auto chart = render::render_patch_chart(file->asset(), labels_of(file->asset(), cooked.patches), settings,
                                                [&line](const std::string& caption) { line.show(caption.c_str()); });
  line.erase();
  if (!chart) return tl::unexpected(ToolError{chart.error().kind, options.source() + ": " + chart.error().message});
  return render::write_png(options.output, chart->sheet);
}

}  // namespace

tl::expected<Exit, ToolError> list_patches_of(const CookOptions& options, const RecipeChoice& choice,
                                              const Messages& messages) {
  if (!options.output.empty()) {
    if (auto png = choose_suffix(options.output, {".png"}); !png) return tl::unexpected(png.error());
    if (auto checked = check_output(options.output, {options.source(), choice.file}); !checked)
      return tl::unexpected(checked.error());
  }
  CookOptions draft = options;
  draft.draft = draft.list_patches = true;
  RecipeChoice drawn = choice;
  drawn.recipe.scene_draw = true;
  const auto cooked = cook_alone(draft, drawn, messages);
  if (!cooked) return tl::unexpected(cooked.error());
  messages.tell(cooked->report.warnings, options.source());
  if (!options.output.empty()) {
    if (auto checked = check_output(options.output, files_of(choice, cooked->inputs)); !checked)
      return tl::unexpected(checked.error());
    if (auto done = draw_chart(options, *cooked); !done) return tl::unexpected(done.error());
  }
  print_result(options.format == OutputFormat::kJson
                   ? json_text(listing_json(options.source(), cooked->patches.patches))
                   : listing_text(options.source(), cooked->patches.patches));
  return Exit::kOk;
}

}  // namespace coif::cli
