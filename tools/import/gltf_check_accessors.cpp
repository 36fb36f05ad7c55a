#include "import/gltf_check_parts.h"

#include <algorithm>
#include <cmath>
#include <set>

// Bytes of buffers, and numbers in them.

namespace coif::importer {
namespace {

using nlohmann::json;

constexpr std::size_t kAnySize = std::size_t{1} << 32;
constexpr const char* kNotAllThere = "the file is cut off or damaged: export it again";

std::optional<std::size_t> size_or(const json& value, std::size_t otherwise) {
  if (value.is_null()) return otherwise;
  const auto size = index_of(value, kAnySize);
  return size ? std::optional<std::size_t>(*size) : std::nullopt;
}

class AccessorChecks {
 public:
  explicit AccessorChecks(CheckedGltf& file) : file_(file) {}

  void run() {
    for (std::size_t i = 0; i < file_.list("bufferViews").size(); ++i) check_view(i);
    note_uses();
    for (std::size_t i = 0; i < file_.list("accessors").size(); ++i) check_accessor(i);
  }

 private:
  template <class... Args>
  void wrong(const char* code, fmt::format_string<Args...> text, Args&&... args) {
    file_.faults.add(code, text, std::forward<Args>(args)...);
  }

  void check_view(std::size_t v) {
    const json& view = file_.list("bufferViews")[v];
    if (member(view, "extensions").is_object()) return;
    const auto begin = size_or(member(view, "byteOffset"), 0), length = size_or(member(view, "byteLength"), 0);
    if (!begin || !length || *length == 0)
      return wrong(gltf_code::kRules, "bufferView {}: its offset or length is no such number; {}", v, kNotAllThere);
    const auto stride = size_or(member(view, "byteStride"), 4);
    if (!stride || *stride < 4 || *stride > 252 || *stride % 4 != 0)
      wrong(gltf_code::kRules, "bufferView {}: its byteStride is no multiple of 4 from 4 to 252; export it again", v);
    const auto buffer = index_of(member(view, "buffer"), file_.list("buffers").size());
    if (!buffer) return;
    std::string why;
    const auto held = file_.buffer_size(*buffer, why);
    if (!held) return wrong(gltf_code::kRules, "{}; {}", why, kNotAllThere);
    if (*begin > *held || *length > *held - *begin)
      wrong(gltf_code::kRules, "bufferView {}: it ends at byte {} of a buffer of {}; {}", v, *begin + *length, *held,
            kNotAllThere);
  }

  void note_uses() {
    for (const json& mesh : file_.list("meshes")) {
      for (const json& primitive : list_of(member(mesh, "primitives"))) {
        note_use(member(member(primitive, "attributes"), "POSITION"), needs_bounds_);
        for (const json& target : list_of(member(primitive, "targets")))
          note_use(member(target, "POSITION"), needs_bounds_);
      }
    }
    for (const json& animation : file_.list("animations")) {
      for (const json& sampler : list_of(member(animation, "samplers")))
        note_use(member(sampler, "input"), needs_bounds_);
    }
  }

  void note_use(const json& accessor, std::set<std::uint32_t>& uses) {
    if (const auto index = index_of(accessor, file_.list("accessors").size())) uses.insert(*index);
  }

  void check_accessor(std::size_t a) {
    const json& entry = file_.list("accessors")[a];
    const std::size_t component =
        gltf::gltf_component(index_of(member(entry, "componentType"), 10000).value_or(0)).size;
    const std::size_t width = gltf::gltf_type_width(member(entry, "type"));
    const auto count = index_of(member(entry, "count"), kAnySize);
    if (component == 0 || width == 0 || !count || *count == 0)
      return wrong(gltf_code::kRules,
                   "accessor {}: its type, component type or count is none of glTF's; export it again", a);
    if (needs_bounds_.contains(std::uint32_t(a))) check_that_bounds_are_given(entry, width, a);
    const json& views = file_.list("bufferViews");
    const auto view = index_of(member(entry, "bufferView"), views.size());
    if (view && member(views[*view], "extensions").is_object()) return;
    if (view) check_place(entry, views[*view], a, {component, width, *count});
    const auto stored = file_.read(a);
    if (!stored) {
      if (member(entry, "sparse").is_object())
        wrong(gltf_code::kRules, "accessor {}: its sparse values are not within it, or not there; {}", a, kNotAllThere);
      return;
    }
    const auto odd = std::ranges::find_if(stored->numbers, [](double n) { return !std::isfinite(n); });
    if (odd != stored->numbers.end())
      return wrong(gltf_code::kNumbers,
                   "accessor {}: element {} is {}; delete or move what is there in the modelling tool and export again",
                   a, std::size_t(odd - stored->numbers.begin()) / width,
                   std::isnan(*odd) ? "not a number" : "infinite");
    check_bounds(entry, *stored, a);
  }

  struct Extent {
    std::size_t component, width, count;
  };

  void check_place(const json& entry, const json& view, std::size_t a, const Extent& extent) {
    const std::size_t element = extent.component * extent.width;
    const auto first = size_or(member(entry, "byteOffset"), 0), begin = size_or(member(view, "byteOffset"), 0);
    const auto length = size_or(member(view, "byteLength"), 0), stride = size_or(member(view, "byteStride"), element);
    if (!first || !begin || !length || !stride)
      return wrong(gltf_code::kRules, "accessor {}: its offset is no such number; export it again", a);
    if ((*first + *begin) % extent.component != 0 || *first % extent.component != 0 || *stride % extent.component != 0)
      wrong(gltf_code::kRules, "accessor {}: its numbers of {} bytes are not aligned to {}; export it again", a,
            extent.component, extent.component);
    const std::size_t end = *first + *stride * (extent.count - 1) + element;
    if (end > *length || *stride < element)
      wrong(gltf_code::kRules, "accessor {}: its {} elements end at byte {} of a bufferView of {}; {}", a, extent.count,
            end, *length, kNotAllThere);
  }

  void check_that_bounds_are_given(const json& entry, std::size_t width, std::size_t a) {
    if (list_of(member(entry, "min")).size() == width && list_of(member(entry, "max")).size() == width) return;
    wrong(gltf_code::kBounds,
          "accessor {}: positions and key times need 'min' and 'max', by which other programs tell what is seen; "
          "export it again",
          a);
  }

  void check_bounds(const json& entry, const StoredNumbers& stored, std::size_t a) {
    for (const char* name : {"min", "max"}) {
      const bool is_least = name[1] == 'i';
      const json& given = member(entry, name);
      if (given.is_null()) continue;
      if (list_of(given).size() != stored.width)
        return wrong(gltf_code::kBounds, "accessor {}: its '{}' is no list of {} numbers; export it again", a, name,
                     stored.width);
      for (std::size_t k = 0; k < stored.width; ++k) {
        double found = stored.numbers[k];
        for (std::size_t i = k; i < stored.numbers.size(); i += stored.width)
          found = is_least ? std::min(found, stored.numbers[i]) : std::max(found, stored.numbers[i]);
        const auto said = number_of(given[k]);
        const double off = said ? std::abs(*said - found) : 1e30;
        if (off <= kRounding * std::max(1.0, std::abs(found))) continue;
        return wrong(gltf_code::kBounds,
                     "accessor {}: its '{}' says {} where its numbers have {:g}: other programs hide what is seen; "
                     "export it again",
                     a, name, printable_text(given[k].dump(), 40), found);
      }
    }
  }

  static constexpr double kRounding = 1e-6;  ///< Rounding of decimal digits in JSON.

  CheckedGltf& file_;
  std::set<std::uint32_t> needs_bounds_;
};

}  // namespace

void check_gltf_accessors(CheckedGltf& file) { AccessorChecks(file).run(); }

}  // namespace coif::importer
