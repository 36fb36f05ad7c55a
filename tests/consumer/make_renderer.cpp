// Links the renderer without any OpenGL library: its functions come from the host, and a host without one is refused.
#include <coif/renderer.h>

int main() {
  coif::HairRenderer renderer;
  return renderer.create({}) == coif::Status::kBadArgument && !renderer.is_created() ? 0 : 1;
}
