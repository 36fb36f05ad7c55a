#include "cache/manifest.h"

#include "base/files.h"
#include "base/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace coif::cache {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMaxManifestBytes = std::size_t{64} << 20;
constexpr const char* kForm = R"({"assets": ["bob.fbx", {"source": "b.glb", "recipe": "r.json", "output": "b.coif"}]})";

/// A sentence without the manifest's name.
using Fault = tl::unexpected<std::string>;

bool climbs(const fs::path& path) {
  return path.is_absolute() || std::ranges::find(path, fs::path("..")) != path.end();
}

tl::expected<std::string, std::string> text_of(const json& asset, const char* key) {
  const auto found = asset.find(key);
  if (found == asset.end()) return std::string{};
  if (!found->is_string() || found->get_ref<const std::string&>().empty()) {
    return Fault(fmt::format("\"{}\" must be a path, not {}", key, excerpt(found->dump())));
  }
  return found->get<std::string>();
}

tl::expected<CookRequest, std::string> from_paths(const std::string& source, const std::string& recipe,
                                                  const std::string& output, const fs::path& inputs,
                                                  const fs::path& outputs) {
  const fs::path place = output.empty() ? fs::path(source).replace_extension(".coif") : fs::path(output);
  if (climbs(place)) {
    return Fault(output.empty()
                     ? fmt::format("{} lies outside the manifest's folder; give it an \"output\"", excerpt(source))
                     : fmt::format("\"output\": {} leaves the output folder; name a path below it", excerpt(output)));
  }
  const fs::path file = (outputs / place).lexically_normal();
  if (!file.has_filename() || file == outputs.lexically_normal()) {
    return Fault(fmt::format("\"output\": {} is a folder; name a file", excerpt(output)));
  }
  CookRequest request{(inputs / source).string(), {}, file.string()};
  if (!recipe.empty()) request.recipe = (inputs / recipe).string();
  return request;
}

tl::expected<CookRequest, std::string> read_asset(const json& asset, const fs::path& inputs, const fs::path& outputs) {
  const bool is_path = asset.is_string() && !asset.get_ref<const std::string&>().empty();
  if (is_path) return from_paths(asset.get<std::string>(), {}, {}, inputs, outputs);
  if (!asset.is_object() || !asset.contains("source")) return Fault(fmt::format("no \"source\"; as in {}", kForm));
  for (const auto& [key, value] : asset.items()) {
    if (key != "source" && key != "recipe" && key != "output") {
      return Fault(fmt::format("\"{}\" is none of source, recipe, output", excerpt(key)));
    }
  }
  const auto source = text_of(asset, "source"), recipe = text_of(asset, "recipe"), output = text_of(asset, "output");
  for (const auto* text : {&source, &recipe, &output}) {
    if (!*text) return Fault(text->error());
  }
  return from_paths(*source, *recipe, *output, inputs, outputs);
}

tl::expected<json, std::string> parse(std::span<const std::byte> bytes) {
  if (bytes.size() > kMaxManifestBytes) return Fault("over 64 MiB; split it into several manifests");
  auto document = parse_shallow_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!document) return document;
  const bool fits = document->is_object() && document->size() == 1 && document->contains("assets");
  if (!fits || !(*document)["assets"].is_array()) {
    return Fault(fmt::format("not a manifest; a manifest looks like {}", kForm));
  }
  return std::move((*document)["assets"]);
}

}  // namespace

tl::expected<std::vector<CookRequest>, ToolError> read_manifest(const fs::path& manifest,
                                                                const fs::path& output_folder) {
  const auto bytes = FileBytes::read(manifest);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto bad = [&manifest](const std::string& what) {
    return tl::unexpected(ToolError{ToolError::Kind::kBadInput, manifest.string() + ": " + what});
  };
  const auto assets = parse(bytes->span());
  if (!assets) return bad(assets.error());
  std::vector<CookRequest> requests;
  std::map<std::string, std::size_t> owners;
  for (std::size_t i = 0; i < assets->size(); ++i) {
    auto request = read_asset((*assets)[i], manifest.parent_path(), output_folder);
    if (!request) return bad(fmt::format("assets[{}]: {}", i, request.error()));
    const auto [owner, is_new] = owners.emplace(request->output, i);
    if (!is_new)
      return bad(fmt::format("assets[{}] and assets[{}] would both become {}", owner->second, i, request->output));
    requests.push_back(std::move(*request));
  }
  return requests;
}

std::vector<CookRequest> share_of(const std::vector<CookRequest>& all, Share share) {
  std::vector<CookRequest> mine;
  for (std::size_t i = share.index - 1; i < all.size(); i += share.count) mine.push_back(all[i]);
  return mine;
}

namespace {

/// The escaping that Make and Ninja read: a backslash is literal unless it precedes a blank or a hash, where two of
/// them stand for one.
std::string escaped(const std::string& path) {
  std::string text;
  std::size_t backslashes = 0;
  for (const char c : path) {
    if (c == ' ' || c == '#') text.append(backslashes + 1, '\\');
    if (c == '$') text += '$';
    text += c;
    backslashes = c == '\\' ? backslashes + 1 : 0;
  }
  return text;
}

}  // namespace

tl::expected<std::string, ToolError> depfile_text(const fs::path& target, std::span<const fs::path> inputs) {
  std::set<std::string> seen;
  std::string text = escaped(target.string()) + ":";
  std::string all = target.string();
  for (const fs::path& input : inputs) {
    std::error_code error;
    if (!fs::exists(input, error) || !seen.insert(input.string()).second) continue;
    text += " \\\n  " + escaped(input.string());
    all += input.string();
  }
  if (all.find_first_of("\r\n") == std::string::npos) return text + "\n";
  return tl::unexpected(ToolError{ToolError::Kind::kUsage,
                                  target.string() + ": a path with a line break cannot stand in a depfile; rename it"});
}

}  // namespace coif::cache
