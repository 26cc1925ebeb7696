// fuzz_corpus FOLDER: writes the initial corpora of the fuzzers to FOLDER/model, FOLDER/image and
// FOLDER/network.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <opencv2/imgcodecs.hpp>

#include "features/small_network.h"
#include "recognition/drawn_recording.h"
#include "reliability/preset_models.h"

using namespace place_recognition;

namespace {

void write(const std::string& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

void writeImage(const std::string& path, const cv::Mat& image, const char* extension) {
  std::vector<std::uint8_t> file;
  cv::imencode(extension, image, file);
  write(path, "c" + std::string(file.begin(), file.end()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_corpus FOLDER\n";
    return 2;
  }
  const std::string folder = argv[1];
  std::filesystem::create_directories(folder + "/model");
  std::filesystem::create_directories(folder + "/image");
  std::filesystem::create_directories(folder + "/network");
  write(folder + "/network/small", SmallNetwork::onnx());
  int number = 0;
  // Trained on few images, because a fuzzer reads small models much faster.
  for (const std::string& model : trainPresets(drawFrames(2, 2))) {
    write(folder + "/model/" + std::to_string(number++), model);
  }
  const cv::Mat image = drawRoom(1, 1)(cv::Rect(0, 0, 16, 12));
  writeImage(folder + "/image/png", image, ".png");
  writeImage(folder + "/image/jpeg", image, ".jpg");
  write(folder + "/image/raw", std::string("r\x02\0\0\0\x02\0\0\0\x06\0\0\0\0\0abcdefghijkl", 27));
}
