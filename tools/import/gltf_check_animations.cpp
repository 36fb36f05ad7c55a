#include "import/gltf_check_parts.h"

#include <cmath>

// Key times and the values at them.

namespace coif::importer {
namespace {

using nlohmann::json;

class AnimationChecks {
 public:
  explicit AnimationChecks(CheckedGltf& file) : file_(file) {}

  void run() {
    const json& animations = file_.list("animations");
    for (std::size_t a = 0; a < animations.size(); ++a) {
      place_ = gltf_part_name("animation", animations[a], a);
      const json& samplers = list_of(member(animations[a], "samplers"));
      const json& channels = list_of(member(animations[a], "channels"));
      if (samplers.empty() || channels.empty()) wrong("it has no channels or no samplers; bake it and export again");
      for (const json& sampler : samplers) check_times(sampler);
      for (const json& channel : channels) check_channel(channel, samplers);
    }
  }

 private:
  template <class... Args>
  void wrong(fmt::format_string<Args...> text, Args&&... args) {
    file_.faults.add(gltf_code::kAnimation, "{}: {}", place_, fmt::format(text, std::forward<Args>(args)...));
  }

  void check_times(const json& sampler) {
    for (const char* name : {"input", "output"}) {
      if (!index_of(member(sampler, name), file_.list("accessors").size()))
        return wrong("a sampler has no {}; bake it and export again", name);
    }
    const auto times = file_.read(member(sampler, "input"));
    if (!times) return;
    if (times->width != 1 || !times->is_float())
      return wrong("its key times are no list of floats; bake it and export again");
    for (std::size_t i = 0; i < times->numbers.size(); ++i) {
      const double time = times->numbers[i];
      if (!std::isfinite(time) || time < 0) return wrong("key {} is at {:g} s; bake it and export again", i, time);
      if (i > 0 && !(time > times->numbers[i - 1]))
        return wrong("key {} at {:g} s does not come after the one before it; bake it and export again", i, time);
    }
  }

  void check_channel(const json& channel, const json& samplers) {
    const auto index = index_of(member(channel, "sampler"), samplers.size());
    if (!index) return wrong("a channel has no sampler; bake it and export again");
    const json& target = member(channel, "target");
    const json& node = member(target, "node");
    if (!target.is_object() || (!node.is_null() && !index_of(node, file_.list("nodes").size())))
      return wrong("a channel moves no node; bake it and export again");
    const json& sampler = samplers[*index];
    const auto times = file_.read(member(sampler, "input")), values = file_.read(member(sampler, "output"));
    if (!times || !values) return;
    const std::string path = printable_text_of(member(target, "path"));
    const std::size_t width = path == "rotation" ? 4 : path == "weights" ? 1 : 3;
    if (path != "rotation" && path != "translation" && path != "scale" && path != "weights")
      return;  // Belongs to an extension.
    const std::size_t of_a_key = member(sampler, "interpolation") == "CUBICSPLINE" ? 3 : 1;
    const std::size_t wanted = times->count() * of_a_key;
    const bool fits = width == 1 ? values->count() % std::max<std::size_t>(wanted, 1) == 0 : values->count() == wanted;
    if (values->width != width || !fits)
      return wrong("its {} has {} values for {} keys; bake it and export again", path, values->count(), times->count());
    if (path == "rotation") check_rotations(*values, of_a_key);
  }

  void check_rotations(const StoredNumbers& values, std::size_t of_a_key) {
    constexpr double kMostOff = 0.00769;  // As in the Khronos validator.
    for (std::size_t i = of_a_key / 2; i < values.count(); i += of_a_key) {
      double squares = 0;
      for (std::size_t k = 0; k < 4; ++k) squares += std::pow(values.value(4 * i + k), 2);
      if (std::abs(std::sqrt(squares) - 1) <= kMostOff || !std::isfinite(squares)) continue;
      return file_.faults.add(gltf_code::kUnits,
                              "{}: rotation {} has the length {:.4g} and not 1; bake it and export again", place_, i,
                              std::sqrt(squares));
    }
  }

  CheckedGltf& file_;
  std::string place_;
};

}  // namespace

void check_gltf_animations(CheckedGltf& file) { AnimationChecks(file).run(); }

}  // namespace coif::importer
