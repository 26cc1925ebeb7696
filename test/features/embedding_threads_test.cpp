// Embeddings while several threads use OpenCV.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <thread>

#include "features/feature_extractor.h"
#include "features/feature_images.h"
#include "features/small_network.h"
#include "place_recognition/network.h"

namespace place_recognition {
namespace {

TEST(EmbeddingThreads, IsTheSameFromEveryThreadAndForEveryNumberOfThreads) {
  const char* data = std::getenv("PLACE_RECOGNITION_TEST_DATA");
  std::vector<EmbeddingOptions> kinds{SmallNetwork::options()};
  for (const char* name : {"mobilenet_v1_0.5_160", "mobilenet_v1_1.0_224"}) {
    EmbeddingOptions options;
    options.network = std::string(data ? data : "") + "/networks/" + name + ".onnx";
    if (!std::filesystem::exists(options.network)) continue;
    loadNetwork(options);
    kinds.push_back(options);
    options.stride = 16;
    loadNetwork(options);
    kinds.push_back(options);
  }
  const int threads_before = cv::getNumThreads();
  const cv::Mat image = noise(24, 20);
  for (const EmbeddingOptions& options : kinds) {
    cv::setNumThreads(1);
    const std::vector<float> expected = extractDense(image, options);
    for (const int threads : {2, 3, 8}) {
      cv::setNumThreads(threads);
      EXPECT_EQ(extractDense(image, options), expected) << options.network << ", " << threads;
      std::vector<std::vector<float>> found(3);
      std::vector<std::thread> workers;
      for (std::vector<float>& values : found) {
        workers.emplace_back([&] {
          for (int i = 0; i < 3; ++i) values = extractDense(image, options);
        });
      }
      for (std::thread& worker : workers) worker.join();
      for (const std::vector<float>& values : found) EXPECT_EQ(values, expected);
    }
  }
  cv::setNumThreads(threads_before);
  if (kinds.size() == 1) GTEST_SKIP() << "real networks are absent";
}

TEST(EmbeddingThreads, IsExtractedWhileOtherThreadsUseOpenCv) {
  const EmbeddingOptions options = SmallNetwork::options();
  const cv::Mat image = noise(24, 20);
  const std::vector<float> expected = extractDense(image, options);
  std::atomic<bool> done{false};
  std::vector<std::thread> others;
  for (int i = 0; i < 3; ++i) {
    others.emplace_back([&done] {
      const cv::Mat large = noise(1200, 1600);
      cv::Mat scaled;
      while (!done) cv::resize(large, scaled, cv::Size(600, 800), 0, 0, cv::INTER_AREA);
    });
  }
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(extractDense(image, options), expected);
  done = true;
  for (std::thread& other : others) other.join();
}

}  // namespace
}  // namespace place_recognition
