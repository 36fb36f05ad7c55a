#include "view/page/view_session.h"

#include "base/asset_refusal.h"
#include "base/geometry.h"
#include "view/page/crowd_cost.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace coif {
namespace {

constexpr double kLongestFrame = 0.25;  // Seconds that are caught up with: a page in the background stands still.
constexpr std::size_t kFileAlignment = 64;

tl::unexpected<ToolError> not_simulated(Status why) {
  return failure(ToolError::Kind::kBadInput, std::string("the hair cannot be simulated: ") + describe(why));
}

bool is_same(const ViewSettings& a, const ViewSettings& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

tl::expected<std::unique_ptr<ViewSession>, ToolError> ViewSession::open(std::vector<std::byte> bytes) {
  std::unique_ptr<ViewSession> session(new ViewSession);
  session->memory_ = allocate({bytes.size(), kFileAlignment});
  if (!session->memory_) return failure(ToolError::Kind::kBadInput, "out of memory");
  std::copy(bytes.begin(), bytes.end(), session->memory_.get());
  const LoadStatus status = open_whole({session->memory_.get(), bytes.size()}, session->asset_);
  if (!status) return tl::unexpected(refusal_of(status));
  if (auto drawable = check_drawable(session->asset_); !drawable) return tl::unexpected(drawable.error());
  const AssetMotion motion(session->asset_);
  session->settings_ = settings_of(session->asset_, motion);
  session->motion_ = TunableMotion(motion, session->settings_);
  session->numbers_.asset_bytes = float(bytes.size());
  session->numbers_.levels = float(session->asset_.lod_count());
  if (auto chosen = session->choose_heads(); !chosen) return tl::unexpected(chosen.error());
  return session;
}

tl::expected<void, ToolError> ViewSession::start_drawing() {
  scene_.reset();
  shown_.samples = -1;  // of nothing: the next frame is drawn
  auto scene = ViewScene::create(asset_);
  if (!scene) return tl::unexpected(scene.error());
  scene_ = std::move(*scene);
  return {};
}

Vec3 ViewSession::wind() const {
  const double from = double(settings_.wind_from) * kDegree + yaw_of_face(asset_) * kDegree;
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
  step.environment.wind = wind();
  return step;
}

/// Heads of the solvers that are asked for, settled where the old ones were.
tl::expected<void, ToolError> ViewSession::choose_heads() {
  std::vector<float> worn{settings_.gusts > 0 ? 1.0f : 0.0f, settings_.solver};
  if (settings_.beside > 0) worn.push_back(settings_.beside - 1);
  if (worn == worn_) return {};
  heads_.clear();
  for (std::size_t i = 1; i < worn.size(); ++i) {
    auto head = std::make_unique<SimulatedHead>();
    Status status = head->create(asset_, solver_of(worn[i]), worn[0] != 0);
    if (status == Status::kOk) status = head->settle(pose_, step_settings());
    if (status != Status::kOk) return not_simulated(status);
    heads_.push_back(std::move(head));
  }
  numbers_.bones = float(asset_.skeleton().simulated_count);
  if (timed_ != settings_.solver) numbers_.step_ns_of_bone = float(crowd_cost(asset_, solver_of(settings_.solver)));
  timed_ = settings_.solver;
  worn_ = std::move(worn);
  shown_.samples = -1;
  return {};
}

void ViewSession::choose_motion() {
  if (path_ && moved_by_ == settings_.motion) return;
  const auto motions = all_motions();
  const auto number = std::min(std::size_t(std::max(settings_.motion, 0.0f)), motions.size() - 1);
  path_ = path_of(motions[number].motion);
  if (yaw_of_face(asset_) != 0) path_ = turned_round(std::move(path_));
  moved_by_ = settings_.motion;
  time_ = 0;
}

tl::expected<void, ToolError> ViewSession::restart() {
  choose_motion();
  time_ = left_over_ = 0;
  held_ = HeldHead();
  pose_ = settings_.plays != 0 ? path_->pose(0) : HeadPose{};
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
    if (settings_.plays != 0) time_ += dt;
    held_.step(dt);
    pose_ = held_.moved(settings_.plays != 0 || time_ > 0 ? path_->pose(time_) : HeadPose{});
    for (const auto& head : heads_) {
      if (const Status status = head->step(pose_, step, gusts()); status != Status::kOk) return not_simulated(status);
    }
  }
  return {};
}

bool ViewSession::is_moving() const {
  const bool plays = settings_.plays != 0 && settings_.motion != float(Motion::kStill);
  if (plays || held_.is_held() || !held_.is_at_rest()) return true;
  return std::any_of(heads_.begin(), heads_.end(), [](const auto& head) { return !head->is_asleep(); });
}

tl::expected<bool, ToolError> ViewSession::frame(std::uint32_t width, std::uint32_t height, double seconds) {
  if (!scene_) return failure(ToolError::Kind::kInternal, "nothing to draw with");
  choose_motion();
  if (motion_.apply(settings_, asset_)) worn_.clear();
  if (auto chosen = choose_heads(); !chosen) return tl::unexpected(chosen.error());
  const auto level = std::min(std::uint32_t(std::max(settings_.lod, 0.0f)), asset_.lod_count() - 1);
  for (const auto& head : heads_) {
    if (const Status status = head->set_level(level); status != Status::kOk) return not_simulated(status);
  }
  if (auto stepped = step(seconds); !stepped) return tl::unexpected(stepped.error());
  numbers_.asleep = is_moving() ? 0 : 1;
  numbers_.time = float(time_);
  numbers_.substeps = float(tuned_substeps(asset_, step_settings().dt));
  numbers_.triangles = float(asset_.lod_indices(level).size() / 3);
  const bool is_new = !is_same(settings_, shown_) || width != width_ || height != height_;
  if (!is_new && !is_moving()) return false;

  const CrowdView& view = scene_->view(settings_, double(width) / height, std::uint32_t(heads_.size()));
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

}  // namespace coif
