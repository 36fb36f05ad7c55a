// Cameras that are written and read again, and linear pictures.

#include "render/camera_file.h"
#include "base/linear_picture.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace coif::render::camera_file_test {

using Eigen::Vector3d;

CameraPlace some_camera() {
  const Eigen::Matrix3d axes = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  return {{0.1, 0.2, 1.5}, axes.col(0), axes.col(1), axes.col(2), 40};
}

TEST(CameraFile, GivesBackWhatWasWritten) {
  const Vector3d joint(0, 1.5, -0.02);
  const CameraPlace camera = some_camera();
  const nlohmann::json alone = nlohmann::json::parse(camera_json(camera, joint).dump());
  for (const nlohmann::json& json : {alone, nlohmann::json{{"camera", alone}}}) {
    const auto read = camera_of_json(json, joint);
    ASSERT_TRUE(read) << read.error();
    EXPECT_TRUE(read->eye.isApprox(camera.eye, 1e-12));
    EXPECT_TRUE(read->back.isApprox(camera.back, 1e-12));
    EXPECT_EQ(read->fov_degrees, 40);
  }
  EXPECT_NEAR(alone["eye"][1].get<double>(), 1.7, 1e-12) << "the source's metres";
}

TEST(CameraFile, RefusesWhatIsNoCamera) {
  const nlohmann::json good = nlohmann::json::parse(camera_json(some_camera(), Vector3d::Zero()).dump());
  struct Damage {
    const char* key;
    nlohmann::json value;
    const char* says;
  };
  for (const Damage& damage : std::vector<Damage>{{"eye", {1, 2}, "'eye'"},
                                                  {"up", {0, 0, 0}, "right angles"},
                                                  {"right", nullptr, "'right'"},
                                                  {"fov_degrees", 0, "fov_degrees"},
                                                  {"back", {"a", 0, 0}, "'back'"}}) {
    nlohmann::json bad = good;
    bad[damage.key] = damage.value;
    const auto read = camera_of_json(bad, Vector3d::Zero());
    ASSERT_FALSE(read) << damage.key;
    EXPECT_NE(read.error().find(damage.says), std::string::npos) << read.error();
  }
}

TEST(CameraFile, KeepsLights) {
  const std::vector<Light> lights{{Light::Kind::kDirectional, {0, 3, 4}, {1, 0.5f, 0}},
                                  {Light::Kind::kDirectional, {1, 0, 0}, {0, 0, 2}}};
  const auto read = lights_of_json(nlohmann::json::parse(lights_json(lights).dump()));
  ASSERT_TRUE(read) << read.error();
  ASSERT_EQ(read->size(), 2u);
  EXPECT_FLOAT_EQ((*read)[0].from.y, 0.6f) << "unit";
  EXPECT_FLOAT_EQ((*read)[1].color.z, 2);
  EXPECT_FALSE(lights_of_json(nlohmann::json::parse(R"([{"towards": [0, 0, 0], "color": [1, 1, 1]}])")));
}

TEST(CameraFile, ShowsWhatStandsBeforeIt) {
  const CameraPlace camera{{0, 0, 2}, Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ(), 90};
  const std::vector<Vector3d> points{{0, 0, 0}, {0.5, 0, 0.5}};
  const CrowdView view = view_from(camera, 1, points);
  const auto place = [&](const Vector3d& point) {
    const Eigen::Vector4f clip = view.camera.clip_from_world * point.cast<float>().homogeneous();
    return Eigen::Vector3f(clip.head<3>() / clip.w());
  };
  EXPECT_NEAR(place({1, 0, 1}).x(), 1, 1e-5) << "90 degrees";
  for (const Vector3d& point : points) EXPECT_LT(std::abs(place(point).z()), 1) << "between the clipping planes";
}

TEST(LinearPicture, ComesBackFromAnExr) {
  LinearPicture picture{3, 2, {}};
  for (int i = 0; i < 24; ++i) picture.rgba.push_back(0.25f * float(i));
  const auto bytes = encode_exr(picture);
  ASSERT_TRUE(bytes) << bytes.error();
  const auto read = decode_exr(*bytes);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->width, 3u);
  EXPECT_EQ(read->rgba, picture.rgba) << "numbers that 16 bits have";
}

TEST(LinearPicture, RefusesWhatIsNoExr) {
  for (const std::size_t size : {0u, 3u, 200u}) EXPECT_FALSE(decode_exr(std::vector<std::byte>(size))) << size;
  auto bytes = *encode_exr({4, 4, std::vector<float>(64)});
  bytes.resize(bytes.size() / 2);
  EXPECT_FALSE(decode_exr(bytes));
}

}  // namespace coif::render::camera_file_test
