#include "cook/cook.h"

#include "base/byte_archive.h"

#include <cstring>
#include <iterator>
#include <stdexcept>

namespace coif::cook {
namespace {

using nlohmann::json;

json document_of(const PassTime& pass) { return {pass.name, pass.ms}; }
void read(const json& in, PassTime& pass) {
  in.at(0).get_to(pass.name);
  in.at(1).get_to(pass.ms);
}

json document_of(const LeftOut& l) { return {l.what, l.why, l.bytes, l.bytes_per_head, l.ns_per_frame}; }
void read(const json& in, LeftOut& l) {
  in.at(0).get_to(l.what);
  in.at(1).get_to(l.why);
  l.bytes = whole_number<decltype(l.bytes)>(in.at(2));
  l.bytes_per_head = whole_number<decltype(l.bytes_per_head)>(in.at(3));
  in.at(4).get_to(l.ns_per_frame);
}

json document_of(const TextureQuestion& q) { return {int(q.kind), q.words, q.answer}; }
void read(const json& in, TextureQuestion& q) {
  q.kind = TextureQuestion::Kind(whole_number<int>(in.at(0)));
  in.at(1).get_to(q.words);
  in.at(2).get_to(q.answer);
}

json document_of(const std::filesystem::path& path) { return path.string(); }
void read(const json& in, std::filesystem::path& path) { path = in.get<std::string>(); }

json document_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
void read(const json& in, Eigen::Vector3d& v) {
  for (int axis = 0; axis < 3; ++axis) v[axis] = in.at(std::size_t(axis)).get<double>();
}

json document_of(const PatchListing& p) {
  return {p.number,    p.mesh, p.material, p.island,    p.triangles, document_of(p.middle), document_of(p.size),
          p.overrides, p.kept, p.root,     p.is_unsure, p.chain};
}
void read(const json& in, PatchListing& p) {
  in.at(0).get_to(p.number);
  in.at(1).get_to(p.mesh);
  in.at(2).get_to(p.material);
  in.at(3).get_to(p.island);
  in.at(4).get_to(p.triangles);
  read(in.at(5), p.middle);
  read(in.at(6), p.size);
  in.at(7).get_to(p.overrides);
  in.at(8).get_to(p.kept);
  in.at(9).get_to(p.root);
  in.at(10).get_to(p.is_unsure);
  in.at(11).get_to(p.chain);
}

template <class Item>
json list_of_documents(const std::vector<Item>& items) {
  json list = json::array();
  for (const Item& item : items) list.push_back(document_of(item));
  return list;
}

template <class Item>
void read_list(const json& in, std::vector<Item>& items) {
  for (const json& item : in) read(item, items.emplace_back());
}

json order_document(const OrderFigures& o) {
  return {o.orders, o.psnr, o.median, o.worst, o.moving, o.crossings, o.cuts, o.added, o.cut_gain};
}

void read(const json& in, OrderFigures& o) {
  std::uint32_t* const counts[] = {&o.orders, &o.crossings, &o.cuts, &o.added};
  constexpr std::size_t kPlaces[] = {0, 5, 6, 7};
  for (std::size_t i = 0; i < std::size(counts); ++i) *counts[i] = whole_number<std::uint32_t>(in.at(kPlaces[i]));
  in.at(1).get_to(o.psnr);
  in.at(2).get_to(o.median);
  in.at(3).get_to(o.worst);
  in.at(4).get_to(o.moving);
  in.at(8).get_to(o.cut_gain);
}

}  // namespace

json report_document(const CookReport& r) {
  return {{"passes", list_of_documents(r.passes)},
          {"warnings", r.warnings},
          {"notes", r.notes},
          {"decisions", r.decisions},
          {"left_out", list_of_documents(r.left_out)},
          {"figures",
           {r.triangles, r.vertices, r.patches, r.patches_by_index, r.patches_by_position, r.chains, r.bones,
            r.simulated_bones}},
          {"order", order_document(r.order)}};
}

CookReport report_from(const json& document) {
  CookReport r;
  read_list(document.at("passes"), r.passes);
  document.at("warnings").get_to(r.warnings);
  document.at("notes").get_to(r.notes);
  document.at("decisions").get_to(r.decisions);
  read_list(document.at("left_out"), r.left_out);
  std::uint32_t* const figures[] = {&r.triangles,           &r.vertices, &r.patches, &r.patches_by_index,
                                    &r.patches_by_position, &r.chains,   &r.bones,   &r.simulated_bones};
  for (std::size_t i = 0; i < std::size(figures); ++i)
    *figures[i] = whole_number<std::uint32_t>(document.at("figures").at(i));
  read(document.at("order"), r.order);
  return r;
}

json questions_document(const std::vector<TextureQuestion>& questions) { return list_of_documents(questions); }

std::vector<TextureQuestion> questions_from(const json& document) {
  std::vector<TextureQuestion> questions;
  read_list(document, questions);
  return questions;
}

std::vector<std::uint8_t> encode_result(const CookResult& result) {
  const json document{{"report", report_document(result.report)},
                      {"source_files", list_of_documents(result.inputs.source_files)},
                      {"recipe_files", list_of_documents(result.inputs.recipe_files)},
                      {"named_files", list_of_documents(result.inputs.named_files)},
                      {"questions", questions_document(result.inputs.questions)},
                      {"patches", list_of_documents(result.patches.patches)},
                      {"number_of_place", result.patches.number_of_place}};
  ByteEncoder encoder;
  encoder.sequence(json::to_msgpack(document));
  encoder.sequence(result.asset);
  return std::move(encoder.bytes);
}

CookResult decode_result(std::span<const std::uint8_t> bytes) {
  ByteDecoder decoder(bytes);
  std::vector<std::uint8_t> packed;
  CookResult result;
  if (!decoder.sequence(packed) || !decoder.sequence(result.asset) || !decoder.at_end())
    throw std::runtime_error("the bytes are no result of a cook");
  const json document = json::from_msgpack(packed);
  result.report = report_from(document.at("report"));
  read_list(document.at("source_files"), result.inputs.source_files);
  read_list(document.at("recipe_files"), result.inputs.recipe_files);
  read_list(document.at("named_files"), result.inputs.named_files);
  result.inputs.questions = questions_from(document.at("questions"));
  read_list(document.at("patches"), result.patches.patches);
  document.at("number_of_place").get_to(result.patches.number_of_place);
  return result;
}

}  // namespace coif::cook
