#include "import/fbx_files.h"

#include "import/model_files.h"

#include <fmt/format.h>

#include <utility>

namespace coif::importer::test {
namespace {

template <class Number>
std::string bytes_of_number(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

template <class Number>
std::string plain_array(char type, const std::vector<Number>& numbers) {
  std::string out(1, type);
  out += bytes_of_number(std::uint32_t(numbers.size())) + bytes_of_number(std::uint32_t{0}) +
         bytes_of_number(std::uint32_t(numbers.size() * sizeof(Number)));
  for (const Number number : numbers) out += bytes_of_number(number);
  return out;
}

std::string size_bytes(std::uint64_t size, bool is_wide) {
  return is_wide ? bytes_of_number(size) : bytes_of_number(std::uint32_t(size));
}
std::string zeros(bool is_wide) { return std::string(is_wide ? 25 : 13, '\0'); }

void append_record(const FbxTree& record, bool is_wide, std::string& out) {
  std::string values;
  for (const std::string& value : record.values) values += value;
  const std::size_t begin = out.size(), size_width = is_wide ? 8 : 4;
  out += size_bytes(0, is_wide) + size_bytes(record.values.size(), is_wide) + size_bytes(values.size(), is_wide) +
         char(record.name.size()) + record.name + values;
  for (const FbxTree& inner : record.records) append_record(inner, is_wide, out);
  if (!record.records.empty()) out += zeros(is_wide);
  out.replace(begin, size_width, size_bytes(out.size(), is_wide));
}

/// Objects and connections of a model's shape keys.
void append_keys(const FbxModel& model, std::string& objects, std::string& connections) {
  if (model.keys.empty()) return;
  const int geometry = 1000 + model.id, deformer = 2000 + model.id;
  objects += fmt::format("  Deformer: {}, \"Deformer::\", \"BlendShape\" {{\n    Version: 100\n  }}\n", deformer);
  connections += fmt::format("  C: \"OO\",{},{}\n", deformer, geometry);
  int number = 1000 * model.id + 100000;
  for (const FbxKey& key : model.keys) {
    const int channel = number++;
    objects += fmt::format(
        "  Deformer: {}, \"SubDeformer::{}\", \"BlendShapeChannel\" {{\n    Version: 100\n    DeformPercent: {}\n",
        channel, key.name, key.percent);
    if (!key.full_weights.empty())
      objects += fmt::format("    FullWeights: *{} {{\n      a: {}\n    }}\n", key.shapes, key.full_weights);
    objects += "  }\n";
    connections += fmt::format("  C: \"OO\",{},{}\n", channel, deformer);
    for (int shape = 1; shape <= key.shapes; ++shape) {
      objects += fmt::format(R"(  Geometry: {}, "Geometry::shape", "Shape" {{
    Version: 100
    Indexes: *1 {{
      a: 2
    }}
    Vertices: *3 {{
      a: {},0,0
    }}
    Normals: *3 {{
      a: 0,0,0
    }}
  }}
)",
                             number, 10 * shape);
      connections += fmt::format("  C: \"OO\",{},{}\n", number++, channel);
    }
  }
}

}  // namespace

std::string fbx_int32(std::int32_t value) { return "I" + bytes_of_number(value); }
std::string fbx_long(std::int64_t value) { return "L" + bytes_of_number(value); }
std::string fbx_double(double value) { return "D" + bytes_of_number(value); }
std::string fbx_text(const std::string& value) { return "S" + bytes_of_number(std::uint32_t(value.size())) + value; }
std::string fbx_doubles(const std::vector<double>& values) { return plain_array('d', values); }
std::string fbx_ints(const std::vector<std::int32_t>& values) { return plain_array('i', values); }

std::string fbx_packed_array(char type, std::uint32_t count, const std::string& bytes) {
  return std::string(1, type) + bytes_of_number(count) + bytes_of_number(std::uint32_t{1}) +
         bytes_of_number(std::uint32_t(bytes.size())) + bytes;
}

std::string fbx_name(const std::string& name, const std::string& of) {
  return fbx_text(name + std::string("\0\1", 2) + of);
}

std::string binary_fbx(std::uint32_t version, const std::vector<FbxTree>& records) {
  const bool is_wide = version >= 7500;
  std::string out = std::string("Kaydara FBX Binary  \0\x1a\0", 23) + bytes_of_number(version);
  for (const FbxTree& record : records) append_record(record, is_wide, out);
  return out + zeros(is_wide);
}

std::string small_binary_fbx(std::uint32_t version) {
  const FbxTree hidden{
      "P", {fbx_text("Visibility"), fbx_text("Visibility"), fbx_text(""), fbx_text("A"), fbx_double(0)}, {}};
  const auto object = [](const char* record, std::int64_t id, const char* name, const char* of, const char* kind,
                         std::vector<FbxTree> inner) {
    return FbxTree{record, {fbx_long(id), fbx_name(name, of), fbx_text(kind)}, std::move(inner)};
  };
  const auto connection = [](std::int64_t from, std::int64_t to) {
    return FbxTree{"C", {fbx_text("OO"), fbx_long(from), fbx_long(to)}, {}};
  };
  return binary_fbx(
      version,
      {{"Objects",
        {},
        {object("Model", 1, "Hair", "Model", "LodGroup", {{"Properties70", {}, {hidden}}}),
         object("Geometry", 2, "", "Geometry", "Mesh", {{"Vertices", {fbx_doubles({0, 0, 0})}, {}}}),
         object("Deformer", 3, "", "Deformer", "BlendShape", {}),
         object("Deformer", 4, "Long", "SubDeformer", "BlendShapeChannel",
                {{"DeformPercent", {fbx_double(50)}, {}}, {"FullWeights", {fbx_doubles({25, 75})}, {}}}),
         object("Geometry", 5, "a", "Geometry", "Shape", {}), object("Geometry", 6, "b", "Geometry", "Shape", {})}},
       {"Connections",
        {},
        {connection(2, 1), connection(3, 2), connection(4, 3), connection(5, 4), connection(6, 4), connection(1, 0)}}});
}

std::string fbx_property(const std::string& name, const std::string& type, double value) {
  return fmt::format("P: \"{}\", \"{}\", \"\", \"A\",{}\n", name, type, value);
}

std::string text_fbx(const std::vector<FbxModel>& models) {
  std::string objects, connections;
  for (const FbxModel& model : models) {
    const bool has_mesh = model.model_class == "Mesh";
    objects += has_mesh ? fbx_triangle(1000 + model.id, model.name, model.id, model.properties)
                        : fbx_model(model.id, model.name, model.model_class, model.properties);
    connections += fmt::format("  C: \"OO\",{},{}\n", model.id, model.parent);
    if (has_mesh) connections += fmt::format("  C: \"OO\",{},{}\n", 1000 + model.id, model.id);
    append_keys(model, objects, connections);
  }
  return fbx_document("P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",100\n", objects, connections);
}

}  // namespace coif::importer::test
