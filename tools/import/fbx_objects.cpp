#include "import/fbx_objects.h"

#include "import/fbx_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <utility>

namespace coif::importer {
namespace {

constexpr std::string_view kNameEnd("\0\1", 2);  // "Hair\0\1Model" of a binary file is "Model::Hair" of a text.

std::string_view object_name(std::string_view text) {
  if (const std::size_t end = text.find(kNameEnd); end != std::string_view::npos) return text.substr(0, end);
  for (const std::string_view prefix : {"Model::", "Geometry::", "Deformer::", "SubDeformer::", "NodeAttribute::",
                                        "DisplayLayer::", "Material::", "Texture::", "LayeredTexture::"}) {
    if (text.starts_with(prefix)) return text.substr(prefix.size());
  }
  return text;
}

bool is_lod_class(std::string_view text) { return text == "LodGroup" || text == "LODGroup"; }

std::optional<FbxKind> kind_of(std::string_view record, std::string_view object_class) {
  if (record == "Model") return FbxKind::kModel;
  if (record == "Material") return FbxKind::kMaterial;
  if (record == "Texture") return FbxKind::kTexture;
  if (record == "LayeredTexture") return FbxKind::kLayeredTexture;
  if (record == "NodeAttribute" && is_lod_class(object_class)) return FbxKind::kLodAttribute;
  if (record == "CollectionExclusive" && object_class == "DisplayLayer") return FbxKind::kLayer;
  if (record == "Geometry" && object_class == "Mesh") return FbxKind::kMesh;
  if (record == "Geometry" && object_class == "Shape") return FbxKind::kShape;
  if (record == "Deformer" && object_class == "BlendShape") return FbxKind::kBlendShape;
  if (record == "Deformer" && object_class == "BlendShapeChannel") return FbxKind::kChannel;
  if (record == "Deformer" && object_class == "Cluster") return FbxKind::kCluster;
  return std::nullopt;
}

bool is_number(const FbxValue& value) { return value.kind == FbxValue::Kind::kNumber; }

/// The share of a shape in the result of a channel at `percent`. The channel blends between shapes that are fully on at
/// the percents of `full`, at most two at a time. `full` ascends from above 0.
double shape_weight(std::span<const double> full, std::size_t shape, double percent) {
  const double own = full[shape];
  const bool is_last = shape + 1 == full.size();
  if (percent <= own || is_last) {
    const double before = shape == 0 ? 0 : full[shape - 1];
    if (is_last && percent > own) return full.size() == 1 ? percent / own : 1;
    if (shape == 0) return percent / own;
    return std::max(0.0, (percent - before) / (own - before));
  }
  return std::max(0.0, (full[shape + 1] - percent) / (full[shape + 1] - own));
}

/// The objects connected to this one; `connections` are sorted by `to`.
std::span<const FbxConnection> connected_to(std::int64_t id, std::span<const FbxConnection> connections) {
  const auto found = std::ranges::equal_range(connections, id, {}, &FbxConnection::to);
  return {found.begin(), found.end()};
}

}  // namespace

/// Collects the needed values from the records.
class FbxObjects::Collector {
 public:
  explicit Collector(FbxObjects& out) : out_(out) {}

  bool operator()(const FbxRecord& record) {
    switch (record.depth) {
      case 0: is_objects_ = record.name == "Objects"; return is_objects_ || record.name == "Connections";
      case 1: return is_objects_ ? add_object(record) : add_connection(record);
      case 2: return read_part(record);
      case 3: read_inner_part(record); return false;
      default: return false;
    }
  }

 private:
  bool add_object(const FbxRecord& record) {
    if (record.values.size() < 3 || !is_number(record.values[0])) return false;
    const std::string_view object_class = record.values[2].text;
    const auto kind = kind_of(record.name, object_class);
    if (!kind) return false;
    FbxObject object;
    object.id = record.values[0].whole;
    object.name = object_name(record.values[1].text);
    object.kind = *kind;
    object.is_lod_group = *kind == FbxKind::kModel && is_lod_class(object_class);
    out_.objects_.push_back(object);
    return *kind == FbxKind::kModel || *kind == FbxKind::kLayer || *kind == FbxKind::kChannel ||
           *kind == FbxKind::kTexture;
  }

  bool add_connection(const FbxRecord& record) {
    const auto& values = record.values;
    if (record.name != "C" || values.size() < 3 || !is_number(values[1]) || !is_number(values[2])) return false;
    if (values[0].text == "OO") out_.connections_.push_back({values[1].whole, values[2].whole, {}});
    if (values[0].text == "OP") {
      const std::string_view property = values.size() > 3 ? values[3].text : std::string_view();
      out_.on_properties_.push_back({values[1].whole, values[2].whole, property});
    }
    return false;
  }

  bool read_part(const FbxRecord& record) {
    FbxObject& object = out_.objects_.back();
    part_ = record.name;
    if (object.kind == FbxKind::kChannel && part_ == "DeformPercent" && !record.values.empty())
      set_percent(record.values[0]);
    if (object.kind == FbxKind::kChannel && part_ == "FullWeights") {
      if (!record.values.empty() && record.values[0].kind == FbxValue::Kind::kArray)
        add_full_weights(record.values[0].text);
      return true;
    }
    if (object.kind == FbxKind::kTexture && !record.values.empty()) {
      const bool is_relative = part_ == "RelativeFilename";
      const std::string_view file = record.values[0].text;
      if (!file.empty() && (is_relative || (part_ == "FileName" && object.file.empty()))) object.file = file;
    }
    return part_ == "Properties70";
  }

  void read_inner_part(const FbxRecord& record) {
    if (part_ == "FullWeights" && record.name == "a") {
      std::array<double, kMostFbxValues> numbers{};
      std::ranges::transform(record.values, numbers.begin(), &FbxValue::number);
      add_full_weights({reinterpret_cast<const char*>(numbers.data()), record.values.size() * sizeof(double)});
    }
    // P: name, type, label, flags, value
    if (part_ != "Properties70" || record.name != "P" || record.values.size() < 5) return;
    const std::string_view name = record.values[0].text;
    FbxObject& object = out_.objects_.back();
    if (object.kind == FbxKind::kTexture && name == "UVSet") object.uv_set = record.values[4].text;
    if (!is_number(record.values[4])) return;
    const bool is_on = record.values[4].number != 0;
    if (name == (object.kind == FbxKind::kLayer ? "Show" : "Visibility")) object.is_visible = is_on;
    if (name == "Visibility Inheritance") object.inherits_visibility = is_on;
    if (name == "DeformPercent") set_percent(record.values[4]);
    if (object.kind == FbxKind::kTexture) read_place(name, record.values.subspan(4), object.place);
    if (name == "UVSwap") object.place.swaps_axes = is_on;
    if (name == "WrapModeU") object.is_clamped[0] = is_on;
    if (name == "WrapModeV") object.is_clamped[1] = is_on;
  }

  static void read_place(std::string_view name, std::span<const FbxValue> values, FbxTexturePlace& place) {
    if (values.size() < 3 || !std::ranges::all_of(values.first(3), is_number)) return;
    if (name == "Rotation") place.degrees = values[2].number;
    const std::pair<std::string_view, double*> pairs[] = {{"Scaling", place.scaling},
                                                          {"TextureScalingPivot", place.scaling_pivot},
                                                          {"TextureRotationPivot", place.rotation_pivot},
                                                          {"Translation", place.translation}};
    for (const auto& [property, numbers] : pairs) {
      if (name != property) continue;
      numbers[0] = values[0].number;
      numbers[1] = values[1].number;
    }
  }

  void set_percent(const FbxValue& value) {
    if (is_number(value) && std::isfinite(value.number)) out_.objects_.back().percent = value.number;
  }

  /// Blender writes one for each vertex, which is no weight of a shape.
  void add_full_weights(std::string_view doubles) {
    FbxObject& channel = out_.objects_.back();
    const std::size_t count = doubles.size() / sizeof(double), begin = out_.full_weights_.size();
    if (count == 0 || count > kMostFbxValues || channel.end != 0) return;
    out_.full_weights_.resize(begin + count);
    std::memcpy(out_.full_weights_.data() + begin, doubles.data(), count * sizeof(double));
    channel.begin = std::uint32_t(begin);
    channel.end = std::uint32_t(begin + count);
  }

  FbxObjects& out_;
  bool is_objects_ = false;
  std::string_view part_;
};

std::optional<FbxObjects> FbxObjects::read(std::string_view file) {
  FbxObjects out;
  Collector collector(out);
  if (!walk_fbx(file, std::ref(collector))) return std::nullopt;
  out.sort();
  out.mark_models();
  out.collect_shapes();
  return out;
}

/// Among objects with one id the last counts, as in assimp.
void FbxObjects::sort() {
  std::ranges::reverse(objects_);
  std::ranges::stable_sort(objects_, {}, &FbxObject::id);
  objects_.erase(std::unique(objects_.begin(), objects_.end(),
                             [](const FbxObject& a, const FbxObject& b) { return a.id == b.id; }),
                 objects_.end());
  std::ranges::stable_sort(connections_, {}, &FbxConnection::to);
  std::ranges::stable_sort(on_properties_, {}, &FbxConnection::to);
}

const FbxObject* FbxObjects::find(std::int64_t id) const {
  const auto found = std::ranges::lower_bound(objects_, id, {}, &FbxObject::id);
  return found != objects_.end() && found->id == id ? &*found : nullptr;
}

std::span<const FbxConnection> FbxObjects::below(std::int64_t id) const { return connected_to(id, connections_); }

std::span<const FbxConnection> FbxObjects::on_properties(std::int64_t id) const {
  return connected_to(id, on_properties_);
}

/// Some writers mark a LodGroup only in the model's attribute. A layer that is off hides its models.
void FbxObjects::mark_models() {
  for (const FbxConnection& connection : connections_) {
    const FbxObject* const from = find(connection.from);
    const FbxObject* const to = find(connection.to);
    if (from == nullptr || to == nullptr) continue;
    if (from->kind == FbxKind::kLodAttribute && to->kind == FbxKind::kModel)
      objects_[std::size_t(to - objects_.data())].is_lod_group = true;
    if (from->kind == FbxKind::kModel && to->kind == FbxKind::kLayer && !to->is_visible)
      objects_[std::size_t(from - objects_.data())].is_visible = false;
  }
}

/// A file that connects shapes crosswise would make more of them than it has connections; it gets none.
void FbxObjects::collect_shapes() {
  std::size_t steps_left = connections_.size();
  for (FbxObject& object : objects_) {
    if (object.kind != FbxKind::kMesh) continue;
    object.begin = std::uint32_t(shapes_.size());
    if (!add_shapes_of(object, steps_left)) {
      for (FbxObject& mesh : objects_) {
        if (mesh.kind == FbxKind::kMesh) mesh.begin = mesh.end = 0;
      }
      return;
    }
    object.end = std::uint32_t(shapes_.size());
  }
}

bool FbxObjects::add_shapes_of(const FbxObject& mesh, std::size_t& steps_left) {
  for (const FbxConnection& to_mesh : below(mesh.id)) {
    if (steps_left-- == 0) return false;
    const FbxObject* const deformer = find(to_mesh.from);
    if (deformer == nullptr || deformer->kind != FbxKind::kBlendShape) continue;
    for (const FbxConnection& to_deformer : below(deformer->id)) {
      if (steps_left-- == 0) return false;
      const FbxObject* const channel = find(to_deformer.from);
      if (channel == nullptr || channel->kind != FbxKind::kChannel) continue;
      const auto below_channel = below(channel->id);
      if (below_channel.size() > steps_left) return false;
      steps_left -= below_channel.size();
      add_channel(*channel, below_channel);
    }
  }
  return true;
}

void FbxObjects::add_channel(const FbxObject& channel, std::span<const FbxConnection> below_channel) {
  std::vector<const FbxObject*> shapes;
  for (const FbxConnection& connection : below_channel) {
    const FbxObject* const shape = find(connection.from);
    if (shape != nullptr && shape->kind == FbxKind::kShape) shapes.push_back(shape);
  }
  std::vector<double> full(full_weights_.begin() + channel.begin, full_weights_.begin() + channel.end);
  const bool is_usable =
      full.size() == shapes.size() &&
      std::ranges::all_of(full, [](double percent) { return std::isfinite(percent) && percent > 0; }) &&
      std::ranges::adjacent_find(full, std::greater_equal<>()) == full.end();
  if (!is_usable) {
    full.clear();
    for (std::size_t i = 0; i < shapes.size(); ++i) full.push_back(100.0 * double(i + 1) / double(shapes.size()));
  }
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const double weight = shape_weight(full, i, channel.percent);
    shapes_.push_back({channel.name.empty() ? shapes[i]->name : channel.name, i == 0 ? channel.percent / 100 : 0,
                       std::isfinite(weight) ? weight : 0});
  }
}

std::vector<const FbxObject*> textures_of(const FbxObjects& objects, std::int64_t id) {
  std::vector<const FbxObject*> out;
  const FbxObject* const object = objects.find(id);
  if (object != nullptr && object->kind == FbxKind::kTexture) out.push_back(object);
  if (object == nullptr || object->kind != FbxKind::kLayeredTexture) return out;
  for (const FbxConnection& layer : objects.below(id)) {
    const FbxObject* const texture = objects.find(layer.from);
    if (texture != nullptr && texture->kind == FbxKind::kTexture) out.push_back(texture);
  }
  return out;
}

}  // namespace coif::importer
