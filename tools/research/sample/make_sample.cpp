// coif_make_sample [bob|long|portrait] OUT.glb [QUADS [COPIES]]: writes a sample head of hair, by default the bob; with
// numbers, a bob of another density.

#include "base/files.h"
#include "research/sample/bob.h"
#include "research/sample/long.h"

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <vector>

namespace {

struct Order {
  const char* path = nullptr;
  std::string_view style = "bob";
  coif::research::BobDensity density;
};

std::optional<Order> read_order(int argc, char** argv) {
  Order order;
  const std::string_view first = argc > 1 ? argv[1] : "";
  const bool names_style = first == "bob" || first == "long" || first == "portrait";
  if (names_style) order.style = first;
  const int path = names_style ? 2 : 1;
  const int most = order.style == "bob" ? path + 3 : path + 1;
  if (argc <= path || argc > most) return std::nullopt;
  order.path = argv[path];
  if (argc > path + 1) order.density.quads = std::atof(argv[path + 1]);
  if (argc > path + 2) order.density.copies = std::atoi(argv[path + 2]);
  const coif::research::BobDensity& d = order.density;
  if (!(d.quads > 0 && d.quads <= 100 && d.copies >= 1 && d.copies <= 1000)) return std::nullopt;
  return order;
}

std::vector<std::byte> make(const Order& order) {
  if (order.style == "long") return coif::research::make_long();
  if (order.style == "portrait") return coif::research::make_portrait();
  return coif::research::make_bob(order.density);
}

}  // namespace

int main(int argc, char** argv) {
  const auto order = read_order(argc, argv);
  if (!order) {
    std::fputs(
        "usage: coif_make_sample [bob] OUT.glb [QUADS [COPIES]]\n"
        "       coif_make_sample long|portrait OUT.glb\n"
        "  QUADS   rows and columns of each strip, as a share of the sample's, up to 100\n"
        "  COPIES  strips in place of each, 1 to 1000\n",
        stderr);
    return 1;
  }
  const std::vector<std::byte> bytes = make(*order);
  if (!coif::write_output(order->path, bytes)) {
    std::fprintf(stderr, "coif_make_sample: error: %s: cannot write; check that the folder exists and is writable\n",
                 order->path);
    return 2;
  }
  std::printf("%s: %zu bytes\n", order->path, bytes.size());
  return 0;
}
