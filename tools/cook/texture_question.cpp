#include "cook/texture_question.h"

namespace coif {
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
      return found ? std::vector{folder.short_name(*found)} : std::vector<std::string>{};
    }
    case TextureQuestion::Kind::kColors: return short_names(folder, folder.colors_of(question.words));
    case TextureQuestion::Kind::kImages: return short_names(folder, folder.images());
  }
  return {};
}

}  // namespace coif
