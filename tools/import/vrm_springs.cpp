#include "import/vrm_springs.h"

#include "import/gltf_json.h"
#include "import/json_values.h"
#include "import/spring_sink.h"
#include "import/vrm0_springs.h"
#include "import/vrm1_springs.h"

#include <fmt/format.h>

#include <string_view>

namespace coif {
namespace {

using nlohmann::json;

// 0.x lists bones with their names, 1.0 has them as members.
const json& head_entry(const json& extensions) {
  const json& bones1 = member(member(member(extensions, "VRMC_vrm"), "humanoid"), "humanBones");
  if (bones1.is_object()) return member(member(bones1, "head"), "node");
  for (const json& bone : list_of(member(member(member(extensions, "VRM"), "humanoid"), "humanBones"))) {
    if (printable_text_of(member(bone, "bone")) == "head") return member(bone, "node");
  }
  return member(json(), "");
}

void read_head(const json& extensions, SpringSink& sink) {
  const json& entry = head_entry(extensions);
  if (entry.is_null()) return;
  if (const auto node = sink.find_node(entry)) {
    sink.set_head(*node);
  } else {
    sink.ignore("the humanoid's head is not a node of the scene; the head is found by its name");
  }
}

}  // namespace

void read_vrm_extensions(const std::filesystem::path& path, const Eigen::Affine3d& model_from_file,
                         SourceModel& model) {
  // assimp drops extensions.
  constexpr std::string_view kMembers[] = {"nodes", "scene", "scenes", "extensions"};
  const auto document = read_gltf_json(path, kMembers);
  if (!document) {
    model.warnings.push_back(
        fmt::format("extensions cannot be read, so VRM spring bones would be ignored: {}; open it "
                    "in a modelling tool and export it again",
                    document.error()));
    return;
  }
  const json& extensions = member(*document, "extensions");
  if (!extensions.is_object()) return;
  SpringSink sink(*document, model_from_file, model);
  read_head(extensions, sink);
  const json& springs1 = member(extensions, "VRMC_springBone");
  if (springs1.is_null()) {
    read_vrm0_springs(member(member(extensions, "VRM"), "secondaryAnimation"), sink);
  } else {
    read_vrm1_springs(springs1, sink);
  }
}

}  // namespace coif
