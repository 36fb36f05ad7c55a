// print_model FILE: what the importer makes of a model, as JSON, for comparing with other readers.
// print_model --matrix FOLDER: writes the strip of the tests into FOLDER in every way to store its numbers.

#include "import/gltf_builder.h"
#include "import/import.h"
#include "platform/job.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace coif::importer {
namespace {

using nlohmann::json;
using test::GltfBuilder;
using test::kStripNormals;
using test::kStripPositions;
using test::kStripUvs;
using test::Storage;

template <class Vector>
json flat(const std::vector<Vector>& vectors) {
  json out = json::array();
  for (const Vector& vector : vectors) {
    for (Eigen::Index k = 0; k < vector.size(); ++k) out.push_back(vector[k]);
  }
  return out;
}

json influences_of(const SourceModel& model, const SourceMesh& mesh) {
  json out = json::array();
  for (std::size_t v = 0; v + 1 < mesh.influence_begin.size(); ++v) {
    json of_vertex = json::array();
    for (std::uint32_t i = mesh.influence_begin[v]; i < mesh.influence_begin[v + 1]; ++i) {
      of_vertex.push_back({model.nodes[mesh.influences[i].node].name, mesh.influences[i].weight});
    }
    out.push_back(std::move(of_vertex));
  }
  return out;
}

const char* word_of(TextureWrap wrap) {
  return wrap == TextureWrap::kClamp ? "clamp" : wrap == TextureWrap::kMirror ? "mirror" : "repeat";
}

json material_of(const SourceModel& model, const SourceMesh& mesh) {
  if (mesh.material >= model.materials.size()) return json();
  const SourceMaterial& material = model.materials[mesh.material];
  const SourceTexture& base = material.base_texture;
  return {
      {"name", material.name}, {"texture", base.is_there()}, {"wrap", {word_of(base.wrap[0]), word_of(base.wrap[1])}}};
}

int print(const std::filesystem::path& path) {
  const auto model = import_model(path);
  json out;
  if (!model) {
    out["error"] = model.error().message;
  } else {
    out["warnings"] = messages_of(model->warnings);
    out["nodes"] = json::array();
    for (const SourceNode& node : model->nodes) {
      const Eigen::Vector3d at = node.model_from_node.translation();
      const json parent = node.parent == kNoIndex ? json() : json(model->nodes[node.parent].name);
      out["nodes"].push_back({{"name", node.name}, {"parent", parent}, {"at", {at.x(), at.y(), at.z()}}});
    }
    out["meshes"] = json::array();
    for (const SourceMesh& mesh : model->meshes) {
      out["meshes"].push_back({{"name", mesh.name},
                               {"node", model->nodes[mesh.node].name},
                               {"material", material_of(*model, mesh)},
                               {"positions", flat(mesh.positions)},
                               {"normals", flat(mesh.normals)},
                               {"uvs", flat(mesh.uvs)},
                               {"colors", flat(mesh.colors)},
                               {"triangles", mesh.triangles},
                               {"influences", influences_of(*model, mesh)}});
    }
  }
  std::puts(out.dump(-1, ' ', false, json::error_handler_t::replace).c_str());
  return 0;
}

void write(const std::filesystem::path& folder, const GltfBuilder& file, const std::string& name) {
  std::ofstream(folder / (name + ".glb"), std::ios::binary) << file.glb();
}

void write_attribute(const std::filesystem::path& folder, const char* attribute, const std::vector<float>& numbers,
                     const char* type) {
  const std::size_t width = std::size_t(type[3] - '0');
  for (const int component : {5120, 5121, 5122, 5123, 5126}) {
    const std::size_t size = component == 5126 ? 4 : component <= 5121 ? 1 : 2;
    const std::size_t align = (4 - size * width % 4) % 4;
    for (const bool normalized : {false, true}) {
      if (component == 5126 && normalized) continue;
      for (const Storage& way :
           {Storage{component, normalized, align, false, false},
            Storage{component, normalized, align + 8, false, false}, Storage{component, normalized, 0, true, false},
            Storage{component, normalized, align, false, true}}) {
        GltfBuilder file;
        file.document["extensionsUsed"] = {"KHR_mesh_quantization"};
        if (way.meshopt) file.document["extensionsUsed"].push_back("EXT_meshopt_compression");
        file.document["extensionsRequired"] = file.document["extensionsUsed"];
        file.attribute(attribute, numbers, type, way);
        if (std::string(attribute) != "COLOR_0") file.document["nodes"][0]["rotation"] = {0, 0.6, 0, 0.8};
        write(folder, file,
              fmt::format("{}_{}{}_{}{}{}", attribute, component, normalized ? "n" : "", way.padding,
                          way.sparse ? "_sparse" : "", way.meshopt ? "_meshopt" : ""));
      }
    }
  }
}

int write_matrix(const std::filesystem::path& folder) {
  std::vector<float> halves = kStripPositions;
  for (float& number : halves) number /= 2;
  write_attribute(folder, "POSITION", halves, "VEC3");
  write_attribute(folder, "NORMAL", kStripNormals, "VEC3");
  write_attribute(folder, "TEXCOORD_0", kStripUvs, "VEC2");
  write_attribute(folder, "COLOR_0", std::vector<float>{0, 1, 0, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}, "VEC4");
  return 0;
}

}  // namespace
}  // namespace coif::importer

int main(int count, char** arguments) {
  coif::platform::run_named_job(count, arguments);
  if (count == 3 && std::string(arguments[1]) == "--matrix") return coif::importer::write_matrix(arguments[2]);
  if (count == 2) return coif::importer::print(arguments[1]);
  std::fputs("print_model FILE | --matrix FOLDER\n", stderr);
  return 2;
}
