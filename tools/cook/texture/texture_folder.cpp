#include "base/encodings.h"
#include "base/files.h"
#include "base/side_file.h"
#include "base/text.h"
#include "cook/texture/source_images.h"

#include <algorithm>

namespace coif::cook {
namespace {

namespace fs = std::filesystem;

/// A folder with more entries is somebody's download folder; further entries are not looked at.
constexpr std::size_t kMaxEntries = 4096;

constexpr const char* kCustomaryFolders[] = {"textures", "texture", "tex",          "maps",     "images",
                                             "image",    "img",     "sourceimages", "materials"};

/// Entries sorted by name: the order of a directory differs between machines.
std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (entries.size() == kMaxEntries) break;
    entries.push_back(it->path());
  }
  std::ranges::sort(entries);
  return entries;
}

/// Ignores case; a '?', which no Windows file name contains, stands for a letter of another alphabet.
bool is_called(const std::string& file, const std::string& written) {
  const std::string own = lower_case(file), wanted = lower_case(written);
  return own == wanted || (wanted.find('?') != std::string::npos && ascii_shape(own) == ascii_shape(wanted)) ||
         utf8_of(own) == wanted;
}

std::optional<fs::path> entry_called(const fs::path& folder, const std::string& name) {
  std::error_code error;
  if (fs::exists(folder / name, error)) return folder / name;
  const auto entries = entries_of(folder);
  const auto same =
      std::ranges::find_if(entries, [&](const fs::path& entry) { return is_called(entry.filename().string(), name); });
  return same == entries.end() ? std::nullopt : std::optional(*same);
}

std::vector<fs::path> customary_folders_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const fs::path& entry : entries_of(folder)) {
    const std::string name = lower_case(entry.filename().string());
    const bool customary = std::ranges::find(kCustomaryFolders, name) != std::end(kCustomaryFolders);
    if (customary && fs::is_directory(entry, error)) found.push_back(entry);
  }
  return found;
}

}  // namespace

TextureFolder::TextureFolder(const fs::path& source, std::span<const fs::path> roots)
    : root_(source.parent_path()), leaves_root_(!roots.empty()), real_roots_(folders_of_source(source, roots)) {
  if (root_.empty()) root_ = ".";
  if (real_roots_.empty()) return;
  list(root_);
  for (const fs::path& folder : customary_folders_in(root_)) {
    if (is_inside(folder)) list(folder);
  }
  // For "Export/hair.fbx" beside "Textures": a link is not followed from there.
  std::error_code error;
  const fs::path above = real_roots_[0].parent_path();
  for (const fs::path& folder : customary_folders_in(root_ / "..")) {
    const fs::path real = fs::canonical(folder, error);
    if (error || fs::is_symlink(folder, error) || real.parent_path() != above || real == real_roots_[0]) continue;
    real_roots_.push_back(real);
    list(folder);
  }
}

void TextureFolder::list(const fs::path& folder) {
  for (const fs::path& entry : entries_of(folder)) {
    std::error_code error;
    if (!is_image_name(entry.filename().string()) || !fs::is_regular_file(entry, error) || !is_inside(entry)) continue;
    images_.push_back(entry);
  }
}

bool TextureFolder::is_inside(const fs::path& path) const { return lies_in(path, real_roots_); }

std::optional<fs::path> TextureFolder::find(const std::string& written) const {
  const std::string slashes = with_slashes(written);
  for (const std::string& spelling : {slashes, decoded_uri(slashes)}) {
    if (auto path = follow(spelling); path && is_inside(*path)) return path;
  }
  for (const std::string& spelling : {slashes, decoded_uri(slashes)}) {
    if (auto path = find_by_name(last_name(spelling))) return path;
  }
  return {};
}

std::optional<fs::path> TextureFolder::find_outside(const std::string& written) const {
  const std::string slashes = decoded_uri(with_slashes(written));
  for (const std::string& spelling : {slashes, last_name(slashes)}) {
    const auto path = follow(spelling);
    std::error_code error;
    if (path && !is_inside(*path)) return fs::canonical(*path, error);
  }
  return {};
}

std::optional<fs::path> TextureFolder::follow(const std::string& written) const {
  fs::path at = root_;
  for (const fs::path& part : fs::path(written)) {
    const std::string name = part.string();
    if (name == ".") continue;
    const bool is_way_out = name == ".." || name == "/";
    const bool is_name = !name.empty() && name.find_first_of(std::string_view("/:\0", 3)) == std::string::npos;
    const auto next = is_way_out && leaves_root_ ? std::optional(at / part)
                      : is_name && !is_way_out   ? entry_called(at, name)
                                                 : std::nullopt;
    if (!next) return {};
    at = *next;
  }
  std::error_code error;
  return fs::is_regular_file(at, error) ? std::optional(at) : std::nullopt;
}

std::optional<fs::path> TextureFolder::find_by_name(const std::string& name) const {
  const auto first = [&](const auto& fits) -> std::optional<fs::path> {
    const auto found = std::ranges::find_if(images_, [&](const fs::path& p) { return fits(p.filename().string()); });
    return found == images_.end() ? std::nullopt : std::optional(*found);
  };
  if (name.empty()) return {};
  if (auto same = first([&](const std::string& file) { return file == name; })) return same;
  if (auto same = first([&](const std::string& file) { return is_called(file, name); })) return same;
  const std::string stem = lower_case(stem_of_image(name));
  return first([&](const std::string& file) { return lower_case(stem_of_image(file)) == stem; });
}

std::vector<fs::path> TextureFolder::colors_of(std::span<const std::string> names) const {
  std::vector<fs::path> found;
  for (const fs::path& image : images_) {
    const std::string stem = stem_of_image(image.filename().string());
    if (names_color(stem) && names_any(stem, names)) found.push_back(image);
  }
  return found;
}

std::string TextureFolder::short_name(const fs::path& path) const {
  return path.lexically_proximate(root_).generic_string();
}

std::vector<fs::path> named_image_files(const importer::SourceModel& source) {
  std::vector<fs::path> files;
  if (source.named_images.empty()) return files;
  const TextureFolder folder(source.path, source.roots);
  for (const std::string& name : source.named_images) {
    files.push_back(fs::path(source.path).parent_path() / decoded_uri(with_slashes(name)));
    if (const auto found = folder.find(name)) files.push_back(*found);
  }
  return files;
}

namespace {

std::vector<std::string> short_names(const TextureFolder& folder, std::span<const std::filesystem::path> images) {
  std::vector<std::string> names;
  for (const auto& image : images) names.push_back(folder.short_name(image));
  return names;
}

}  // namespace

std::vector<std::string> answer_to(const TextureQuestion& question, const TextureFolder& folder) {
  switch (question.kind) {
    case TextureQuestion::Kind::kFind: {
      const auto found = question.words.empty() ? std::nullopt : folder.find(question.words[0]);
      if (found) return {folder.short_name(*found)};
      if (!question.words.empty() && folder.find_outside(question.words[0])) return {"leads", "outside"};
      return {};
    }
    case TextureQuestion::Kind::kColors: return short_names(folder, folder.colors_of(question.words));
    case TextureQuestion::Kind::kImages: return short_names(folder, folder.images());
  }
  return {};
}

}  // namespace coif::cook
