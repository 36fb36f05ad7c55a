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

CLI::Option* add_motion(CLI::App& app, HeadMotion& motion, const std::string& help) {
  std::vector<std::string> names;
  for (const MotionInfo& info : all_motions()) names.emplace_back(info.name);
  const std::string list = fmt::format("{}", fmt::join(names, ", "));
  const auto parse = [&motion, list](const std::string& word) {
    if (const auto built_in = find_motion(word)) {
      motion = {*built_in};
    } else if (const auto clip = find_clip(word)) {
      motion.clip = clip;
    } else {
      throw CLI::ValidationError("--motion", fmt::format("'{}' is not one of {}, and no file", word, list));
    }
  };
  return app
      .add_option_function<std::string>("--motion", parse,
                                        fmt::format("{}: {}, or a node's animation in a glTF", help, list))
      ->type_name("NAME|CLIP[:NODE]");
}

std::string motion_help() {
  std::string text = "Motions:\n";
  for (const MotionInfo& info : all_motions()) text += fmt::format("  {:<10}{}\n", info.name, info.description);
  return text;
}

}  // namespace coif
