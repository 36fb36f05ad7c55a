#include "view/body/compact_body.h"

#include "base/encodings.h"
#include "base/json.h"
#include "cook/texture/image.h"

#include <meshoptimizer.h>
#include <webp/encode.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace coif::view {
namespace {

constexpr std::size_t kMostVertices = 65'536;  // Indices have 16 bits.

/// As many triangles as keep the surface within `error` metres.
std::vector<std::uint32_t> simplified(const render::SolidMesh& mesh, float error) {
  if (mesh.triangles.empty()) return {};
  const float* const first = mesh.vertices.front().position.data();
  constexpr std::size_t kStride = sizeof(render::SolidVertex);
  const float scale = meshopt_simplifyScale(first, mesh.vertices.size(), kStride);
  std::vector<std::uint32_t> triangles(mesh.triangles.size());
  const std::size_t kept =
      meshopt_simplify(triangles.data(), mesh.triangles.data(), mesh.triangles.size(), first, mesh.vertices.size(),
                       kStride, 0, scale > 0 ? error / scale : 0, 0, nullptr);
  triangles.resize(kept);
  return triangles;
}

/// Leaves out vertices that no triangle has.
void drop_unused(PageBodyMesh& body) {
  render::SolidMesh& mesh = body.mesh;
  std::vector<std::uint32_t> place(mesh.vertices.size(), std::numeric_limits<std::uint32_t>::max());
  std::vector<render::SolidVertex> vertices;
  std::vector<float> turning;
  for (std::uint32_t& v : mesh.triangles) {
    if (place[v] == std::numeric_limits<std::uint32_t>::max()) {
      place[v] = std::uint32_t(vertices.size());
      vertices.push_back(mesh.vertices[v]);
      if (!body.turning.empty()) turning.push_back(body.turning[v]);
    }
    v = place[v];
  }
  mesh.vertices = std::move(vertices);
  body.turning = std::move(turning);
}

std::size_t triangles_of(const PageBody& body) {
  std::size_t count = 0;
  for (const PageBodyMesh& mesh : body.meshes) count += mesh.mesh.triangles.size() / 3;
  return count;
}

bool fits(const PageBody& body) {
  return triangles_of(body) <= kMostBodyTriangles && std::ranges::all_of(body.meshes, [](const PageBodyMesh& mesh) {
           return mesh.mesh.vertices.size() <= kMostVertices;
         });
}

PageBody reduced(const PageBody& whole) {
  constexpr float kFinest = 5e-5f, kCoarser = 1.3f;  // metres; the next try
  constexpr int kTries = 40;
  PageBody body = whole;
  for (PageBodyMesh& mesh : body.meshes) drop_unused(mesh);
  float error = kFinest;
  for (int i = 0; i < kTries && !fits(body); ++i, error *= kCoarser) {
    for (std::size_t m = 0; m < whole.meshes.size(); ++m) {
      body.meshes[m] = whole.meshes[m];
      body.meshes[m].mesh.triangles = simplified(whole.meshes[m].mesh, error);
      drop_unused(body.meshes[m]);
    }
  }
  // Whatever is made of countless separate pieces stays too large.
  if (!fits(body)) body.meshes.clear();
  return body;
}

std::vector<std::uint8_t> webp_of(const render::SolidTexture& texture) {
  constexpr float kQuality = 82;
  const cook::Image small = cook::reduce({texture.width, texture.height, 4, texture.rgba}, kMostBodyTexels,
                                         cook::TexelMeaning::kSrgbColorAlpha);
  std::uint8_t* encoded = nullptr;
  const std::size_t size = WebPEncodeRGBA(small.texels.data(), int(small.width), int(small.height),
                                          int(4 * small.width), kQuality, &encoded);
  std::vector<std::uint8_t> bytes(encoded, encoded + size);
  WebPFree(encoded);
  return bytes;
}

}  // namespace

CompactBody compact_body(const importer::SourceModel& model, const render::BodyTextures& textures,
                         const std::string& head_bone) {
  CompactBody out;
  PageBody whole;
  std::map<const render::SolidTexture*, std::uint32_t> numbers;  // looked up only
  for (const importer::SourceMesh& source : model.meshes) {
    PageBodyMesh& mesh = whole.meshes.emplace_back();
    mesh.mesh = render::body_mesh(model, source, Eigen::Vector3f::Zero());
    render::dress(model, source, textures, mesh.mesh);
    mesh.turning = render::turning_shares(model, source, head_bone);
    const auto texture = std::exchange(mesh.mesh.texture, nullptr);
    if (texture == nullptr) continue;
    const auto [known, is_new] = numbers.try_emplace(texture.get(), std::uint32_t(out.images.size()));
    if (is_new) out.images.push_back(webp_of(*texture));
    mesh.image = known->second;
  }
  out.body = reduced(whole);
  return out;
}

std::string body_json(const CompactBody& body) {
  const std::vector<std::byte> bytes = body_bytes(body.body);
  nlohmann::ordered_json json{{"meshes", base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()})},
                              {"images", nlohmann::ordered_json::array()}};
  for (const std::vector<std::uint8_t>& image : body.images) json["images"].push_back(base64(image));
  return json.dump();
}

}  // namespace coif::view
