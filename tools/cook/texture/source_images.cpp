#include "cook/texture/source_images.h"

#include "base/encodings.h"
#include "base/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <vector>

namespace coif::cook {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNamed = 8;

/// "a.png, b.png and 3 more".
std::string listed(const TextureFolder& folder, std::span<const fs::path> images) {
  std::vector<std::string> names;
  for (const fs::path& image : images.first(std::min(images.size(), kMostNamed))) {
    names.push_back(folder.short_name(image));
  }
  const std::string text = fmt::format("{}", fmt::join(names, ", "));
  return images.size() <= kMostNamed ? text : fmt::format("{} and {} more", text, images.size() - kMostNamed);
}

/// "./long%20hair.png" is a way to write "long hair.png".
bool is_spelling_of(const std::string& written, const std::string& name) {
  const auto names = [&](const std::string& text) {
    return fs::path(text).lexically_normal().generic_string() == name;
  };
  return names(written) || names(decoded_uri(written));
}

}  // namespace

const Image* SourceImages::of(const importer::SourceMaterial& material) {
  tell_other_maps(material);
  if (material.base_texture.image < source_.images.size()) return embedded(material, material.base_texture.image);
  return material.base_texture.path.empty() ? nullptr : beside(material);
}

const Image* SourceImages::normals_of(const importer::SourceMaterial& material) {
  const importer::SourceTexture& texture = material.normal_texture;
  if (texture.image < source_.images.size()) return embedded(material, texture.image);
  if (texture.path.empty()) return nullptr;
  const std::optional<fs::path> path = folder_.find(texture.path);
  note_question(TextureQuestion::Kind::kFind, {texture.path});
  if (path) return read(*path, fmt::format("material '{}': normal map {}", material.name, path->string()));
  findings_.warn(
      "C144", fmt::format("material '{}': normal map '{}': no such file beside the source; it is lit by its own form",
                          material.name, texture.path));
  return nullptr;
}

const Image* SourceImages::strands_of(const importer::SourceMaterial& material) {
  const std::uint32_t image = material.strand_texture.image;
  return image < source_.images.size() ? embedded(material, image) : nullptr;
}

const Image* SourceImages::embedded(const importer::SourceMaterial& material, std::uint32_t index) {
  const importer::SourceImage& image = source_.images[index];
  const std::string key = fmt::format("{}", index);
  if (const auto known = decoded_.find(key); known != decoded_.end()) {
    return known->second ? &*known->second : nullptr;
  }
  return keep(key, decode_image(image.bytes),
              fmt::format("material '{}': embedded image '{}'", material.name, image.name));
}

const Image* SourceImages::beside(const importer::SourceMaterial& material) {
  const std::string& written = material.base_texture.path;
  const std::optional<fs::path> path = folder_.find(written);
  note_question(TextureQuestion::Kind::kFind, {written});
  if (!path) {
    warn_of_absent(material);
    return nullptr;
  }
  if (!is_spelling_of(written, folder_.short_name(*path))) {
    findings_.warn("C145", fmt::format("material '{}': texture '{}' taken from {}", material.name, written,
                                       folder_.short_name(*path)));
  }
  return read(*path, fmt::format("material '{}': {}", material.name, path->string()));
}

const Image* SourceImages::guess(std::span<const std::string> names) {
  std::vector<fs::path> candidates = folder_.colors_of(names);
  note_question(TextureQuestion::Kind::kColors, {names.begin(), names.end()});
  if (candidates.empty()) {
    note_question(TextureQuestion::Kind::kImages, {});
    candidates = named_by_none();
    if (candidates.size() > 1) candidates.clear();
  } else if (candidates.size() > 1) {
    std::vector<fs::path> worded;
    std::ranges::copy_if(candidates, std::back_inserter(worded), [&](const fs::path& path) {
      return names_as_word(stem_of_image(path.filename().string()), names);
    });
    if (worded.size() == 1) candidates = worded;
  }
  if (candidates.empty()) {
    findings_.note("no material of the hair names a texture");
    return nullptr;
  }
  if (candidates.size() > 1) {
    findings_.warn(
        "C146",
        fmt::format("no material of the hair names a texture, and several images beside the source may be meant: {}; "
                    "choose one in the recipe: \"textures\": {{\"base_color\": \"{}\"}}",
                    listed(folder_, candidates), folder_.short_name(candidates[0])));
    return nullptr;
  }
  const Image* image = read(candidates[0], candidates[0].string());
  if (image != nullptr) {
    findings_.warn("C146", fmt::format("no material of the hair names a texture; {} is taken, which fits best; say "
                                       "\"textures\": {{\"base_color\": ...}} in the recipe if it is another",
                                       folder_.short_name(candidates[0])));
  }
  return image;
}

std::vector<fs::path> SourceImages::named_by_none() const {
  std::vector<fs::path> left;
  for (const fs::path& image : folder_.images()) {
    if (!names_color(stem_of_image(image.filename().string()))) continue;
    const bool is_named = std::ranges::any_of(source_.materials, [&](const importer::SourceMaterial& material) {
      const auto found = material.base_texture.path.empty() ? std::nullopt : folder_.find(material.base_texture.path);
      return found && *found == image;
    });
    if (!is_named) left.push_back(image);
  }
  return left;
}

const Image* SourceImages::read(const fs::path& path, const std::string& for_what) {
  const std::string key = path.string();
  if (const auto known = decoded_.find(key); known != decoded_.end()) {
    return known->second ? &*known->second : nullptr;
  }
  files_.push_back(path);
  return keep(key, read_image(path), for_what);
}

const Image* SourceImages::keep(const std::string& key, tl::expected<Image, std::string> image,
                                const std::string& for_what) {
  if (!image) {
    findings_.warn("C147", fmt::format("{}: {}; it is cooked without this texture", for_what, image.error()));
    decoded_.emplace(key, std::nullopt);
    return nullptr;
  }
  return &*decoded_.emplace(key, std::move(*image)).first->second;
}

void SourceImages::note_question(TextureQuestion::Kind kind, std::vector<std::string> words) {
  TextureQuestion question{kind, std::move(words), {}};
  question.answer = answer_to(question, folder_);
  questions_.push_back(std::move(question));
}

void SourceImages::warn_of_absent(const importer::SourceMaterial& material) {
  if (const auto outside = folder_.find_outside(material.base_texture.path)) {
    return findings_.warn(
        "C144",
        fmt::format(
            "material '{}': texture '{}' is a link to {}, outside the source's folder; if that is meant, allow it with "
            "--root {}; it is cooked without a base texture",
            material.name, material.base_texture.path, outside->string(), outside->parent_path().string()));
  }
  note_question(TextureQuestion::Kind::kImages, {});
  const std::string there =
      folder_.images().empty()
          ? "put it there"
          : fmt::format("put it there, or choose one of {} by \"textures.base_color\" in the recipe",
                        listed(folder_, folder_.images()));
  findings_.warn("C144", fmt::format("material '{}': texture '{}': no such file beside the source or in its texture "
                                     "folders; {}; it is cooked without a base texture",
                                     material.name, material.base_texture.path, there));
}

namespace {

constexpr std::string_view kRead[] = {".png", ".tga", ".jpg", ".jpeg", ".bmp", ".webp"};
constexpr std::string_view kNotRead[] = {".psd", ".dds", ".tif",  ".tiff",  ".exr",
                                         ".hdr", ".ktx", ".ktx2", ".basis", ".gif"};

// Whole words, as artists end names with them ("hair_n"), and beginnings of words.
constexpr std::string_view kOtherWords[] = {"n", "nm", "nrm", "r", "m", "s", "ao", "orm", "rma", "id", "flow", "depth"};
constexpr std::string_view kOtherBeginnings[] = {"norm",   "rough", "metal", "spec",   "gloss", "bump",
                                                 "height", "disp",  "occl",  "emis",   "mask",  "shift",
                                                 "thumb",  "alpha", "opac",  "tangent"};

constexpr std::string_view kProgramsNames[] = {"",     "material", "defaultmaterial", "default", "defaultobject",
                                               "mesh", "object",   "plane",           "cube",    "group",
                                               "none", "root",     "scene",           "model",   "lambert",
                                               "mat",  "phong",    "blinn",           "texture", "standard"};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || std::uint8_t(c) >= 0x80; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_one_of(std::string_view word, std::span<const std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

bool ends_in(const std::string& file, std::span<const std::string_view> suffixes) {
  const std::string lower = lower_case(file);
  return std::ranges::any_of(suffixes,
                             [&](std::string_view s) { return lower.size() > s.size() && lower.ends_with(s); });
}

/// Letters and digits alone, small.
std::string compact(const std::string& name) {
  std::string out;
  for (const char c : lower_case(name)) {
    if (is_letter(c) || is_digit(c)) out += c;
  }
  return out;
}

/// Runs of letters, small; a capital after a small letter begins a new one.
std::vector<std::string> words_of(const std::string& stem) {
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < stem.size(); ++i) {
    const bool capital = stem[i] >= 'A' && stem[i] <= 'Z';
    const char small = capital ? char(stem[i] - 'A' + 'a') : stem[i];
    if (!is_letter(small) || (capital && i > 0 && is_letter(stem[i - 1]))) words.emplace_back();
    if (is_letter(small)) words.back() += small;
  }
  return words;
}

}  // namespace

bool is_image_name(const std::string& file) { return ends_in(file, kRead); }

std::string stem_of_image(const std::string& file) {
  if (!ends_in(file, kRead) && !ends_in(file, kNotRead)) return file;
  return file.substr(0, file.find_last_of('.'));
}

bool names_color(const std::string& stem) {
  return std::ranges::none_of(words_of(stem), [](const std::string& word) {
    return is_one_of(word, kOtherWords) ||
           std::ranges::any_of(kOtherBeginnings, [&](std::string_view begin) { return word.starts_with(begin); });
  });
}

bool names_as_word(const std::string& stem, std::span<const std::string> names) {
  constexpr std::size_t kShortest = 3;
  std::string word;
  const std::string lower = lower_case(stem) + ' ';
  for (const char c : lower) {
    const bool is_part = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (is_part) word += c;
    if (is_part || word.empty()) continue;
    const bool is_name = std::ranges::any_of(names, [&](const std::string& name) { return lower_case(name) == word; });
    if (is_name && word.size() >= kShortest) return true;
    word.clear();
  }
  return false;
}

bool names_any(const std::string& stem, std::span<const std::string> names) {
  const std::string text = compact(stem);
  if (text.find("hair") != std::string::npos) return true;
  return std::ranges::any_of(names, [&](const std::string& name) {
    const std::string wanted = compact(name);
    const std::string word = wanted.substr(0, wanted.find_last_not_of("0123456789") + 1);
    return wanted.size() > 2 && !is_one_of(word, kProgramsNames) && text.find(wanted) != std::string::npos;
  });
}

// Maps of a material besides its base colour that are ignored; their author should be told.

void SourceImages::tell_other_maps(const importer::SourceMaterial& material) {
  const auto leave_out = [&](const std::string& map, const char* why) {
    LeftOut part{fmt::format("material '{}': {}", material.name, map), why};
    const bool is_new = std::ranges::find(findings_.left_out, part.what, &LeftOut::what) == findings_.left_out.end();
    if (is_new) findings_.leave_out(std::move(part));
  };
  for (const std::string& map : material.other_textures)
    leave_out(map, "it is not read; light is computed from the hair's form");
}

}  // namespace coif::cook
