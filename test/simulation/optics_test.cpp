// Rays, light, projection and exposure against their formulas.
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "simulation/camera.h"
#include "simulation/lighting.h"
#include "simulation/omni_renderer.h"
#include "simulation/random.h"
#include "simulation/ray_tracer.h"
#include "simulation/renderer.h"

namespace place_recognition::simulation {
namespace {

int addPlain(Scene& scene, uchar grey, const Vec3& emission) {
  Material material;
  material.texture = std::make_shared<Texture>(cv::Mat(4, 4, CV_8UC3, cv::Scalar::all(grey)));
  material.emission = emission;
  return scene.add(material);
}

const Daylight kDark{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 1}};

TEST(Texture, GivesLinearColoursAndTheirAverage) {
  cv::Mat halves(64, 64, CV_8UC3, cv::Scalar::all(0));
  halves.colRange(0, 32).setTo(cv::Scalar(255, 255, 255));
  const Texture texture(halves);
  EXPECT_NEAR(texture.average()[1], 0.5f, 1e-3f);
  EXPECT_NEAR(texture.sample(0.25f, 0.5f, 0.0f, 0.0f)[1], 1.0f, 1e-3f);
  EXPECT_NEAR(texture.sample(0.75f, 0.5f, 0.0f, 0.0f)[1], 0.0f, 1e-3f);
  EXPECT_NEAR(texture.sample(0.3f, 0.5f, 4.0f, 4.0f)[1], 0.5f, 1e-2f);
  // sRGB 128 is 0.2159 linear.
  EXPECT_NEAR(Texture(cv::Mat(8, 8, CV_8UC3, cv::Scalar::all(128))).average()[0], 0.2159f, 1e-3f);
}

TEST(RayTracer, FindsWhatATestOfEveryFacetFinds) {
  Scene scene;
  const int grey = addPlain(scene, 128, {});
  Random random(3);
  const auto point = [&] {
    return Vec3(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5));
  };
  for (int i = 0; i < 300; ++i) {
    const Vec3 at = point(), u = 0.2f * point(), v = 0.2f * point();
    scene.polygon({at, at + u, at + u + v, at + v}, grey);
  }
  const RayTracer tracer(scene);
  int hits = 0;
  for (int ray = 0; ray < 500; ++ray) {
    const Vec3 origin = point(), direction = point();
    float nearest = 100.0f;
    int facet = -1;
    for (std::size_t i = 0; i < scene.facets.size(); ++i) {
      // Solve corner + s u + t v = origin + distance * direction by Cramer's rule.
      const auto& c = scene.facets[i].corners;
      const cv::Vec3d u = c[1] - c[0], v = c[3] - c[0], d = direction, o = origin - c[0];
      const double det = u.cross(v).dot(d);
      const double s = o.cross(v).dot(d) / det, t = u.cross(o).dot(d) / det;
      const double distance = -u.cross(v).dot(o) / det;
      if (s >= 0 && s <= 1 && t >= 0 && t <= 1 && distance > 0 && distance < nearest) {
        nearest = static_cast<float>(distance);
        facet = static_cast<int>(i);
      }
    }
    const Hit hit = tracer.nearest(origin, direction, 100.0f);
    ASSERT_EQ(hit.facet, facet) << "ray " << ray;
    EXPECT_EQ(tracer.blocked(origin, direction, 100.0f), facet >= 0);
    if (facet < 0) continue;
    EXPECT_NEAR(hit.distance, nearest, 1e-3f * nearest + 1e-4f);
    ++hits;
  }
  EXPECT_GT(hits, 100);
}

TEST(Lighting, OfASmallLampFallsWithTheSquareOfTheDistance) {
  Scene scene;
  const int black = addPlain(scene, 0, {});
  scene.polygon({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, black);
  scene.lamps.push_back({{0, 0, 2}, {0.05f, 0, 0}, {0, 0.05f, 0}, {0, 0, -1}, {100, 100, 100}});
  const RayTracer tracer(scene);
  const Lighting lighting(scene, tracer, kDark, 0.05f, 1);
  for (const float x : {0.0f, 0.8f, 1.6f}) {
    const float squared = 4.0f + x * x;
    const float cosine = 2.0f / std::sqrt(squared);
    const float expected = 100.0f * 0.01f * cosine * cosine / squared;
    EXPECT_NEAR(lighting.irradiance(0, 2.0f + x, 2.0f)[1], expected, 0.03f * expected);
  }
}

TEST(Lighting, OfTheSunCastsAShadow) {
  Scene scene;
  const int grey = addPlain(scene, 0, {});
  scene.polygon({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, grey);
  scene.polygon({{0, -2, 1}, {2, -2, 1}, {2, 2, 1}, {0, 2, 1}}, grey);  // a roof over x > 0
  Daylight noon = kDark;
  noon.sun = {200, 200, 200};
  noon.to_sun = cv::normalize(Vec3(0.0f, 1.0f, 2.0f));
  const RayTracer tracer(scene);
  const Lighting lighting(scene, tracer, noon, 0.1f, 1);
  EXPECT_NEAR(lighting.irradiance(0, 1.0f, 2.0f)[1], 200.0f * 2.0f / std::sqrt(5.0f), 0.5f);
  EXPECT_NEAR(lighting.irradiance(0, 3.0f, 2.0f)[1], 0.0f, 1e-6f);
}

TEST(Renderer, ShowsAWallWhereThePinholeModelSays) {
  // A luminous square 1 m wide, 3 m ahead of a camera that looks along y.
  Scene scene;
  const int lamp = addPlain(scene, 255, {1, 1, 1});
  scene.picture({5.0f, 10.0f, 0.5f, 0.0f}, 1.0f, 1.0f, lamp);
  const RayTracer tracer(scene);
  const Lighting lighting(scene, tracer, kDark, 0.5f, 1);
  const cv::Size size(200, 150);
  const Renderer renderer(scene, tracer, lighting, size, focalLength(size.width));
  const cv::Mat radiance = renderer.render({{5.2f, 7.0f, 0.76f}, static_cast<float>(CV_PI) / 2, 0});

  const double focal = focalLength(size.width);
  EXPECT_NEAR(2.0 * std::atan(100.0 / focal) * 180.0 / CV_PI, 58.0, 0.5);
  const double left = 100.0 + focal * (4.5 - 5.2) / 3.0, right = 100.0 + focal * (5.5 - 5.2) / 3.0;
  const double top = 75.0 - focal * (1.5 - 0.76) / 3.0, bottom = 75.0 - focal * (0.5 - 0.76) / 3.0;
  // The square's width and height in pixels, from a row and a column through it, and its middle.
  EXPECT_NEAR(cv::sum(radiance.row(70))[1], right - left, 0.5);
  EXPECT_NEAR(cv::sum(radiance.col(90))[1], bottom - top, 0.5);
  std::vector<cv::Mat> channels;
  cv::split(radiance, channels);
  const cv::Moments moments = cv::moments(channels[1]);
  EXPECT_NEAR(moments.m10 / moments.m00 + 0.5, (left + right) / 2.0, 0.25);
  EXPECT_NEAR(moments.m01 / moments.m00 + 0.5, (top + bottom) / 2.0, 0.25);
}

TEST(OmniRenderer, ShowsALampWhereTheSphereModelSays) {
  const cv::Size size(320, 240);
  const MirrorRing ring = mirrorRing(size);
  const auto radius = [](double angle) { return std::sin(angle) / (0.95 + std::cos(angle)); };
  const double scale = ring.outer / radius(115 * CV_PI / 180);
  EXPECT_NEAR(ring.inner, scale * radius(CV_PI / 4), 0.1);
  const Vec3 eye(5.2f, 7.0f, 0.76f);
  for (const float yaw : {0.0f, 0.7f, 2.0f, -1.4f, 3.1f}) {
    for (const float turn : {0.0f, 0.78f, 1.9f, -2.4f}) {  // of the lamp, from ahead to the left
      // A small luminous square 3 m away, facing the camera, its middle a little above it.
      Scene scene;
      const int lamp = addPlain(scene, 255, {1, 1, 1});
      const float way = yaw + turn;
      const Vec3 middle = eye + 3.0f * Vec3(std::cos(way), std::sin(way), 0.08f);
      const Vec3 across(-0.1f * std::sin(way), 0.1f * std::cos(way), 0.0f), up(0.0f, 0.0f, 0.1f);
      scene
          .polygon({middle + across - up, middle - across - up, middle - across + up,
                    middle + across + up},
                   lamp)
          .two_sided = true;
      const RayTracer tracer(scene);
      const Lighting lighting(scene, tracer, kDark, 0.5f, 1);
      std::vector<cv::Mat> channels;
      cv::split(OmniRenderer(scene, tracer, lighting, size).render({eye, yaw, 0}), channels);
      cv::Mat lit;  // without the camera and the area beside the mirror
      cv::threshold(channels[1], lit, 0.05, 0, cv::THRESH_TOZERO);
      const cv::Moments moments = cv::moments(lit);
      ASSERT_GT(moments.m00, 0);
      const double angle = CV_PI / 2 + std::atan(0.08);  // from straight down
      const double distance = scale * radius(angle);
      EXPECT_NEAR(moments.m10 / moments.m00 + 0.5, ring.center.x + distance * std::sin(turn), 0.3);
      EXPECT_NEAR(moments.m01 / moments.m00 + 0.5, ring.center.y - distance * std::cos(turn), 0.3);
    }
  }
}

TEST(Develop, ExposesADimSceneAsABrightOne) {
  cv::Mat ramp(60, 80, CV_32FC3);
  for (int y = 0; y < ramp.rows; ++y) {
    for (int x = 0; x < ramp.cols; ++x) {
      ramp.at<Vec3>(y, x) = Vec3::all(5.0f + 0.2f * static_cast<float>(x));
    }
  }
  const double bright = cv::mean(develop(ramp, Random(1)))[1];
  const double dim = cv::mean(develop(0.1 * ramp, Random(1)))[1];
  EXPECT_NEAR(bright, dim, 2.0);
  EXPECT_GT(bright, 80.0);
  EXPECT_LT(bright, 160.0);
}

TEST(Develop, AWindowDarkensTheRest) {
  cv::Mat wall(60, 80, CV_32FC3, cv::Scalar::all(2.0));
  const double alone = cv::mean(develop(wall, Random(1)).colRange(60, 80))[1];
  wall.colRange(0, 40).setTo(cv::Scalar::all(40.0));
  const double beside = cv::mean(develop(wall, Random(1)).colRange(60, 80))[1];
  EXPECT_LT(beside, 0.7 * alone);
}

TEST(Develop, NoiseHasNoMeanAndGrowsInTheDark) {
  const cv::Mat grey(120, 160, CV_32FC3, cv::Scalar::all(3.0));
  const auto deviation = [](const cv::Mat& picture) {
    cv::Scalar mean, deviation;
    cv::meanStdDev(picture(cv::Rect(70, 50, 20, 20)), mean, deviation);
    return deviation[1];
  };
  EXPECT_GT(deviation(develop(grey, Random(1))), 0.3);
  EXPECT_LT(deviation(develop(grey, Random(1))), 5.0);
  EXPECT_GT(deviation(develop(0.01 * grey, Random(1))), 1.3 * deviation(develop(grey, Random(1))));
}

}  // namespace
}  // namespace place_recognition::simulation
