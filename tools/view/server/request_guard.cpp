#include "view/server/request_guard.h"

#include "platform/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace coif::view {
namespace {

/// Takes the same time whichever character is wrong, so that timing does not show how much of a guess is right.
bool is_same_secret(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= unsigned(static_cast<unsigned char>(a[i] ^ b[i]));
  return difference == 0;
}

/// Between the first slash and the second.
std::string_view first_segment(std::string_view target) {
  if (!target.starts_with('/')) return {};
  const std::size_t end = target.find('/', 1);
  return end == target.npos ? std::string_view() : target.substr(1, end - 1);
}

}  // namespace

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  platform::fill_with_random_bytes(bytes);
  std::string digits;
  for (const unsigned byte : bytes) digits += fmt::format("{:02x}", byte);
  return digits;
}

RequestGuard::RequestGuard(std::uint16_t port, std::string token)
    : token_(std::move(token)), hosts_{fmt::format("127.0.0.1:{}", port), fmt::format("localhost:{}", port)} {}

std::string RequestGuard::address() const { return fmt::format("http://{}/{}/", hosts_[0], token_); }

bool RequestGuard::admits(const RequestOrigin& request) const {
  if (!request.host || !is_same_secret(first_segment(request.target), token_)) return false;
  if (std::ranges::find(hosts_, *request.host) == std::end(hosts_)) return false;
  // A page that is opened as localhost has that as its origin; a request to 127.0.0.1 from it comes from another site.
  return !request.origin || *request.origin == fmt::format("http://{}", *request.host);
}

}  // namespace coif::view
