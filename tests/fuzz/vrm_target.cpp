#include "fuzz/lone_file.h"
#include "fuzz/promise.h"
#include "fuzz/targets.h"

#include "import/source_model.h"
#include "import/vrm_springs.h"

#include <Eigen/Geometry>

#include <string>

namespace coif::fuzz {
namespace {

SourceNode node(const char* name, std::uint32_t parent, const Eigen::Affine3d& model_from_node) {
  return {name, parent, model_from_node};
}

/// What an importer would have made of a scene like the seeds': strip, body > head > hair_1 > hair_2 > hair_end, and beside
/// hair_1 a mirrored and a flattened node.
SourceModel model_before_extensions() {
  const auto at = [](double y) { return Eigen::Affine3d(Eigen::Translation3d(0, y, 0)); };
  SourceModel model;
  model.nodes = {node("root", kNoIndex, at(0)),
                 node("strip", 0, at(0)),
                 node("body", 0, at(0)),
                 node("head", 2, at(1)),
                 node("hair_1", 3, at(0.9)),
                 node("hair_2", 4, at(0.8)),
                 node("hair_end", 5, at(0.7)),
                 node("mirrored", 3, at(1) * Eigen::Scaling(-1.0, 1.0, 1.0)),
                 node("flat", 3, at(1) * Eigen::Scaling(1.0, 0.0, 1.0))};
  SourceMesh mesh;
  mesh.node = 1;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {0, 1, 2};
  model.meshes = {mesh};
  return model;
}

}  // namespace

bool try_vrm(Input input) {
  static const LoneFile file("model.vrm");
  static const SourceModel before = model_before_extensions();
  SourceModel model = before;
  const Eigen::Affine3d model_from_file(Eigen::AngleAxisd(1.5, Eigen::Vector3d::UnitX()) * Eigen::Scaling(0.01));
  read_vrm_extensions(file.with(input), model_from_file, model);
  const std::string fault = find_model_fault(model);
  promise(fault.empty(), fault.c_str());
  promise(model.warnings.size() < 20, "many faults give few warnings");
  for (const std::string& warning : model.warnings) promise(warning.size() < 4000, "a warning is a sentence");
  return !model.springs.empty();
}

}  // namespace coif::fuzz
