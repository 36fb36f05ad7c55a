// A tool of a game that reads assets and nothing else.
#include <coif/asset.h>

int main() {
  alignas(64) static constexpr std::byte kText[256] = {};
  coif::Asset asset;
  return !asset.open(kText) && !asset.is_open() ? 0 : 1;
}
