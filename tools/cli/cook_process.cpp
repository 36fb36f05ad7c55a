#include "cli/cook_process.h"

#include "base/byte_archive.h"
#include "base/json.h"
#include "cards/hair_source.h"
#include "cook/cook.h"
#include "cook/pack/pack.h"
#include "import/reader_process.h"
#include "validate/find_issues.h"

#include <chrono>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <utility>

namespace coif::cli {
namespace {

using Document = nlohmann::json;

platform::Bytes encode_order(const CookOrder& order) {
  const Document document{{"source", order.source},
                          {"recipe", cook::print_recipe(order.recipe)},
                          {"recipe_directory", order.recipe_directory.string()},
                          {"import", importer::import_document(order.import)},
                          {"source_hash", order.source_hash},
                          {"threads", order.threads},
                          {"draft", order.draft},
                          {"list_patches", order.list_patches},
                          {"cooks", order.cooks},
                          {"keeps_model", order.keeps_model},
                          {"finds_issues", order.finds_issues}};
  ByteEncoder encoder;
  encoder.sequence(Document::to_msgpack(document));
  encoder.sequence(order.model);
  return std::move(encoder.bytes);
}

/// Throws where the bytes are not those of encode_order(), which runs in the same program.
CookOrder decode_order(std::span<const std::uint8_t> bytes) {
  ByteDecoder decoder(bytes);
  platform::Bytes packed;
  CookOrder order;
  if (!decoder.sequence(packed) || !decoder.sequence(order.model)) throw std::runtime_error("no order of a cook");
  const Document document = Document::from_msgpack(packed);
  document.at("source").get_to(order.source);
  order.recipe = cook::parse_recipe(document.at("recipe").get<std::string>(), order.source).value();
  order.recipe_directory = document.at("recipe_directory").get<std::string>();
  order.import = importer::import_settings_from(document.at("import"));
  document.at("source_hash").get_to(order.source_hash);
  document.at("threads").get_to(order.threads);
  document.at("draft").get_to(order.draft);
  document.at("list_patches").get_to(order.list_patches);
  document.at("cooks").get_to(order.cooks);
  document.at("keeps_model").get_to(order.keeps_model);
  document.at("finds_issues").get_to(order.finds_issues);
  return order;
}

using CookOutcome = tl::expected<CookAnswer, FailedCook>;

platform::Bytes encode_outcome_of_cook(const CookOutcome& outcome) {
  Document document{{"is_done", outcome.has_value()}, {"issues", outcome ? outcome->issues : outcome.error().issues}};
  if (!outcome) {
    document["kind"] = int(outcome.error().kind);
    document["message"] = outcome.error().message;
  }
  ByteEncoder encoder;
  encoder.sequence(Document::to_msgpack(document));
  if (outcome) {
    encoder.raw(&outcome->provenance, sizeof outcome->provenance);
    encoder.sequence(cook::encode_result(outcome->result));
    encoder.sequence(outcome->model);
  }
  return std::move(encoder.bytes);
}

CookOutcome decode_outcome_of_cook(std::span<const std::uint8_t> bytes) {
  ByteDecoder decoder(bytes);
  platform::Bytes packed, result;
  if (!decoder.sequence(packed)) throw std::runtime_error("no outcome of a cook");
  const Document document = Document::from_msgpack(packed);
  auto issues = document.at("issues").get<Diagnostics>();
  if (!document.at("is_done").get<bool>()) {
    return tl::unexpected(
        FailedCook({ToolError::Kind(document.at("kind").get<int>()), document.at("message").get<std::string>()},
                   std::move(issues)));
  }
  CookAnswer answer{};
  if (!decoder.raw(&answer.provenance, sizeof answer.provenance) || !decoder.sequence(result) ||
      !decoder.sequence(answer.model))
    throw std::runtime_error("no outcome of a cook");
  answer.issues = std::move(issues);
  answer.result = cook::decode_result(result);
  return answer;
}

// Runs in the child.

/// A model that came along takes no time.
importer::ImportOutcome model_of_order(const CookOrder& order, const platform::Threads& threads,
                                       const std::function<void(const char*)>& begin_part) {
  if (!order.model.empty()) {
    importer::ImportOutcome kept;
    if (!importer::decode_model(order.model, kept)) throw std::runtime_error("no model of an earlier answer");
    return kept;
  }
  begin_part("import");
  importer::ImportSettings import = order.import;
  import.stop = threads.stop;
  return cards::read_hair_source(order.source, order.draft ? cook::draft_of(order.recipe) : order.recipe,
                                 {import, order.recipe_directory, threads, begin_part});
}

CookOutcome cook_here(const CookOrder& order, const platform::Threads& threads,
                      const std::function<void(const char*)>& begin_part) {
  const auto begin = std::chrono::steady_clock::now();
  importer::ImportOutcome model = model_of_order(order, threads, begin_part);
  if (!model) return tl::unexpected(FailedCook(model.error()));
  const std::chrono::duration<double, std::milli> import_ms = std::chrono::steady_clock::now() - begin;
  CookAnswer answer;
  answer.provenance = cook::make_provenance(*model, cook::recipe_hash(order.recipe), order.source_hash);
  if (order.cooks) {
    cook::CookSettings settings;
    settings.threads = threads;
    settings.recipe_directory = order.recipe_directory;
    settings.source_hash = order.source_hash;
    settings.progress = begin_part;
    settings.draft = order.draft;
    settings.list_patches = order.list_patches;
    auto result = cook::cook(*model, order.recipe, settings);
    if (order.finds_issues || !result) answer.issues = validate::find_source_issues(*model, order.recipe, result);
    if (!result && !order.finds_issues) return tl::unexpected(FailedCook(result.error(), std::move(answer.issues)));
    if (result) answer.result = std::move(*result);
    auto& passes = answer.result.report.passes;
    passes.insert(passes.begin(), {"import", import_ms.count()});
  }
  if (order.keeps_model) answer.model = importer::encode_model(std::move(model));
  return answer;
}

platform::Bytes answer_order(const platform::JobCall& call) {
  const CookOrder order = decode_order(call.request());
  const platform::Threads threads(order.threads, call.stop());
  return encode_outcome_of_cook(cook_here(order, threads, [&call](const char* part) { call.note(part); }));
}

const platform::Job kCook("cook", answer_order);

}  // namespace

tl::expected<CookAnswer, FailedCook> cook_in_child(const CookOrder& order, const LimitedCall& call) {
  const auto answer = run_within_limits(kCook, encode_order(order), call);
  if (!answer) return tl::unexpected(FailedCook(answer.error()));
  return decode_outcome_of_cook(*answer);
}

}  // namespace coif::cli
