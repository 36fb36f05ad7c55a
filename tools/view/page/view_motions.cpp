#include "view/page/view_motions.h"

#include "motion/head_looks.h"

#include <algorithm>
#include <cstddef>

namespace coif::view {

std::string motion_words(bool has_clip) {
  std::string words;
  for (const motion::MotionInfo& info : motion::all_motions()) words.append(words.empty() ? "" : "|").append(info.name);
  for (const motion::HeadLook& look : motion::head_looks()) words.append("|").append(look.name);
  return has_clip ? words + "|clip" : words;
}

bool is_clip(float choice) { return choice >= float(motion::all_motions().size() + motion::head_looks().size()); }

std::unique_ptr<motion::HeadPath> chosen_path(float choice) {
  const auto motions = motion::all_motions();
  const auto looks = motion::head_looks();
  // Whatever a script wrote there.
  const std::size_t number = choice >= 0 && choice < 1000 ? std::size_t(choice) : 0;
  if (number < motions.size()) return motion::path_of(motions[number].motion);
  return motion::path_of(looks[std::min(number - motions.size(), looks.size() - 1)]);
}

}  // namespace coif::view
