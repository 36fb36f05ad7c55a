#include "cli/input_files.h"

#include "base/asset_refusal.h"
#include "base/text.h"
#include "cook/recipe/recipe_keys.h"
#include "cook/texture/source_images.h"

#include <fmt/format.h>

#include <cstring>
#include <system_error>
#include <utility>

namespace coif::cli {

bool is_source(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  const bool is_asset =
      bytes.size() >= sizeof kAssetMagic && std::memcmp(bytes.data(), kAssetMagic, sizeof kAssetMagic) == 0;
  return !is_asset && (importer::find_suffix(path).has_value() || cook::is_recipe_file(path));
}

tl::expected<AssetFile, ToolError> AssetFile::open(const std::filesystem::path& path) {
  auto bytes = FileBytes::read(path);
  if (!bytes) return tl::unexpected(bytes.error());
  return open(path, std::move(*bytes));
}

tl::expected<AssetFile, ToolError> AssetFile::open(const std::filesystem::path& path, FileBytes bytes) {
  AssetFile file(std::move(bytes));
  const LoadStatus status = open_whole(file.bytes_.span(), file.asset_);
  if (!status) {
    const ToolError refusal = refusal_of(status);
    return tl::unexpected(ToolError{refusal.kind, path.string() + ": " + refusal.message});
  }
  return file;
}

namespace {

namespace fs = std::filesystem;

tl::expected<RecipeChoice, ToolError> read_choice(const fs::path& file, const cook::RecipeBeginning& beginning) {
  auto recipe = cook::read_recipe(file, beginning);
  if (!recipe) return tl::unexpected(recipe.error());
  return RecipeChoice{std::move(*recipe), file.parent_path(), file};
}

}  // namespace

tl::expected<RecipeChoice, ToolError> choose_recipe(const fs::path& source, const std::optional<std::string>& named,
                                                    const Messages& messages, const cook::RecipeBeginning& beginning) {
  if (cook::is_recipe_file(source)) {
    if (named) return usage(fmt::format("{}: is a recipe itself; leave --recipe out", source.string()));
    return read_choice(source, beginning);
  }
  if (named) return read_choice(*named, beginning);
  fs::path beside = source;
  beside.replace_extension(".recipe.json");
  std::error_code ignored;
  if (source.empty() || !fs::exists(beside, ignored)) {
    auto recipe = cook::parse_recipe("{}", "--preset", beginning);
    if (!recipe) return tl::unexpected(recipe.error());
    return RecipeChoice{std::move(*recipe), source.parent_path(), {}};
  }
  messages.note(fmt::format("{}: used, as it lies beside the source; --recipe names another", beside.string()));
  auto choice = read_choice(beside, beginning);
  if (choice) choice->is_found = true;
  return choice;
}

tl::expected<void, ToolError> check_named_files(const RecipeChoice& choice, std::span<const fs::path> roots) {
  if (!choice.is_found) return {};
  const std::vector<fs::path> folders = folders_of_source(choice.file, roots);
  for (const std::string& name : cook::files_named_by(choice.recipe)) {
    const fs::path path = choice.directory / name;
    std::error_code error;
    if (!fs::exists(fs::symlink_status(path, error)) || lies_in(path, folders)) continue;
    return file_failure(
        ToolError::Kind::kBadInput, choice.file,
        "names '{}', which lies outside of its folder, and --require-sandbox trusts no recipe that nobody "
        "named; allow its folder with --root, or name the recipe with --recipe",
        printable_text(name, 100));
  }
  return {};
}

tl::expected<RecipeChoice, ToolError> held_recipe(const fs::path& source, const std::optional<std::string>& named,
                                                  bool is_asked, std::span<const fs::path> roots,
                                                  const Messages& messages, const cook::RecipeBeginning& beginning) {
  auto choice = choose_recipe(source, named, messages, beginning);
  if (!choice || !is_asked) return choice;
  if (auto held = check_named_files(*choice, roots); !held) return tl::unexpected(held.error());
  return choice;
}

std::vector<fs::path> files_of(const RecipeChoice& choice) {
  std::vector<fs::path> files{choice.file};
  for (const std::string& name : cook::files_named_by(choice.recipe)) files.push_back(choice.directory / name);
  return files;
}

std::vector<fs::path> files_of(const RecipeChoice& choice, const cook::CookInputs& inputs) {
  std::vector<fs::path> files = files_of(choice);
  for (const auto* const found : {&inputs.source_files, &inputs.recipe_files, &inputs.named_files})
    files.insert(files.end(), found->begin(), found->end());
  return files;
}

std::vector<fs::path> files_of(const importer::SourceModel& model) {
  std::vector<fs::path> files = cook::named_image_files(model);
  files.emplace_back(model.path);
  files.insert(files.end(), model.side_files.begin(), model.side_files.end());
  return files;
}

void choose_body(const fs::path& body, RecipeChoice& choice) {
  if (body.empty()) return;
  const fs::path from = choice.directory.empty() ? fs::path(".") : choice.directory;
  choice.recipe.cards_body =
      fs::absolute(body).lexically_normal().lexically_proximate(fs::absolute(from).lexically_normal()).string();
}

importer::ImportSettings import_settings(const cook::Recipe& recipe, std::vector<fs::path> roots) {
  importer::ImportSettings settings;
  settings.roots = std::move(roots);
  if (recipe.metres_per_unit > 0) settings.metres_per_unit = recipe.metres_per_unit;
  settings.variant = recipe.source_variant;
  settings.meshes = recipe.hair_meshes;
  if (recipe.up_axis == cook::RecipeUpAxis::kX) settings.up_axis = importer::UpAxis::kX;
  if (recipe.up_axis == cook::RecipeUpAxis::kY) settings.up_axis = importer::UpAxis::kY;
  if (recipe.up_axis == cook::RecipeUpAxis::kZ) settings.up_axis = importer::UpAxis::kZ;
  return settings;
}

}  // namespace coif::cli
