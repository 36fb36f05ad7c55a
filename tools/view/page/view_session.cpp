#include "view/page/view_session.h"

#include "base/asset_refusal.h"
#include "base/geometry.h"
#include "view/page/motion_figures.h"
#include "view/page/tunable_motion.h"
#include "view/page/view_settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace coif::view {
namespace {

constexpr double kLongestFrame = 0.25;  // Seconds that are caught up with: a page in the background stands still.
constexpr std::size_t kFileAlignment = 64;

tl::unexpected<ToolError> not_simulated(Status why) {
  return failure(ToolError::Kind::kBadInput, std::string("the hair cannot be simulated: ") + describe(why));
}

bool is_same(const ViewSettings& a, const ViewSettings& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

tl::expected<LoadedAsset, ToolError> LoadedAsset::load(std::span<const std::byte> bytes) {
  LoadedAsset loaded;
  loaded.memory = allocate({bytes.size(), kFileAlignment});
  if (!loaded.memory) return failure(ToolError::Kind::kBadInput, "out of memory");
  std::copy(bytes.begin(), bytes.end(), loaded.memory.get());
  loaded.bytes = bytes.size();
  const LoadStatus status = open_whole({loaded.memory.get(), loaded.bytes}, loaded.asset);
  if (!status) return tl::unexpected(refusal_of(status));
  return loaded;
}

ViewSession::ViewSession(std::shared_ptr<Shared> shared)
    : shared_(std::move(shared)),
      asset_(shared_->loaded.asset),
      scene_(shared_->scene),
      settings_(with_motion(settings_of(asset_), shared_->motion)),
      motion_(shared_->motion, settings_) {}

tl::expected<std::unique_ptr<ViewSession>, ToolError> ViewSession::open(std::vector<std::byte> bytes) {
  auto loaded = LoadedAsset::load(bytes);
  if (!loaded) return tl::unexpected(loaded.error());
  if (auto drawable = render::check_drawable(loaded->asset); !drawable) return tl::unexpected(drawable.error());
  auto shared = std::make_shared<Shared>();
  shared->loaded = std::move(*loaded);
  shared->motion = AssetMotion(shared->loaded.asset);
  std::unique_ptr<ViewSession> session(new ViewSession(std::move(shared)));
  session->numbers_.asset_bytes = float(bytes.size());
  session->numbers_.levels = float(session->asset_.lod_count());
  if (auto chosen = session->choose_heads(); !chosen) return tl::unexpected(chosen.error());
  return session;
}

tl::expected<void, ToolError> ViewSession::tune() {
  if (motion_.is_applied(settings_)) return {};
  if (!tuned_) {
    auto copy = LoadedAsset::load({shared_->loaded.memory.get(), shared_->loaded.bytes});
    if (!copy) return tl::unexpected(copy.error());
    tuned_ = std::move(*copy);
  }
  motion_.apply(settings_, tuned_->asset);
  worn_.clear();  // heads are made anew
  return {};
}

std::unique_ptr<ViewSession> ViewSession::another() const {
  std::unique_ptr<ViewSession> session(new ViewSession(shared_));
  session->numbers_ = numbers_;
  session->measures_cost_ = false;
  session->clip_ = clip_;
  return session;
}

tl::expected<void, ToolError> ViewSession::seek(double seconds) {
  if (auto begun = restart(); !begun) return begun;
  double rest = seconds + 0.5 * double(step_settings().dt);
  for (; rest > 0; rest -= kLongestFrame) {
    if (auto stepped = step(std::min(rest, kLongestFrame)); !stepped) return stepped;
  }
  left_over_ = 0;
  return {};
}

tl::expected<void, ToolError> ViewSession::start_drawing() {
  scene_.reset();
  shown_.samples = -1;  // Invalid, so that the next frame is drawn.
  auto scene = ViewScene::create(asset_, shared_->body);
  if (!scene) return tl::unexpected(scene.error());
  scene_ = std::move(*scene);
  return {};
}

Vec3 ViewSession::wind() const {
  const double from = double(settings_.wind_from) * kDegree + render::yaw_of_face(asset_) * kDegree;
  const auto speed = double(settings_.wind);
  return {float(-speed * std::sin(from)), 0, float(-speed * std::cos(from))};
}

Gusts ViewSession::gusts() const {
  Gusts gusts;
  gusts.amplitude = settings_.gusts;
  if (settings_.wind > 0) {
    gusts.direction = wind();
    gusts.speed = std::min(settings_.wind, kMostGust);
  }
  return gusts;
}

StepSettings ViewSession::step_settings() const {
  StepSettings step;
  step.dt = 1 / std::clamp(settings_.rate, 10.0f, 1000.0f);
  step.iterations = std::uint32_t(std::clamp(settings_.iterations, 1.0f, float(kMaxIterations)));
  step.environment.wind = wind();
  return step;
}

/// Makes the heads of the chosen solvers, settled at the old ones' places.
tl::expected<void, ToolError> ViewSession::choose_heads() {
  std::vector<float> worn{settings_.gusts > 0 ? 1.0f : 0.0f, settings_.solver};
  if (settings_.beside > 0) worn.push_back(settings_.beside - 1);
  if (worn == worn_) return {};
  heads_.clear();
  for (std::size_t i = 1; i < worn.size(); ++i) {
    auto head = std::make_unique<SimulatedHead>();
    Status status = head->create(simulated_asset(), solver_of(worn[i]), worn[0] != 0);
    if (status == Status::kOk) status = head->settle(pose_, step_settings());
    if (status != Status::kOk) return not_simulated(status);
    heads_.push_back(std::move(head));
  }
  numbers_.bones = float(asset_.skeleton().simulated_count);
  const bool is_timed = !measures_cost_ || timed_ == settings_.solver;
  if (!is_timed) numbers_.step_ns_of_bone = float(crowd_cost(asset_, solver_of(settings_.solver)));
  timed_ = settings_.solver;
  worn_ = std::move(worn);
  shown_.samples = -1;
  return {};
}

void ViewSession::choose_motion() {
  if (path_ && moved_by_ == settings_.motion) return;
  is_put_ = length_ > 0;
  length_ = 0;
  if (is_clip(settings_.motion) && !clip_.empty()) {
    path_ = motion::path_of(clip_);
    length_ = clip_.back().seconds;
    is_put_ = true;
  } else {
    path_ = chosen_path(settings_.motion);
    if (render::yaw_of_face(asset_) != 0) path_ = motion::turned_round(std::move(path_));
  }
  moved_by_ = settings_.motion;
  time_ = 0;
}

double ViewSession::time_in_motion() const { return length_ > 0 ? std::fmod(time_, length_) : time_; }

HeadPose ViewSession::pose_in_motion() const {
  const bool has_begun = settings_.plays != 0 || time_ > 0 || length_ > 0;
  return has_begun ? path_->pose(time_in_motion()) : HeadPose{};
}

tl::expected<void, ToolError> ViewSession::restart() {
  choose_motion();
  time_ = left_over_ = 0;
  held_ = HeldHead();
  pose_ = pose_in_motion();
  worn_.clear();
  return choose_heads();
}

tl::expected<void, ToolError> ViewSession::go_on(const ViewSession& before) {
  settings_ = before.settings_;
  choose_motion();
  time_ = before.time_;
  left_over_ = before.left_over_;
  held_ = before.held_;
  pose_ = before.pose_;
  motion_.go_on(before.motion_);
  worn_.clear();
  return choose_heads();
}

tl::expected<void, ToolError> ViewSession::step(double seconds) {
  const StepSettings step = step_settings();
  const auto dt = double(step.dt);
  left_over_ += std::clamp(seconds, 0.0, kLongestFrame);
  while (left_over_ >= dt) {
    left_over_ -= dt;
    const double before = time_in_motion();
    if (settings_.plays != 0) time_ += dt;
    held_.step(dt);
    pose_ = held_.moved(pose_in_motion());
    // From a clip's end to its beginning the head does not move: its hair is carried along instead of being thrown.
    const bool is_put = std::exchange(is_put_, false) || time_in_motion() < before;
    const auto way = is_put ? SimulatedHead::Way::kNone : SimulatedHead::Way::kMoves;
    for (const auto& head : heads_) {
      const Status status = head->step(pose_, way, step, gusts());
      if (status != Status::kOk) return not_simulated(status);
    }
  }
  return {};
}

bool ViewSession::is_moving() const {
  const bool plays = settings_.plays != 0 && settings_.motion != float(motion::Motion::kStill);
  if (plays || held_.is_held() || !held_.is_at_rest()) return true;
  return std::any_of(heads_.begin(), heads_.end(), [](const auto& head) { return !head->is_asleep(); });
}

void ViewSession::tell_numbers(std::uint32_t level) {
  const StepSettings step = step_settings();
  const std::uint32_t substeps = tuned_substeps(asset_, step.dt);
  const RecordedTipError tips =
      tip_error_of(asset_, {1 / step.dt, substeps, &solver_of(settings_.solver), motion_.is_tuned()});
  numbers_.asleep = is_moving() ? 0 : 1;
  numbers_.time = float(time_in_motion());
  numbers_.substeps = float(substeps);
  numbers_.triangles = float(asset_.lod_indices(level).size() / 3);
  numbers_.tip_error_source = float(tips.source);
  numbers_.tip_rms = tips.rms;
  numbers_.tip_max = tips.max;
  for (int k = 0; k < 3; ++k) numbers_.head_position[k] = float(pose_.position[k]);
  const Quat& q = pose_.rotation;
  numbers_.head_rotation[0] = q.x;
  numbers_.head_rotation[1] = q.y;
  numbers_.head_rotation[2] = q.z;
  numbers_.head_rotation[3] = q.w;
}

tl::expected<bool, ToolError> ViewSession::frame(std::uint32_t width, std::uint32_t height, double seconds) {
  if (!scene_) return failure(ToolError::Kind::kInternal, "nothing to draw with");
  choose_motion();
  if (auto tuned = tune(); !tuned) return tl::unexpected(tuned.error());
  if (auto chosen = choose_heads(); !chosen) return tl::unexpected(chosen.error());
  const auto level = std::min(std::uint32_t(std::max(settings_.lod, 0.0f)), asset_.lod_count() - 1);
  for (const auto& head : heads_) {
    if (const Status status = head->set_level(level); status != Status::kOk) return not_simulated(status);
  }
  if (auto stepped = step(seconds); !stepped) return tl::unexpected(stepped.error());
  tell_numbers(level);
  const bool is_new = !is_same(settings_, shown_) || width != width_ || height != height_;
  if (!is_new && !is_moving()) return false;

  const render::CrowdView& view = scene_->view(settings_, double(width) / height, std::uint32_t(heads_.size()));
  std::vector<HairInstance> drawn;
  for (std::size_t i = 0; i < heads_.size(); ++i) {
    HairInstance& head = drawn.emplace_back(HairInstance{pose_, heads_[i]->palette(), level});
    const Eigen::Vector3d place = view.places[i] + held_.offset();
    std::copy_n(place.data(), 3, head.head.position);
  }
  if (auto done = scene_->draw(settings_, view, drawn, width, height); !done) return tl::unexpected(done.error());
  shown_ = settings_;
  width_ = width;
  height_ = height;
  numbers_.drawn += 1;
  return true;
}

}  // namespace coif::view
