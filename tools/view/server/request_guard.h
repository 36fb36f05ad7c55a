#pragma once

#include "base/tool_error.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace coif::view {

/// 128 bits of the system's generator in hexadecimal digits. Throws std::system_error where there is none.
[[nodiscard]] std::string random_token();

/// What a request says of where it comes from. Owns it: what a comparison reads is nobody else's to give back.
struct RequestOrigin {
  std::string target;                 ///< As it was sent: the path, and what follows a question mark.
  std::optional<std::string> host;    ///< The one header of that name; none where there is none, or several.
  std::optional<std::string> origin;  ///< None where the header is absent; empty where there are several.
};

/// Whom a server on the loopback address answers: requests that know the token and come from its own page. Other pages
/// of the same browser, other users of the machine, and names that somebody else's DNS turns into this address are
/// refused.
class RequestGuard {
 public:
  RequestGuard(std::uint16_t port, std::string token);

  /// Where people find the page: http://127.0.0.1:PORT/TOKEN/
  [[nodiscard]] std::string address() const;
  [[nodiscard]] const std::string& token() const { return token_; }

  [[nodiscard]] bool admits(const RequestOrigin& request) const;

 private:
  std::string token_;
  std::string hosts_[2];  ///< 127.0.0.1:PORT and localhost:PORT
};

/// The page of view_page() as the server sends it: it asks for its asset, and a browser runs no script in it but those
/// that carry `nonce`. kBadInput for a file that is no such page.
[[nodiscard]] tl::expected<std::string, ToolError> live_page(std::string_view page, std::string_view nonce);

/// Content-Security-Policy of that page: nothing from elsewhere, and nothing that was put into it later.
[[nodiscard]] std::string live_policy(std::string_view nonce);

}  // namespace coif::view
