#include "fuzz/targets.h"

#include "gltf/document.h"
#include "import/clip_file.h"
#include "import/fbx_objects.h"
#include "import/reader_process.h"
#include "import/source_model.h"
#include "import/vrm_springs.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace coif::fuzz {
namespace {

void check_clip(const importer::ClipFile& clip) {
  promise(!clip.keys.empty(), "a clip has keys");
  double last = -1;
  for (const importer::NodeKey& key : clip.keys) {
    promise(key.seconds >= 0 && key.seconds > last && std::isfinite(key.seconds), "keys ascend from 0 or later");
    promise(key.position.allFinite(), "positions are finite");
    promise(std::abs(key.rotation.norm() - 1) < 1.0e-6, "rotations have unit length");
    last = key.seconds;
  }
}

importer::SourceNode node(const char* name, std::uint32_t parent, const Eigen::Affine3d& model_from_node) {
  return {name, parent, model_from_node};
}

/// What an importer would have made of a scene like the seeds': strip, body > head > hair_1 > hair_2 > hair_end, and
/// beside hair_1 a mirrored and a flattened node.
importer::SourceModel model_before_extensions() {
  const auto at = [](double y) { return Eigen::Affine3d(Eigen::Translation3d(0, y, 0)); };
  importer::SourceModel model;
  model.nodes = {node("root", importer::kNoIndex, at(0)),
                 node("strip", 0, at(0)),
                 node("body", 0, at(0)),
                 node("head", 2, at(1)),
                 node("hair_1", 3, at(0.9)),
                 node("hair_2", 4, at(0.8)),
                 node("hair_end", 5, at(0.7)),
                 node("mirrored", 3, at(1) * Eigen::Scaling(-1.0, 1.0, 1.0)),
                 node("flat", 3, at(1) * Eigen::Scaling(1.0, 0.0, 1.0))};
  importer::SourceMesh mesh;
  mesh.node = 1;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {0, 1, 2};
  model.meshes = {mesh};
  return model;
}

}  // namespace

bool try_fbx_objects(Input input) {
  const auto read = importer::FbxObjects::read({reinterpret_cast<const char*>(input.data()), input.size()});
  if (!read) return false;
  promise(read->all().size() <= input.size(), "an object takes a byte of the file");
  std::size_t shapes = 0;
  for (const importer::FbxObject& object : read->all()) {
    promise(read->find(object.id) == &object, "an object is found by its id");
    promise(std::isfinite(object.percent), "percents are finite");
    if (object.kind != importer::FbxKind::kMesh) continue;
    for (const importer::FbxShape& shape : read->shapes(object))
      promise(std::isfinite(shape.weight), "weights are finite");
    shapes += read->shapes(object).size();
  }
  promise(shapes <= input.size(), "a shape takes a byte of the file");
  return !read->all().empty();
}

bool try_clip(Input input) {
  static const LoneFile file("clip.glb");
  bool accepted = false;
  for (const char* const node : {"", "head"}) {
    const auto clip = importer::read_clip(file.with(input), node);
    if (clip) check_clip(*clip);
    promise(clip || clip.error().kind == ToolError::Kind::kBadInput, "a refusal is the file's fault");
    accepted = accepted || clip;
  }
  return accepted;
}

bool try_model_stream(Input input) {
  importer::ImportOutcome outcome = tl::unexpected(ToolError{ToolError::Kind::kInternal, "untouched"});
  if (!importer::decode_outcome(input, outcome)) {
    promise(!outcome && outcome.error().message == "untouched", "a refusal leaves the outcome untouched");
    return false;
  }
  promise(!outcome || importer::find_model_fault(*outcome).empty(), "a model that was accepted has no fault");
  promise(std::ranges::equal(importer::encode_outcome(outcome), input),
          "what was accepted is encoded to the same bytes");
  return true;
}

bool try_vrm(Input input) {
  static const LoneFile file("model.vrm");
  static const importer::SourceModel before = model_before_extensions();
  importer::SourceModel model = before;
  const Eigen::Affine3d model_from_file(Eigen::AngleAxisd(1.5, Eigen::Vector3d::UnitX()) * Eigen::Scaling(0.01));
  const auto document = gltf::read_gltf_json(file.with(input));
  if (!document) return false;
  static const std::vector<std::uint32_t> kNodeOf{1, 2, 3, 4, 5, 6, 7, 8};  // The document's nodes lack the root.
  importer::read_vrm_extensions(member(*document, "extensions"), kNodeOf, model_from_file, model);
  const std::string fault = importer::find_model_fault(model);
  promise(fault.empty(), fault.c_str());
  promise(model.warnings.size() < 20, "many faults give few warnings");
  for (const std::string& warning : messages_of(model.warnings))
    promise(warning.size() < 4000, "a warning is a sentence");
  return !model.springs.empty();
}

}  // namespace coif::fuzz
