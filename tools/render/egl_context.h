#pragma once

#include "base/tool_error.h"

#include <coif/renderer.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coif::render {

/// An OpenGL ES 3.0 context without a window, current on the thread that made it, freed with this object. All objects
/// made in it die with it. One at a time.
class EglContext {
 public:
  /// Tries Mesa's surfaceless platform, then the default display. kUnsupported when neither gives a context.
  static tl::expected<EglContext, ToolError> create();

  EglContext(EglContext&& other) noexcept;
  EglContext& operator=(EglContext&&) = delete;
  ~EglContext();

  [[nodiscard]] GlLoader loader() const;
  [[nodiscard]] std::string device() const;  ///< GL_RENDERER.

 private:
  struct Handles {  // EGLDisplay and the like; their header stays in the .cpp
    void* display = nullptr;
    void* surface = nullptr;
    void* context = nullptr;
  };
  explicit EglContext(const Handles& handles) : handles_(handles) {}
  static void release(Handles& handles);
  static bool open(void* display, Handles& handles);

  Handles handles_;
};

/// Whether the current context has an extension, using this loader's functions.
[[nodiscard]] bool has_extension(const GlLoader& loader, std::string_view wanted);

/// A context with the runtime's renderer in it.
struct DrawingDevice {
  /// `through`: the loader for the renderer, for callers that watch its calls; null: the context's own. Errors:
  /// kUnsupported where there is no context or the renderer does not start.
  static tl::expected<std::unique_ptr<DrawingDevice>, ToolError> create(const RendererDesc& desc = {},
                                                                        const GlLoader* through = nullptr);

  explicit DrawingDevice(EglContext opened) : context(std::move(opened)) {}

  EglContext context;  ///< Destroyed after the objects made in it.
  HairRenderer renderer;
};

/// A framebuffer with depth, four samples per pixel where the driver has them. Its objects are freed with the OpenGL
/// context.
class OffscreenTarget {
 public:
  enum class Pixels { kSrgb, kRadiance };

  /// kRadiance: half floats, linear, more than white too; sRGB all the same where the driver cannot draw to them.
  static tl::expected<OffscreenTarget, ToolError> create(std::uint32_t width, std::uint32_t height,
                                                         std::uint32_t samples = 4, Pixels pixels = Pixels::kSrgb);

  /// Makes it the framebuffer that is drawn to, with its whole area as viewport.
  void bind() const;

  /// Samples per pixel, as the driver gives them; 1 without multisampling.
  [[nodiscard]] std::uint32_t samples() const { return samples_; }

  /// Resolved pixels, RGBA, sRGB-encoded, rows top to bottom.
  [[nodiscard]] std::vector<std::uint8_t> read() const;

  /// The pixels, linear; above 1 only where there are half floats.
  [[nodiscard]] std::vector<float> read_radiance() const;

 private:
  /// Resolves samples and binds the result for reading.
  void resolve() const;

  std::uint32_t width_ = 0;
  std::uint32_t height_ = 0;
  std::uint32_t samples_ = 1;
  Pixels pixels_ = Pixels::kSrgb;
  std::uint32_t drawn_ = 0;     ///< Framebuffer object with samples and depth.
  std::uint32_t resolved_ = 0;  ///< Framebuffer object to read from.
};

/// Measures how long the device itself was busy with the commands between begin() and end(), by the extension
/// GL_EXT_disjoint_timer_query. Without the extension, or with a disturbed clock, there is no result. One measurement
/// at a time, and no other query of elapsed time inside it. Its query object is freed with the context, which must be
/// current in every call.
class GpuTimer {
 public:
  /// Looks for the extension in the current context and for its functions with `loader`, which only this call uses.
  /// Absent, too, on devices that have it but count something else: Mesa's llvmpipe, where the processor draws.
  explicit GpuTimer(const GlLoader& loader);

  /// False: nothing will ever be measured, and the other calls do nothing.
  [[nodiscard]] bool is_present() const { return query_ != 0; }

  /// A measurement that was not fetched yet is given up.
  void begin();
  void end();

  /// Seconds, once. Never waits: none while the device is not done, so a game asks again a frame later; after glFinish
  /// it is done. None, now and later, where the device's clock was disturbed (for example by a change of its speed) or
  /// did not count at all.
  [[nodiscard]] std::optional<double> poll();

 private:
  /// Uses types of OpenGL's own header, which users of this header need not include.
  struct Functions {
    void (*get_integer)(unsigned name, int* value) = nullptr;
    void (*begin_query)(unsigned target, unsigned query) = nullptr;
    void (*end_query)(unsigned target) = nullptr;
    void (*get_uint)(unsigned query, unsigned name, unsigned* value) = nullptr;
    void (*get_uint64)(unsigned query, unsigned name, std::uint64_t* value) = nullptr;
  };

  [[nodiscard]] bool was_disjoint() const;

  Functions gl_;
  unsigned query_ = 0;
  bool is_waiting_ = false;
};

}  // namespace coif::render
