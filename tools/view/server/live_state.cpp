#include "view/server/live_state.h"

#include <utility>

namespace coif::view {

LiveState::LiveState(std::string quality) : quality_(std::move(quality)) {}

void LiveState::tell() {
  ++number_;
  changed_.notify_all();
}

void LiveState::begin() {
  const std::lock_guard guard(lock_);
  is_cooking_ = true;
  tell();
}

void LiveState::publish(std::uint64_t request, LiveResult result) {
  auto asset = std::make_shared<LiveAsset>();
  asset->bytes = std::exchange(result.asset, {});
  const std::lock_guard guard(lock_);
  asset->revision = asset_ ? asset_->revision + 1 : 1;
  asset_ = std::move(asset);
  result_ = std::move(result);
  problem_.clear();
  request_ = request;
  is_cooking_ = false;
  tell();
}

void LiveState::fail(std::uint64_t request, std::string problem) {
  const std::lock_guard guard(lock_);
  problem_ = std::move(problem);
  request_ = request;
  is_cooking_ = false;
  tell();
}

void LiveState::close() {
  const std::lock_guard guard(lock_);
  is_closed_ = true;
  changed_.notify_all();
}

std::shared_ptr<const LiveAsset> LiveState::asset() const {
  const std::lock_guard guard(lock_);
  return asset_;
}

LiveState::News LiveState::wait(std::uint64_t seen, std::chrono::milliseconds longest) {
  std::unique_lock guard(lock_);
  changed_.wait_for(guard, longest, [&] { return is_closed_ || number_ != seen; });
  if (is_closed_) return {number_, "", true};
  return {number_, number_ != seen ? json() : "", false};
}

std::string LiveState::json() const {
  const nlohmann::ordered_json all{{"revision", asset_ ? asset_->revision : 0},
                                   {"request", request_},
                                   {"cooking", is_cooking_},
                                   {"problem", problem_},
                                   {"name", result_.name},
                                   {"quality", quality_},
                                   {"seconds", result_.seconds},
                                   {"warnings", result_.warnings},
                                   {"recipe_file", result_.recipe_file},
                                   {"changes", result_.changes}};
  // Names from artists' files need not be UTF-8.
  return all.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace coif::view
