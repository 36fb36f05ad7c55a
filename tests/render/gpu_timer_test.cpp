#include "render/egl_context.h"

#include "gl/gl_test.h"

#include <GLES3/gl3.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

// After the header whose types it uses.
#include <GLES2/gl2ext.h>

namespace coif::render::gpu_timer_test {

/// A device whose answers a test makes up. One at a time: OpenGL's functions do not know who calls.
class MadeUpDevice {
 public:
  MadeUpDevice() { current = this; }
  ~MadeUpDevice() { current = nullptr; }
  MadeUpDevice(const MadeUpDevice&) = delete;
  MadeUpDevice& operator=(const MadeUpDevice&) = delete;

  [[nodiscard]] GlLoader loader() { return {find, this}; }

  std::vector<std::string> extensions{"GL_OTHER", "GL_EXT_disjoint_timer_query"};
  std::string renderer = "DrawnCard 3000";  ///< GL_RENDERER.
  std::string missing;                      ///< A function that is not found.
  int counter_bits = 64;
  bool disjoint = false;
  bool available = true;
  std::uint64_t ticks = 2'000'000;
  int begun = 0, ended = 0, fetched = 0;

 private:
  static inline MadeUpDevice* current = nullptr;

  static void get_integer(GLenum name, GLint* value) {
    if (name == GL_NUM_EXTENSIONS) *value = int(current->extensions.size());
    if (name != GL_GPU_DISJOINT_EXT) return;
    *value = current->disjoint ? 1 : 0;
    current->disjoint = false;
  }
  static const GLubyte* get_string(GLenum, GLuint index) {
    return reinterpret_cast<const GLubyte*>(current->extensions[index].c_str());
  }
  static const GLubyte* get_name(GLenum) { return reinterpret_cast<const GLubyte*>(current->renderer.c_str()); }
  static void get_query(GLenum, GLenum, GLint* value) { *value = current->counter_bits; }
  static void gen_queries(GLsizei, GLuint* queries) { *queries = 7; }
  static void begin_query(GLenum, GLuint) { ++current->begun; }
  static void end_query(GLenum) { ++current->ended; }
  static void get_uint(GLuint, GLenum, GLuint* value) { *value = current->available ? 1 : 0; }
  static void get_uint64(GLuint, GLenum, GLuint64* value) {
    ++current->fetched;
    *value = current->ticks;
  }

  static void* find(const char* name, void* user) {
    const std::string asked = name;
    if (asked == static_cast<MadeUpDevice*>(user)->missing) return nullptr;
    if (asked == "glGetIntegerv") return reinterpret_cast<void*>(get_integer);
    if (asked == "glGetStringi") return reinterpret_cast<void*>(get_string);
    if (asked == "glGetString") return reinterpret_cast<void*>(get_name);
    if (asked == "glGetQueryivEXT") return reinterpret_cast<void*>(get_query);
    if (asked == "glGenQueriesEXT") return reinterpret_cast<void*>(gen_queries);
    if (asked == "glBeginQueryEXT") return reinterpret_cast<void*>(begin_query);
    if (asked == "glEndQueryEXT") return reinterpret_cast<void*>(end_query);
    if (asked == "glGetQueryObjectuivEXT") return reinterpret_cast<void*>(get_uint);
    if (asked == "glGetQueryObjectui64vEXT") return reinterpret_cast<void*>(get_uint64);
    return nullptr;
  }
};

std::optional<double> measure(GpuTimer& timer) {
  timer.begin();
  timer.end();
  return timer.poll();
}

TEST(GpuTimer, GivesWhatTheDeviceCountedInSecondsOnce) {
  MadeUpDevice device;
  GpuTimer timer(device.loader());
  ASSERT_TRUE(timer.is_present());
  EXPECT_EQ(timer.poll(), std::nullopt) << "before anything was measured";
  EXPECT_EQ(measure(timer), 0.002);
  EXPECT_EQ(timer.poll(), std::nullopt) << "a second time";
  EXPECT_EQ(device.begun, 1);
  EXPECT_EQ(device.ended, 1);
}

TEST(GpuTimer, WithoutTheExtensionAsksForNothing) {
  MadeUpDevice device;
  device.extensions = {"GL_OTHER", "GL_EXT_disjoint_timer_query_webgl2"};
  GpuTimer timer(device.loader());
  EXPECT_FALSE(timer.is_present());
  EXPECT_EQ(measure(timer), std::nullopt);
  EXPECT_EQ(device.begun + device.ended + device.fetched, 0);
}

TEST(GpuTimer, ADeviceKnownToCountOnlyPartsIsNoTimer) {
  MadeUpDevice device;
  device.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
  GpuTimer timer(device.loader());
  EXPECT_FALSE(timer.is_present());
  EXPECT_EQ(measure(timer), std::nullopt);
  EXPECT_EQ(device.begun, 0);
}

TEST(GpuTimer, ACounterWithoutBitsIsNoTimer) {
  MadeUpDevice device;
  device.counter_bits = 0;
  EXPECT_FALSE(GpuTimer(device.loader()).is_present());
}

TEST(GpuTimer, AMissingFunctionIsNoTimer) {
  for (const char* name : {"glGetIntegerv", "glGetStringi", "glGetString", "glGetQueryivEXT", "glGenQueriesEXT",
                           "glBeginQueryEXT", "glEndQueryEXT", "glGetQueryObjectuivEXT", "glGetQueryObjectui64vEXT"}) {
    MadeUpDevice device;
    device.missing = name;
    EXPECT_FALSE(GpuTimer(device.loader()).is_present()) << name;
  }
}

TEST(GpuTimer, NeverFetchesWhatTheDeviceHasNotFinished) {
  MadeUpDevice device;
  device.available = false;
  GpuTimer timer(device.loader());
  EXPECT_EQ(measure(timer), std::nullopt);
  EXPECT_EQ(device.fetched, 0) << "that would wait";
  device.available = true;
  EXPECT_EQ(timer.poll(), 0.002) << "a frame later";
}

TEST(GpuTimer, ADisturbedClockGivesNoFigure) {
  MadeUpDevice device;
  GpuTimer timer(device.loader());
  timer.begin();
  timer.end();
  device.disjoint = true;
  EXPECT_EQ(timer.poll(), std::nullopt);
  EXPECT_EQ(timer.poll(), std::nullopt) << "nor later";
  EXPECT_EQ(measure(timer), 0.002) << "the next measurement counts again";
}

TEST(GpuTimer, ADisturbanceBeforeTheMeasurementDoesNotCount) {
  MadeUpDevice device;
  GpuTimer timer(device.loader());
  device.disjoint = true;
  EXPECT_EQ(measure(timer), 0.002);
}

TEST(GpuTimer, AClockThatStoodStillGivesNoFigure) {
  MadeUpDevice device;
  device.ticks = 0;
  GpuTimer timer(device.loader());
  EXPECT_EQ(measure(timer), std::nullopt);
}

class GpuTimerOnDevice : public GlTest {};

TEST_F(GpuTimerOnDevice, LeavesNoErrorAndCountsNoMoreThanTheClockOnTheWall) {
  const GlLoader loader = context_->loader();
  GpuTimer timer(loader);
  const auto begin = std::chrono::steady_clock::now();
  timer.begin();
  draw_cards(std::array{DrawnCard{}});
  timer.end();
  glFinish();
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  const std::optional<double> seconds = timer.poll();
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  EXPECT_TRUE(timer.is_present() || !seconds);
  EXPECT_LE(seconds.value_or(0), wall.count());
}

}  // namespace coif::render::gpu_timer_test
