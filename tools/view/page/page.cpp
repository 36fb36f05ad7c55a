// The functions that the page's scripts call. One asset, one canvas, one or several views of it. Functions that may
// fail return null or a sentence that is valid until the next call.

#include "motion/head_path.h"
#include "view/body/page_body.h"
#include "view/page/hair_views.h"
#include "view/page/view_session.h"

#include <emscripten/emscripten.h>
#include <emscripten/html5.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

struct Page {
  EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = 0;
  std::vector<std::byte> incoming;
  std::vector<coif::motion::ClipKey> clip;                      ///< Keys of whatever is opened.
  std::shared_ptr<coif::view::PageBody> body;                   ///< Beneath the hair of whatever is opened.
  std::vector<std::unique_ptr<coif::view::ViewSession>> views;  ///< First the page's own, then tiles of a sheet.
  coif::view::ViewSession* session = nullptr;                   ///< The one that all functions are about.
  std::string said;
  bool has_drawn = false;
};

Page& page() {
  static Page only;
  return only;
}

const char* say(std::string text) {
  page().said = std::move(text);
  return page().said.c_str();
}

const char* outcome(const tl::expected<void, coif::ToolError>& done) {
  return done ? nullptr : say(done.error().message);
}

/// Replaces all existing views.
const char* show(std::unique_ptr<coif::view::ViewSession> session) {
  page().session = session.get();
  page().views.clear();
  page().views.push_back(std::move(session));
  return outcome(page().session->start_drawing());
}

}  // namespace

extern "C" {

/// On the canvas with the id "picture".
EMSCRIPTEN_KEEPALIVE const char* coif_view_start() {
  EmscriptenWebGLContextAttributes wanted;
  emscripten_webgl_init_context_attributes(&wanted);
  wanted.alpha = wanted.depth = wanted.stencil = wanted.antialias = false;
  wanted.preserveDrawingBuffer = true;  // a frame that changes nothing is not drawn
  wanted.powerPreference = EM_WEBGL_POWER_PREFERENCE_HIGH_PERFORMANCE;
  wanted.majorVersion = 2;
  page().context = emscripten_webgl_create_context("#picture", &wanted);
  if (page().context <= 0)
    return say(
        "this browser has no WebGL 2, which the picture needs; another browser, or one with its graphics acceleration "
        "turned on, has");
  emscripten_webgl_make_context_current(page().context);
  return nullptr;
}

/// Memory of this size, into which the script writes a file before coif_view_open().
EMSCRIPTEN_KEEPALIVE void* coif_view_room(std::size_t bytes) {
  page().incoming.assign(bytes, std::byte{});
  return page().incoming.data();
}

/// Takes the written clip_bytes() as a motion for all assets that are opened from now on.
EMSCRIPTEN_KEEPALIVE const char* coif_view_clip() {
  page().clip = coif::motion::clip_keys(std::exchange(page().incoming, {}));
  return page().clip.empty() ? say("the page's clip is damaged; make the page again") : nullptr;
}

/// Takes the written body_bytes() as what is beneath the hair of all assets that are opened from now on; no bytes:
/// nothing is.
EMSCRIPTEN_KEEPALIVE const char* coif_view_body() {
  page().body.reset();
  const std::vector<std::byte> bytes = std::exchange(page().incoming, {});
  if (bytes.empty()) return nullptr;
  auto body = coif::view::page_body(bytes);
  if (!body) return say("the page's body is damaged; make the page again");
  page().body = std::make_shared<coif::view::PageBody>(std::move(*body));
  return nullptr;
}

/// Takes the written RGBA pixels as the body's image of this number.
EMSCRIPTEN_KEEPALIVE void coif_view_body_image(std::uint32_t number, std::uint32_t width, std::uint32_t height) {
  const std::vector<std::byte> bytes = std::exchange(page().incoming, {});
  if (!page().body || bytes.size() != std::size_t{4} * width * height) return;
  const auto* const first = reinterpret_cast<const std::uint8_t*>(bytes.data());
  const auto texture = std::make_shared<coif::render::SolidTexture>(
      coif::render::SolidTexture{width, height, {first, first + bytes.size()}});
  for (coif::view::PageBodyMesh& mesh : page().body->meshes) {
    if (mesh.image == number) mesh.mesh.texture = texture;
  }
}

/// Opens the written file. If it is refused, the one that is shown stays.
EMSCRIPTEN_KEEPALIVE const char* coif_view_open() {
  auto session = coif::view::ViewSession::open(std::exchange(page().incoming, {}));
  if (!session) return say(session.error().message);
  (*session)->set_clip(page().clip);
  (*session)->set_body(page().body);
  return show(std::move(*session));
}

/// Replaces the asset by another cook of it, at the same time of the motion. The settings become the asset's; the
/// script then restores those that stay.
EMSCRIPTEN_KEEPALIVE const char* coif_view_replace() {
  auto session = coif::view::ViewSession::open(std::exchange(page().incoming, {}));
  if (!session) return say(session.error().message);
  (*session)->set_clip(page().clip);
  (*session)->set_body(page().body);
  const coif::view::ViewSettings own = (*session)->settings();
  if (page().session) {
    if (auto gone_on = (*session)->go_on(*page().session); !gone_on) return say(gone_on.error().message);
  }
  (*session)->settings() = own;
  return show(std::move(*session));
}

/// Adds another view of the open asset. Returns its number; the page's own is 0.
EMSCRIPTEN_KEEPALIVE std::uint32_t coif_view_add() {
  if (page().views.empty()) return 0;
  page().views.push_back(page().views.front()->another());
  return std::uint32_t(page().views.size() - 1);
}
/// From here on all functions use this view.
EMSCRIPTEN_KEEPALIVE void coif_view_choose(std::uint32_t number) {
  if (number < page().views.size()) page().session = page().views[number].get();
}
EMSCRIPTEN_KEEPALIVE void coif_view_redraw() {
  if (page().session) page().session->redraw();
}
EMSCRIPTEN_KEEPALIVE const char* coif_view_seek(double seconds) {
  return page().session ? outcome(page().session->seek(seconds)) : nullptr;
}

/// When the browser has taken the context away.
EMSCRIPTEN_KEEPALIVE void coif_view_lose() {
  if (page().session) page().session->stop_drawing();
}

/// When it has given the context back, with its extensions.
EMSCRIPTEN_KEEPALIVE const char* coif_view_restore() {
  return page().session ? outcome(page().session->start_drawing()) : nullptr;
}

EMSCRIPTEN_KEEPALIVE const char* coif_view_controls() {
  return page().session ? say(coif::view::controls_json(page().session->asset(), !page().clip.empty())) : say("[]");
}

/// The meaning of the view's colours: legend_json().
EMSCRIPTEN_KEEPALIVE const char* coif_view_legend() {
  if (!page().session) return nullptr;
  const coif::view::ViewSettings& settings = page().session->settings();
  return say(coif::view::legend_json(page().session->asset(), coif::view::hair_view_of(settings.view),
                                     std::uint32_t(settings.lod)));
}

/// The motion of the asset as it was opened: AssetMotion::json().
EMSCRIPTEN_KEEPALIVE const char* coif_view_motion() {
  return page().session ? say(page().session->motion().json()) : say("{}");
}

/// Replaces the asset's own resistances (`which` 0) or damping ratios (1) by `points` points, place and value in turn;
/// 0 points: its own.
EMSCRIPTEN_KEEPALIVE void coif_view_curve(int which, const double* numbers, int points) {
  if (!page().session) return;
  std::vector<coif::cook::CurvePoint> curve;
  for (int i = 0; i < points; ++i) curve.push_back({numbers[2 * i], numbers[2 * i + 1]});
  coif::view::TunableMotion& motion = page().session->motion();
  which == 0 ? motion.set_resistance(std::move(curve)) : motion.set_damping_ratio(std::move(curve));
}

/// The present settings are those of the asset's cook. `recipe_says_it`: its recipe contains them.
EMSCRIPTEN_KEEPALIVE void coif_view_accept(bool recipe_says_it) {
  if (page().session) page().session->motion().accept(page().session->settings(), recipe_says_it);
}

/// The changes of the motion as a recipe's "dynamics".
EMSCRIPTEN_KEEPALIVE const char* coif_view_dynamics() {
  return page().session ? say(page().session->motion().recipe(page().session->settings())) : say("{}");
}

EMSCRIPTEN_KEEPALIVE float* coif_view_settings() { return page().session ? &page().session->settings().yaw : nullptr; }
EMSCRIPTEN_KEEPALIVE std::uint32_t coif_view_setting_count() { return coif::view::kViewSettings; }

EMSCRIPTEN_KEEPALIVE const float* coif_view_numbers() {
  return page().session ? &page().session->numbers().step_ns_of_bone : nullptr;
}

EMSCRIPTEN_KEEPALIVE const char* coif_view_frame(std::uint32_t width, std::uint32_t height, double seconds) {
  page().has_drawn = false;
  if (!page().session) return nullptr;
  const auto drawn = page().session->frame(width, height, seconds);
  if (!drawn) return say(drawn.error().message);
  page().has_drawn = *drawn;
  return nullptr;
}
EMSCRIPTEN_KEEPALIVE bool coif_view_has_drawn() { return page().has_drawn; }

EMSCRIPTEN_KEEPALIVE const char* coif_view_restart() {
  return page().session ? outcome(page().session->restart()) : nullptr;
}

EMSCRIPTEN_KEEPALIVE bool coif_view_grab(double x, double y) { return page().session && page().session->grab(x, y); }
EMSCRIPTEN_KEEPALIVE void coif_view_drag(double across, double down) {
  if (page().session) page().session->drag(across, down);
}
EMSCRIPTEN_KEEPALIVE void coif_view_turn(double across, double down) {
  if (page().session) page().session->turn(across, down);
}
EMSCRIPTEN_KEEPALIVE void coif_view_release() {
  if (page().session) page().session->release();
}
}
