// Feeds arbitrary bytes as a model file. The header is made to match, or it would reject them all.

#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"
#include "recognition/fitting_header.h"

using namespace place_recognition;

namespace {

/// An accepted model must be usable and survive a round trip.
void use(Model parsed) {
  const std::string bytes = serializeModel(parsed);
  if (serializeModel(parseModel(bytes, "again")) != bytes) abort();
  Recognizer recognizer(std::make_shared<const Model>(std::move(parsed)));
  static const cv::Mat image = drawRoom(1, 3)(cv::Rect(0, 0, 40, 32));
  if (!recognizer.recognize(image).probabilities.allFinite()) abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    use(parseModel(withFittingHeader(bytes), "fuzzed"));
  } catch (const Error&) {
  }
  return 0;
}
