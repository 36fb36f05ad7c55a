#include "view/page/view_motions.h"

#include "motion/head_looks.h"

#include <algorithm>
#include <cstddef>

namespace coif {

std::string motion_words(bool has_clip) {
  std::string words;
  for (const MotionInfo& info : all_motions()) words.append(words.empty() ? "" : "|").append(info.name);
  for (const HeadLook& look : head_looks()) words.append("|").append(look.name);
  return has_clip ? words + "|clip" : words;
}

bool is_clip(float choice) { return choice >= float(all_motions().size() + head_looks().size()); }

std::unique_ptr<HeadPath> chosen_path(float choice) {
  const auto motions = all_motions();
  const auto looks = head_looks();
  // Whatever a script wrote there.
  const std::size_t number = choice >= 0 && choice < 1000 ? std::size_t(choice) : 0;
  if (number < motions.size()) return path_of(motions[number].motion);
  return path_of(looks[std::min(number - motions.size(), looks.size() - 1)]);
}

}  // namespace coif
