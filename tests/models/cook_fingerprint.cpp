#include "models/cook_fingerprint.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

namespace coif {
namespace {

/// Bytes and hash by chunk.
using Fingerprint = std::map<std::string, std::string>;

Fingerprint fingerprint_of(const Asset& asset) {
  Fingerprint found;
  for (const ChunkEntry& entry : asset.chunks()) {
    if (entry.id == chunk::kProvenance) continue;
    const char id[] = {char(entry.id), char(entry.id >> 8), char(entry.id >> 16), char(entry.id >> 24), 0};
    found[id] = fmt::format("{} {:016x}", entry.bytes, entry.hash);
  }
  return found;
}

Fingerprint kept_of(const std::string& name) {
  Fingerprint kept;
  std::ifstream file(COIF_GOLDEN_FOLDER "/cooks.txt");
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string cook, id, bytes, hash;
    if (words >> cook >> id >> bytes >> hash && cook == name) kept[id] = bytes + " " + hash;
  }
  return kept;
}

}  // namespace

testing::AssertionResult is_cooked_as_before(const std::string& name, const Asset& asset) {
  const Fingerprint found = fingerprint_of(asset), kept = kept_of(name);
  if (const char* const renewed = std::getenv("COIF_RENEW_COOKS")) {
    std::ofstream file(renewed, std::ios::app);
    for (const auto& [id, print] : found) file << name << ' ' << id << ' ' << print << '\n';
    return testing::AssertionSuccess();
  }
  std::string changed;
  for (const auto& [id, print] : found) {
    const auto before = kept.find(id);
    if (before == kept.end()) changed += " +" + id;
    if (before != kept.end() && before->second != print) changed += " " + id;
  }
  for (const auto& [id, print] : kept) changed += found.contains(id) ? "" : " -" + id;
  if (changed.empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "the cook of '" << name << "' gives other chunks:" << changed
                                     << "; where that is meant: tests/golden/renew.sh BUILD_FOLDER";
}

}  // namespace coif
