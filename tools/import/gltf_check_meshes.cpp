#include "import/gltf_check_parts.h"

#include <algorithm>
#include <array>
#include <cmath>

// Checks of the parts of meshes' primitives.

namespace coif::importer {
namespace {

using nlohmann::json;

/// The allowed forms of an attribute (specification 3.7.2.1): its type, and component types that need not be normalized
/// and that must be.
struct AttributeRule {
  std::string_view name;  ///< Followed by a number if it ends in '_'.
  std::array<const char*, 2> types;
  bool floats, unsigned_integers, are_normalized;
};

constexpr AttributeRule kAttributeRules[] = {
    {"POSITION", {"VEC3", ""}, true, false, false}, {"NORMAL", {"VEC3", ""}, true, false, false},
    {"TANGENT", {"VEC4", ""}, true, false, false},  {"TEXCOORD_", {"VEC2", ""}, true, true, true},
    {"COLOR_", {"VEC3", "VEC4"}, true, true, true}, {"JOINTS_", {"VEC4", ""}, false, true, false},
    {"WEIGHTS_", {"VEC4", ""}, true, true, true},
};

class MeshChecks {
 public:
  explicit MeshChecks(CheckedGltf& file) : file_(file) {}

  void run() {
    const json& meshes = file_.list("meshes");
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const json& primitives = member(meshes[m], "primitives");
      const std::string mesh = gltf_part_name("mesh", meshes[m], m);
      if (!primitives.is_array() || primitives.empty()) {
        file_.faults.add(gltf_code::kRules, "{}: it has no list of primitives; export it again", mesh);
        continue;
      }
      for (std::size_t p = 0; p < primitives.size(); ++p) {
        place_ = primitives.size() == 1 ? mesh : fmt::format("{}, primitive {}", mesh, p);
        check_primitive(primitives[p]);
      }
    }
  }

 private:
  template <class... Args>
  void wrong(const char* code, fmt::format_string<Args...> text, Args&&... args) {
    file_.faults.add(code, "{}: {}", place_, fmt::format(text, std::forward<Args>(args)...));
  }

  void check_primitive(const json& primitive) {
    const json& attributes = member(primitive, "attributes");
    if (!attributes.is_object() || attributes.empty())
      return wrong(gltf_code::kRules, "it has no attributes; export it again");
    check_reference(member(primitive, "material"), "materials", "material");
    const auto mode =
        member(primitive, "mode").is_null() ? std::optional<std::uint32_t>(4) : index_of(member(primitive, "mode"), 7);
    if (!mode) wrong(gltf_code::kRules, "its mode is none of points, lines and triangles; export it again");
    const std::size_t vertices = check_attributes(attributes, "");
    const bool is_compressed = member(member(primitive, "extensions"), "KHR_draco_mesh_compression").is_object();
    for (const json& target : list_of(member(primitive, "targets"))) {
      const std::size_t moved = check_attributes(target, "morph target, ");
      if (moved != 0 && vertices != 0 && moved != vertices)
        wrong(gltf_code::kRules, "a morph target has {} vertices of {}; export it again", moved, vertices);
    }
    if (is_compressed) return;
    check_normals(attributes);
    check_tangents(attributes);
    check_colors(attributes);
    check_indices(member(primitive, "indices"), vertices);
  }

  void check_reference(const json& value, const char* list, const char* what) {
    if (!value.is_null() && !index_of(value, file_.list(list).size()))
      wrong(gltf_code::kRules, "its {} is none of the file's {}; choose one in the modelling tool and export again",
            what, file_.list(list).size());
  }

  /// Number of vertices of the attributes; 0 where it is not known.
  std::size_t check_attributes(const json& attributes, const char* of) {
    const json& accessors = file_.list("accessors");
    std::optional<std::size_t> vertices;
    if (!attributes.is_object()) return 0;
    for (const auto& [name, value] : attributes.items()) {
      const std::string shown = of + printable_text(name, 40);
      const auto index = index_of(value, accessors.size());
      if (!index) {
        wrong(gltf_code::kRules, "{} names {} of {} accessors; export it again", shown,
              printable_text(value.dump(), 40), accessors.size());
        continue;
      }
      const std::size_t count = index_of(member(accessors[*index], "count"), std::size_t{1} << 32).value_or(0);
      if (vertices.value_or(count) != count)
        wrong(gltf_code::kRules, "{} has {} vertices and others {}; export it again", shown, count, *vertices);
      if (!vertices) vertices = count;
      if (*of == '\0') check_format(name, shown, accessors[*index], attributes);
    }
    return vertices.value_or(0);
  }

  void check_format(std::string_view name, const std::string& shown, const json& accessor, const json& attributes) {
    const auto fits = [&](const AttributeRule& rule) {
      return rule.name.ends_with('_') ? name.starts_with(rule.name) : name == rule.name;
    };
    const auto* const rule = std::ranges::find_if(kAttributeRules, fits);
    if (rule == std::end(kAttributeRules)) {
      if (!name.starts_with('_')) wrong(gltf_code::kRules, "{} is none of glTF's attributes; export it again", shown);
      return;
    }
    const std::string number(name.substr(rule->name.size()));
    if (rule->name.ends_with('_') && number != "0") {
      const auto index = number.size() == 1 && number[0] > '0' && number[0] <= '9' ? number[0] - '0' : 0;
      if (index == 0 || !attributes.contains(fmt::format("{}{}", rule->name, index - 1)))
        wrong(gltf_code::kRules, "{} has no set before it; export it again", shown);
    }
    const json& type = member(accessor, "type");
    const auto component = index_of(member(accessor, "componentType"), 10000).value_or(0);
    const bool is_normalized = member(accessor, "normalized") == true;
    const bool is_float = component == 5126, is_small = component == 5121 || component == 5123;
    const bool is_packed = component == 5120 || component == 5122 || is_small;
    const bool may_be_packed =
        file_.uses("KHR_mesh_quantization") && rule->name != "JOINTS_" && rule->name != "WEIGHTS_";
    const bool ok = (rule->floats && is_float) ||
                    (rule->unsigned_integers && is_small && is_normalized == rule->are_normalized) ||
                    (may_be_packed && is_packed);
    const bool is_typed = std::ranges::any_of(rule->types, [&](const char* allowed) { return type == allowed; });
    if (!ok || !is_typed) wrong(gltf_code::kRules, "{} is not of a type that it may have; export it again", shown);
  }

  /// Counts the vectors of an attribute, three numbers each, that are not of length one, and finds the first.
  void check_units(const json& accessor, const char* what) {
    constexpr double kMostOff = 0.00674;  // As in the Khronos validator: a byte's rounding.
    const auto stored = file_.read(accessor);
    if (!stored || stored->width < 3) return;
    std::size_t off = 0, first = 0;
    double length = 0;
    for (std::size_t v = 0; v < stored->count(); ++v) {
      double squares = 0;
      for (std::size_t k = 0; k < 3; ++k) squares += std::pow(stored->value(v * stored->width + k), 2);
      if (std::abs(std::sqrt(squares) - 1) <= kMostOff || !std::isfinite(squares)) continue;
      if (off++ == 0) first = v, length = std::sqrt(squares);
    }
    if (off > 0)
      wrong(gltf_code::kUnits,
            "{} of {} {} are not of length 1 (that of vertex {} has {:.4g}); recalculate them in the modelling tool "
            "(Blender: Mesh > Normals > Reset Vectors) and export again",
            off, stored->count(), what, first, length);
  }

  void check_normals(const json& attributes) { check_units(member(attributes, "NORMAL"), "normals"); }

  void check_tangents(const json& attributes) {
    const json& tangents = member(attributes, "TANGENT");
    check_units(tangents, "tangents");
    const auto stored = file_.read(tangents);
    if (!stored || stored->width != 4) return;
    for (std::size_t v = 0; v < stored->count(); ++v) {
      if (std::abs(stored->value(4 * v + 3)) == 1) continue;
      return wrong(gltf_code::kUnits, "the tangent of vertex {} has the sign {:g} and not 1 or -1; export it again", v,
                   stored->value(4 * v + 3));
    }
  }

  void check_colors(const json& attributes) {
    const auto stored = file_.read(member(attributes, "COLOR_0"));
    if (!stored || !stored->is_float()) return;
    const auto odd = std::ranges::find_if(stored->numbers, [](double n) { return n < 0 || n > 1; });
    if (odd != stored->numbers.end())
      wrong(gltf_code::kNumbers, "the colour of vertex {} has {:g}, outside of 0 to 1; paint it anew and export again",
            std::size_t(odd - stored->numbers.begin()) / stored->width, *odd);
  }

  void check_indices(const json& accessor, std::size_t vertices) {
    if (accessor.is_null()) return;
    const auto stored = file_.read(accessor);
    if (!index_of(accessor, file_.list("accessors").size()))
      return wrong(gltf_code::kRules, "its indices are none of the file's accessors; export it again");
    if (!stored) return;
    if (stored->width != 1 || !stored->component.is_unsigned)
      return wrong(gltf_code::kRules, "its indices are no list of unsigned numbers; export it again");
    std::size_t outside = 0, first = 0, restarts = 0;
    for (std::size_t i = 0; i < stored->numbers.size(); ++i) {
      restarts += stored->numbers[i] == stored->component.largest ? 1 : 0;
      if (stored->numbers[i] < double(vertices) && stored->numbers[i] != stored->component.largest) continue;
      if (outside++ == 0) first = i;
    }
    if (outside == 0 || vertices == 0) return;
    wrong(gltf_code::kIndices,
          "{} of {} indices are of no vertex (number {} is {:.0f}, there are {} vertices{}); their triangles cannot be "
          "drawn: clean up loose geometry in the modelling tool and export again",
          outside, stored->numbers.size(), first, stored->numbers[first], vertices,
          restarts > 0 ? ", and the type's largest number means none" : "");
  }

  CheckedGltf& file_;
  std::string place_;
};

}  // namespace

void check_gltf_meshes(CheckedGltf& file) { MeshChecks(file).run(); }

}  // namespace coif::importer
