#include "simulation/path.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "simulation/building.h"

namespace place_recognition::simulation {
namespace {

constexpr float kPi = 3.14159265f;
constexpr float kSpacing = 1.0f;         ///< m, between markers
constexpr float kFromWall = 0.75f;       ///< m
constexpr float kFromFurniture = 0.35f;  ///< m
constexpr int kAngles = 12;

constexpr float kSpeed = 0.5f;     ///< m/s
constexpr float kTurnRate = 0.7f;  ///< rad/s, maximum
constexpr float kStep = 0.02f;     ///< m

template <typename... Numbers>
std::string numbered(const char* format, Numbers... numbers) {
  char text[64];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

using Points = std::vector<cv::Point2f>;

/// Points on the robot's path; in rooms it turns round, as in corridors.
const Points kWaypoints = {
    {1.2f, 1.1f},  {2.6f, 1.1f},  {3.3f, 1.6f},  {3.3f, 2.6f},  {3.2f, 3.6f},   {2.9f, 4.6f},
    {2.5f, 5.5f},  {2.0f, 5.8f},  {1.7f, 5.2f},  {1.8f, 4.2f},  {2.3f, 3.5f},   {3.1f, 3.0f},
    {3.3f, 2.3f},  {3.5f, 1.5f},  {4.5f, 1.1f},  {5.8f, 1.1f},  {6.9f, 1.5f},   {7.05f, 2.3f},
    {7.1f, 3.2f},  {6.9f, 4.2f},  {6.4f, 5.2f},  {6.8f, 6.0f},  {7.6f, 5.9f},   {8.0f, 5.0f},
    {7.7f, 4.0f},  {7.2f, 3.2f},  {7.05f, 2.3f}, {7.3f, 1.5f},  {8.4f, 1.0f},   {10.0f, 1.0f},
    {12.0f, 1.1f}, {13.4f, 0.9f}, {14.8f, 0.7f}, {15.2f, 0.0f}, {14.6f, -0.8f}, {13.5f, -0.8f},
    {13.0f, 0.1f}, {12.5f, 0.9f}, {11.0f, 1.2f}, {9.0f, 1.2f},  {7.0f, 1.1f},   {5.0f, 1.1f},
    {4.0f, 0.8f},  {3.8f, 0.0f},  {3.9f, -0.9f}, {4.0f, -2.0f}, {3.8f, -3.2f},  {3.0f, -3.7f},
    {1.8f, -3.7f}, {2.6f, -3.6f}, {3.6f, -3.0f}, {3.9f, -1.8f}, {3.8f, -0.8f},  {3.7f, 0.0f},
    {3.4f, 0.8f},  {2.4f, 1.1f},  {1.2f, 1.1f},
};

/// Uniform cubic B-spline: passes near the waypoints, not through them, with smooth curvature.
cv::Point2f spline(const cv::Point2f* p, float t) {
  const float s = 1.0f - t;
  return (s * s * s * p[0] + (3.0f * t * t * t - 6.0f * t * t + 4.0f) * p[1] +
          (3.0f * s * s * s - 6.0f * s * s + 4.0f) * p[2] + t * t * t * p[3]) /
         6.0f;
}

/// Points `step` metres apart along the path.
Points walk(const Points& waypoints, float step) {
  Points way;
  float left = 0.0f;
  cv::Point2f last = spline(waypoints.data(), 0.0f);
  way.push_back(last);
  for (std::size_t i = 0; i + 3 < waypoints.size(); ++i) {
    for (int k = 1; k <= 1000; ++k) {
      const cv::Point2f next = spline(&waypoints[i], static_cast<float>(k) / 1000.0f);
      left += std::hypot(next.x - last.x, next.y - last.y);
      last = next;
      if (left >= step) {
        way.push_back(next);
        left -= step;
      }
    }
  }
  return way;
}

Points strayed(Points waypoints, float stray, Random random) {
  for (cv::Point2f& point : waypoints) {
    point.x += random.uniform(-stray, stray);
    point.y += random.uniform(-stray, stray);
  }
  return waypoints;
}

float wrapped(float angle) { return std::remainder(angle, 2.0f * kPi); }

}  // namespace

std::vector<Marker> markers(const std::vector<Footprint>& footprints) {
  std::vector<Marker> result;
  for (const Room& room : rooms()) {
    const cv::Rect2f& f = room.floor;
    const int columns = static_cast<int>((f.width - 2.0f * kFromWall) / kSpacing) + 1;
    const int rows = static_cast<int>((f.height - 2.0f * kFromWall) / kSpacing) + 1;
    const float x0 = f.x + 0.5f * (f.width - static_cast<float>(columns - 1) * kSpacing);
    const float y0 = f.y + 0.5f * (f.height - static_cast<float>(rows - 1) * kSpacing);
    int number = 0;
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < rows; ++j) {
        const cv::Point2f at(x0 + static_cast<float>(i) * kSpacing,
                             y0 + static_cast<float>(j) * kSpacing);
        const bool free =
            std::all_of(footprints.begin(), footprints.end(), [&](const Footprint& footprint) {
              return footprint.distance(at.x, at.y) > kFromFurniture;
            });
        if (free) result.push_back({room.name, ++number, at});
      }
    }
  }
  return result;
}

std::vector<Pose> tripodRun(const std::vector<Marker>& markers, double rate, Random random) {
  std::vector<Pose> run;
  for (const Marker& marker : markers) {
    const float x = marker.at.x + 0.015f * random.normal();
    const float y = marker.at.y + 0.015f * random.normal();
    const float turn = 0.02f * random.normal();
    for (int i = 0; i < kAngles; ++i) {
      const int degrees = i * 360 / kAngles;
      Pose pose;
      pose.room = marker.room;
      pose.name = marker.room + numbered("_%02d_%03d", marker.number, degrees);
      pose.stamp = static_cast<double>(run.size()) / rate;
      pose.view.eye = {x, y, kCameraHeight};
      pose.view.yaw =
          wrapped(-static_cast<float>(degrees) * kPi / 180.0f + turn + 0.008f * random.normal());
      pose.view.pitch = 0.008f * random.normal();
      run.push_back(pose);
    }
  }
  return run;
}

std::vector<cv::Point2f> driveWay() { return walk(kWaypoints, 0.1f); }

std::vector<Pose> driveRun(double rate, float stray, Random random) {
  const Points way = walk(strayed(kWaypoints, stray, random), kStep);
  const auto heading = [&](std::size_t i) {
    return std::atan2(way[i + 1].y - way[i].y, way[i + 1].x - way[i].x);
  };
  std::vector<Pose> run;
  double time = 0.0;
  for (std::size_t i = 0; i + 2 < way.size(); ++i) {
    const float turn = wrapped(heading(i + 1) - heading(i));
    const double duration = std::max(kStep / kSpeed, std::abs(turn) / kTurnRate);
    for (double stamp; (stamp = static_cast<double>(run.size()) / rate) < time + duration;) {
      const auto fraction = static_cast<float>((stamp - time) / duration);
      const cv::Point2f at = way[i] + fraction * (way[i + 1] - way[i]);
      Pose pose;
      pose.room = roomAt(at.x, at.y).name;
      pose.name = numbered("drive_%06d", static_cast<int>(run.size()));
      pose.stamp = stamp;
      pose.view.eye = {at.x, at.y, kCameraHeight};
      pose.view.yaw = wrapped(heading(i) + fraction * turn);
      pose.view.pitch = 0.003f * random.normal();  // the floor is not perfectly even
      run.push_back(pose);
    }
    time += duration;
  }
  return run;
}

}  // namespace place_recognition::simulation
