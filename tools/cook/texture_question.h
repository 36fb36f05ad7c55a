#pragma once

#include "cook/texture_folder.h"

#include <string>
#include <vector>

namespace coif {

/// What a cook asked of the folder beside its source, and what it learned. As long as a folder gives the same answers to the
/// same questions, what else comes and goes there does not matter.
struct TextureQuestion {
  enum class Kind {
    kFind,    ///< `words`: one path as written in the source. Answered by the file's short name, or by nothing.
    kColors,  ///< `words`: what the hair is called. Answered by the short names of the images that may colour it.
    kImages,  ///< No words. Answered by all images' short names.
  };
  Kind kind = Kind::kFind;
  std::vector<std::string> words;
  std::vector<std::string> answer;
};

/// What the folder answers today.
[[nodiscard]] std::vector<std::string> answer_to(const TextureQuestion& question, const TextureFolder& folder);

}  // namespace coif
