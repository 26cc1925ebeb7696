// Names the room that an image shows:
//   recognize MODEL.places IMAGE

#include <place_recognition/error.h>
#include <place_recognition/model_file.h>
#include <place_recognition/recognizer.h>

#include <iostream>
#include <memory>
#include <opencv2/imgcodecs.hpp>

namespace pr = place_recognition;

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::cerr << "usage: recognize MODEL.places IMAGE\n";
    return 2;
  }
  const auto model = std::make_shared<const pr::Model>(pr::loadModel(argv[1]));
  const cv::Mat image = cv::imread(argv[2]);
  if (image.empty()) throw pr::Error(std::string("Cannot read the image ") + argv[2] + ".");

  pr::Recognizer recognizer(model);
  const pr::Recognition& answer = recognizer.recognize(image);
  std::cout << (answer.known ? model->places[answer.place] : "unknown") << " " << answer.confidence
            << "\n";
  return 0;
} catch (const pr::Error& e) {
  std::cerr << "recognize: " << e.what() << "\n";
  return 1;
}
