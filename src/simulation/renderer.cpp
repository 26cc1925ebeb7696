#include "simulation/renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace place_recognition::simulation {
namespace {

constexpr float kPi = 3.14159265f;
constexpr float kNear = 0.02f;      ///< m
constexpr float kFarthest = 80.0f;  ///< m, for mirrored rays

/// A linear function of the sample position.
struct Form {
  float constant = 0.0f, along_x = 0.0f, along_y = 0.0f;
  float at(float x, float y) const { return constant + along_x * x + along_y * y; }
};

/// A facet as seen by the camera. inverse(x, y) is the inverse of the distance to its plane along
/// the ray of a sample, and a(x, y) / inverse(x, y) and b(x, y) / inverse(x, y) are the coordinates
/// on it where the ray arrives.
struct Projected {
  Form inverse, a, b;
};

}  // namespace

struct Renderer::Frame {
  Vec3 eye, right, down, forward;
  std::vector<Projected> facets;
  cv::Mat_<float> depth, glass_depth;  ///< inverse distance; 0: nothing
  cv::Mat_<int> facet, glass;          ///< -1: none

  Vec3 ray(float x, float y, cv::Size samples, float focal) const {
    return focal * forward + (x - 0.5f * static_cast<float>(samples.width)) * right +
           (y - 0.5f * static_cast<float>(samples.height)) * down;
  }
};

Renderer::Renderer(const Scene& scene, const RayTracer& tracer, const Lighting& lighting,
                   cv::Size size, float focal)
    : scene_(scene),
      tracer_(tracer),
      lighting_(lighting),
      samples_(2 * size.width, 2 * size.height),
      focal_(2.0f * focal) {}

cv::Mat Renderer::render(const View& view) const {
  Frame frame;
  const float c = std::cos(view.yaw), s = std::sin(view.yaw);
  const float up = std::sin(view.pitch), level = std::cos(view.pitch);
  frame.eye = view.eye;
  frame.forward = {level * c, level * s, up};
  frame.right = {s, -c, 0.0f};
  frame.down = frame.forward.cross(frame.right);
  frame.facets.resize(scene_.facets.size());
  frame.depth = cv::Mat_<float>::zeros(samples_);
  frame.glass_depth = cv::Mat_<float>::zeros(samples_);
  frame.facet = cv::Mat_<int>(samples_, -1);
  frame.glass = cv::Mat_<int>(samples_, -1);
  for (std::size_t i = 0; i < scene_.facets.size(); ++i) project(frame, static_cast<int>(i));

  cv::Mat radiance(samples_ / 2, CV_32FC3);
  for (int y = 0; y < radiance.rows; ++y) {
    for (int x = 0; x < radiance.cols; ++x) radiance.at<Vec3>(y, x) = pixel(frame, x, y);
  }
  return radiance;
}

void Renderer::project(Frame& frame, int index) const {
  const Facet& facet = scene_.facets[static_cast<std::size_t>(index)];
  const Vec3 offset = facet.origin - frame.eye;
  const float height = facet.normal.dot(offset);  // negative: seen from the front
  if (std::abs(height) < 1e-5f || (height > 0.0f && !facet.two_sided)) return;

  // Clip at the near plane, then project.
  std::vector<cv::Vec2f> outline;
  const std::size_t count = facet.corners.size();
  const auto seen = [&](const Vec3& corner) {
    const Vec3 p = corner - frame.eye;
    return Vec3(p.dot(frame.right), p.dot(frame.down), p.dot(frame.forward));
  };
  const auto put = [&](const Vec3& p) {
    outline.emplace_back(focal_ * p[0] / p[2] + 0.5f * static_cast<float>(samples_.width),
                         focal_ * p[1] / p[2] + 0.5f * static_cast<float>(samples_.height));
  };
  Vec3 last = seen(facet.corners[count - 1]);
  for (const Vec3& corner : facet.corners) {
    const Vec3 next = seen(corner);
    if ((last[2] > kNear) != (next[2] > kNear)) {
      put(last + (kNear - last[2]) / (next[2] - last[2]) * (next - last));
    }
    if (next[2] > kNear) put(next);
    last = next;
  }
  if (outline.size() < 3) return;

  Projected& projected = frame.facets[static_cast<std::size_t>(index)];
  const Vec3 corner = frame.ray(0.0f, 0.0f, samples_, focal_);
  const auto form = [&](const Vec3& axis) {
    return Form{axis.dot(corner), axis.dot(frame.right), axis.dot(frame.down)};
  };
  projected.inverse = form(facet.normal / height);
  projected.a = form(facet.u - facet.normal * (facet.u.dot(offset) / height));
  projected.b = form(facet.v - facet.normal * (facet.v.dot(offset) / height));
  scan(frame, index, outline, scene_.materials[static_cast<std::size_t>(facet.material)].glass);
}

void Renderer::scan(Frame& frame, int index, const std::vector<cv::Vec2f>& outline,
                    bool glass) const {
  float top = std::numeric_limits<float>::max(), bottom = -top;
  for (const cv::Vec2f& point : outline) {
    top = std::min(top, point[1]);
    bottom = std::max(bottom, point[1]);
  }
  const auto clipped = [](float value, int limit) {
    return static_cast<int>(std::ceil(std::clamp(value - 0.5f, 0.0f, static_cast<float>(limit))));
  };
  const Form& inverse = frame.facets[static_cast<std::size_t>(index)].inverse;
  const int last_row = clipped(bottom, samples_.height);
  for (int y = clipped(top, samples_.height); y < last_row; ++y) {
    const float middle = static_cast<float>(y) + 0.5f;
    float left = std::numeric_limits<float>::max(), right = -left;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const cv::Vec2f& p = outline[i];
      const cv::Vec2f& q = outline[i + 1 < outline.size() ? i + 1 : 0];
      if ((p[1] <= middle) == (q[1] <= middle)) continue;
      const float x = p[0] + (middle - p[1]) * (q[0] - p[0]) / (q[1] - p[1]);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    const int from = clipped(left, samples_.width), to = clipped(right, samples_.width);
    float* depth = glass ? frame.glass_depth[y] : frame.depth[y];
    int* facet = glass ? frame.glass[y] : frame.facet[y];
    const float start = inverse.at(0.5f, middle);
    for (int x = from; x < to; ++x) {
      const float here = start + inverse.along_x * static_cast<float>(x);
      const bool nearer = here > depth[x];
      depth[x] = nearer ? here : depth[x];
      facet[x] = nearer ? index : facet[x];
    }
  }
}

Vec3 Renderer::pixel(const Frame& frame, int x, int y) const {
  int facets[4], glass[4];
  bool uniform = true;
  for (int i = 0; i < 4; ++i) {
    const int u = 2 * x + (i & 1), v = 2 * y + (i >> 1);
    facets[i] = frame.facet(v, u);
    glass[i] = frame.glass_depth(v, u) > frame.depth(v, u) ? frame.glass(v, u) : -1;
    uniform = uniform && facets[i] == facets[0] && glass[i] == glass[0];
  }
  const float left = 2.0f * static_cast<float>(x), top = 2.0f * static_cast<float>(y);
  if (uniform) return sample(frame, facets[0], glass[0], left + 1.0f, top + 1.0f, 1.6f);
  Vec3 sum;
  for (int i = 0; i < 4; ++i) {
    sum += sample(frame, facets[i], glass[i], left + 0.5f + static_cast<float>(i & 1),
                  top + 0.5f + static_cast<float>(i >> 1), 1.0f);
  }
  return 0.25f * sum;
}

Vec3 Renderer::sample(const Frame& frame, int facet, int glass, float x, float y,
                      float extent) const {
  Vec3 colour = facet >= 0 ? shade(frame, facet, x, y, extent) : Vec3();
  if (glass >= 0) colour = 0.9f * colour + shade(frame, glass, x, y, extent);
  return colour;
}

Vec3 Renderer::shade(const Frame& frame, int index, float x, float y, float extent) const {
  const Facet& facet = scene_.facets[static_cast<std::size_t>(index)];
  const Material& material = scene_.materials[static_cast<std::size_t>(facet.material)];
  const Projected& projected = frame.facets[static_cast<std::size_t>(index)];
  const float distance = 1.0f / projected.inverse.at(x, y);
  const float a = projected.a.at(x, y) * distance;
  const float b = projected.b.at(x, y) * distance;

  Vec3 colour;
  if (!material.glass) {
    // The distance on the surface that corresponds to a step of one sample.
    const auto reach = [&](const Form& form, float value) {
      const float by_x = form.along_x - value * projected.inverse.along_x;
      const float by_y = form.along_y - value * projected.inverse.along_y;
      return extent * std::abs(distance) * std::max(std::abs(by_x), std::abs(by_y));
    };
    colour = surface(index, a, b, reach(projected.a, a), reach(projected.b, b));
  }
  if (material.mirror > 0.0f) {
    const Vec3 direction = cv::normalize(frame.ray(x, y, samples_, focal_));
    const float cosine = std::abs(direction.dot(facet.normal));
    // Schlick's approximation of Fresnel's law, reduced at grazing angles, because nothing is that
    // flat.
    const float fraction =
        material.mirror + 0.5f * (1.0f - material.mirror) * std::pow(1.0f - cosine, 5.0f);
    colour = (1.0f - fraction) * colour +
             fraction * mirrored(facet.at(a, b), direction, facet.normal, extent / focal_);
  }
  return colour;
}

Vec3 Renderer::surface(int index, float a, float b, float extent_a, float extent_b) const {
  const Facet& facet = scene_.facets[static_cast<std::size_t>(index)];
  const Material& material = scene_.materials[static_cast<std::size_t>(facet.material)];
  const cv::Vec2f& repeats = facet.repeats;
  const Vec3 texel =
      material.texture->sample(a * repeats[0] + facet.shift[0], b * repeats[1] + facet.shift[1],
                               extent_a * repeats[0], extent_b * repeats[1]);
  const Vec3 light = lighting_.irradiance(index, a, b) / kPi;
  return texel.mul(material.tint.mul(light) + material.emission);
}

Vec3 Renderer::mirrored(const Vec3& point, const Vec3& direction, const Vec3& normal,
                        float step) const {
  const Vec3 turned = direction - 2.0f * direction.dot(normal) * normal;
  const Hit hit = tracer_.nearest(point + 0.002f * turned, turned, kFarthest);
  if (hit.facet < 0) return {};
  const float extent = 2.0f * step * hit.distance;
  return surface(hit.facet, hit.a, hit.b, extent, extent);
}

}  // namespace place_recognition::simulation
