#include "cli/motion_choice.h"

namespace coif {

std::span<const Choice<Motion>> motion_choices() {
  static const std::vector<Choice<Motion>> choices = [] {
    std::vector<Choice<Motion>> list;
    for (const MotionInfo& info : all_motions()) list.push_back({info.name, info.motion});
    return list;
  }();
  return choices;
}

std::string motion_help() {
  std::string text = "Motions:\n";
  for (const MotionInfo& info : all_motions()) text += fmt::format("  {:<10}{}\n", info.name, info.description);
  return text;
}

}  // namespace coif
