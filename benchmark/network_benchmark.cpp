// Times OpenCV's dnn module for a network, by threads, input size and batch.
//   network_benchmark NETWORK.onnx... [--benchmark_...]
#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>
#include <opencv2/dnn.hpp>
#include <string>
#include <vector>

namespace {

/// An input of `batch` square images with sides of `side` pixels.
void forward(benchmark::State& state, const std::string& file, int threads, int batch, int side) {
  cv::setNumThreads(threads);
  try {
    cv::dnn::Net net = cv::dnn::readNetFromONNX(file);
    net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    const std::vector<int> shape = {batch, 3, side, side};
    net.setInput(cv::Mat(shape, CV_32F, cv::Scalar(0.1)));
    net.forward();
    for (auto _ : state) {
      net.setInput(cv::Mat(shape, CV_32F, cv::Scalar(0.1)));
      benchmark::DoNotOptimize(net.forward().data);
    }
    state.counters["per_image"] = benchmark::Counter(
        batch, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  } catch (const cv::Exception& e) {
    state.SkipWithError(e.err.c_str());
  }
}

void add(const std::string& file, int threads, int batch, int side) {
  const std::string name = file.substr(file.rfind('/') + 1) +
                           "/threads:" + std::to_string(threads) +
                           "/batch:" + std::to_string(batch) + "/side:" + std::to_string(side);
  benchmark::RegisterBenchmark(
      name.c_str(), [=](benchmark::State& state) { forward(state, file, threads, batch, side); })
      ->UseRealTime()
      ->MeasureProcessCPUTime();
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  for (int i = 1; i < argc; ++i) {
    for (const int threads : {1, 2}) {
      for (const int side : {128, 160, 192, 224}) add(argv[i], threads, 1, side);
      for (const int batch : {4, 16}) add(argv[i], threads, batch, 160);
    }
  }
  benchmark::RunSpecifiedBenchmarks();
}
