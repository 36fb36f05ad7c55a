#pragma once

#include <filesystem>
#include <string>

namespace coif::report {

/// What a link sets on the page of `coif view`, by the words of its controls; empty, or a rate of 0: as the page comes.
struct ViewLink {
  std::string motion{}, solver{}, beside{};
  double rate = 0;  ///< Steps a second.
};

/// Where `target` lies, as a page at `from` links it: relative, as a URL. Any byte may be in a name.
[[nodiscard]] std::string relative_url(const std::filesystem::path& target, const std::filesystem::path& from);

/// `page`, a URL, with these settings; a motion plays.
[[nodiscard]] std::string view_url(const std::string& page, const ViewLink& link);

}  // namespace coif::report
