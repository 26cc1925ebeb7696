#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace place_recognition {

/// Finds the images that an earlier input of the same training has shown, as in a copy of a run
/// that lies beside it: learned once more and held out at once, they would make every held-out
/// figure too good. Identical images within one recording stay, as of a robot that stands in a
/// simulator.
class RepeatedImages {
 public:
  /// Begins an input. `continues`: it is the next part of the recording that showed the last image
  /// that was not repeated.
  void begin(const std::string& input, bool continues);

  /// Takes the next image of the input by its hash, if it has one. Returns whether an earlier
  /// recording has shown it, with a label if this one is `labelled`.
  bool isRepeated(const std::optional<std::uint64_t>& hash, bool labelled);

  /// What was repeated in the input so far, a sentence for a person; empty if nothing was.
  std::string sentence() const;

 private:
  struct Shown {
    std::size_t input;  // index into inputs_
    int recording;
    bool labelled;
  };

  std::unordered_map<std::uint64_t, Shown> shown_;  // by hash
  std::vector<std::string> inputs_;
  int recordings_ = 0;
  int recording_ = 0;       // of the input
  int last_recording_ = 0;  // of the last image that was not repeated
  std::uint64_t images_ = 0;
  std::uint64_t repeated_ = 0;
  std::vector<bool> sources_;  // by input: it has shown repeated images
};

}  // namespace place_recognition
