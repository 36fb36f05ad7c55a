#include "render/egl_context.h"

#include <GLES3/gl3.h>

// After the header whose types it uses.
#include <GLES2/gl2ext.h>

#include <string_view>

namespace coif::render {
namespace {

constexpr std::string_view kExtension = "GL_EXT_disjoint_timer_query";
constexpr double kSecondsPerTick = 1e-9;

template <typename Function>
bool find(const GlLoader& loader, const char* name, Function& function) {
  function = reinterpret_cast<Function>(loader.get_proc(name, loader.user));
  return function != nullptr;
}

/// Mesa's llvmpipe fills a picture tile by tile and reports only the last tile's time: 10 ms of the 536 ms that ten
/// triangles over all of 1024 x 768 pixels take. It does not count vertices at all.
bool counts_parts_only(const GlLoader& loader) {
  PFNGLGETSTRINGPROC get_string = nullptr;
  if (!find(loader, "glGetString", get_string)) return true;
  const auto* device = reinterpret_cast<const char*>(get_string(GL_RENDERER));
  return device == nullptr || std::string_view(device).starts_with("llvmpipe");
}

/// The extension may be there with a counter of no bits.
bool counts_time(const GlLoader& loader) {
  PFNGLGETQUERYIVEXTPROC get_query = nullptr;
  if (!find(loader, "glGetQueryivEXT", get_query)) return false;
  GLint bits = 0;
  get_query(GL_TIME_ELAPSED_EXT, GL_QUERY_COUNTER_BITS_EXT, &bits);
  return bits > 0;
}

}  // namespace

GpuTimer::GpuTimer(const GlLoader& loader) {
  if (!has_extension(loader, kExtension) || counts_parts_only(loader) || !counts_time(loader)) return;
  PFNGLGENQUERIESEXTPROC gen_queries = nullptr;
  const bool complete =
      find(loader, "glGetIntegerv", gl_.get_integer) && find(loader, "glBeginQueryEXT", gl_.begin_query) &&
      find(loader, "glEndQueryEXT", gl_.end_query) && find(loader, "glGetQueryObjectuivEXT", gl_.get_uint) &&
      find(loader, "glGetQueryObjectui64vEXT", gl_.get_uint64) && find(loader, "glGenQueriesEXT", gen_queries);
  if (complete) gen_queries(1, &query_);
}

/// Asking takes the sign back.
bool GpuTimer::was_disjoint() const {
  int disjoint = 0;
  gl_.get_integer(GL_GPU_DISJOINT_EXT, &disjoint);
  return disjoint != 0;
}

void GpuTimer::begin() {
  if (!is_present()) return;
  (void)was_disjoint();  // Earlier disturbances do not matter.
  is_waiting_ = false;
  gl_.begin_query(GL_TIME_ELAPSED_EXT, query_);
}

void GpuTimer::end() {
  if (!is_present()) return;
  gl_.end_query(GL_TIME_ELAPSED_EXT);
  is_waiting_ = true;
}

std::optional<double> GpuTimer::poll() {
  if (!is_waiting_) return {};
  unsigned available = 0;
  gl_.get_uint(query_, GL_QUERY_RESULT_AVAILABLE_EXT, &available);
  if (available == 0) return {};
  is_waiting_ = false;
  std::uint64_t ticks = 0;
  gl_.get_uint64(query_, GL_QUERY_RESULT_EXT, &ticks);
  // Looked at last: a disturbance up to here may have touched the figure.
  if (was_disjoint() || ticks == 0) return {};
  return kSecondsPerTick * double(ticks);
}

}  // namespace coif::render
