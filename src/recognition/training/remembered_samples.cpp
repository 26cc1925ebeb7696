#include "recognition/training/remembered_samples.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

#include "base/options.h"
#include "learning/classifier_parts.h"
#include "place_recognition/error.h"
#include "recognition/frames/image_profile.h"
#include "recognition/frames/image_scaling.h"
#include "recognition/model/embeddings.h"
#include "recognition/model/place_index.h"

namespace place_recognition {
namespace {

/// Renumbers the places and runs of `part` like those of `samples`, and appends it.
void append(Samples part, int first_recording, Samples& samples) {
  std::vector<int> places;
  for (const std::string& name : part.places) places.push_back(placeIndex(name, samples.places));
  const int first_sample = static_cast<int>(samples.origins.size());
  // Remembered samples come first and have no camera.
  if (!part.cameras.empty()) samples.cameras = part.cameras;
  for (const int source : part.source) samples.source.push_back(first_sample + source);
  samples.recorded += part.recorded;
  for (SampleOrigin origin : part.origins) {
    origin.place = places[static_cast<std::size_t>(origin.place)];
    origin.recording += first_recording;
    samples.origins.push_back(origin);
  }
  samples.features.resize(part.features.size());
  for (std::size_t c = 0; c < part.features.size(); ++c) {
    std::move(part.features[c].begin(), part.features[c].end(),
              std::back_inserter(samples.features[c]));
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    samples.images[static_cast<std::size_t>(places[k])] += part.images[k];
    samples.colours[static_cast<std::size_t>(places[k])].add(part.colours[k]);
  }
  for (std::size_t a = 0; a < places.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (!part.adjacency.joined(static_cast<int>(a), static_cast<int>(b))) continue;
      samples.adjacency.join(places[a], places[b]);
    }
  }
  for (JudgedBefore& judged : part.judged_before) {
    for (int& place : judged.place_of) place = places[static_cast<std::size_t>(place)];
    samples.judged_before.push_back(std::move(judged));
  }
  samples.remembered += part.remembered;
  samples.inputs.insert(samples.inputs.end(), part.inputs.begin(), part.inputs.end());
  samples.sketches.insert(samples.sketches.end(), part.sketches.begin(), part.sketches.end());
  samples.skipped += part.skipped;
  samples.passed_over += part.passed_over;
  samples.warnings.insert(samples.warnings.end(), part.warnings.begin(), part.warnings.end());
}

/// Increments the age of remembered samples of places that the new ones show.
void growOlder(Samples& samples) {
  std::set<int> seen;
  for (std::size_t i = samples.remembered; i < samples.origins.size(); ++i) {
    seen.insert(samples.origins[i].place);
  }
  for (std::size_t i = 0; i < samples.remembered; ++i) {
    samples.origins[i].age += static_cast<int>(seen.count(samples.origins[i].place));
  }
}

/// Everything on which a cue's features depend, and the kernel without the parameters found within
/// the runs.
std::string featuresOf(CueOptions cue) {
  cue.weight = 1;
  cue.kernel.gamma = 0;
  return writeOptions(cue);
}

std::vector<std::string> networksOf(const Model& model) {
  std::vector<std::string> checksums;
  for (const EmbeddingOptions* embedding : embeddingsOf(model.options)) {
    checksums.push_back(embedding->loaded->sha256);
  }
  return checksums;
}

/// The size to which `model` scales the training images of `camera`, and the handling of a mirror.
std::string workingSize(const Model& model, const Model& camera) {
  if (!camera.images.known()) return "unknown";
  const cv::Size recorded(camera.images.width, camera.images.height);
  const cv::Size size = ImageScaler(model.images, model.options.image.max_width).sizeFor(recorded);
  const bool mirror = model.options.image.panorama.mirror != "none";
  return std::to_string(size.width) + "x" + std::to_string(size.height) +
         (mirror ? " with a mirror" : "");
}

}  // namespace

Samples rememberedSamples(const Model& model) {
  Samples samples;
  samples.places = model.places;
  samples.images = model.provenance.place_images;
  samples.colours = colourMoments(model.colours, samples.images);
  samples.inputs = model.provenance.inputs;
  samples.sketches = model.provenance.sketches;
  samples.sketches.resize(samples.inputs.size());
  samples.skipped = model.provenance.skipped_images;
  samples.adjacency = model.adjacency;
  samples.features.resize(model.classifiers.size());
  for (std::size_t c = 0; c < model.classifiers.size(); ++c) {
    const ClassifierParts& parts = ClassifierParts::of(model.classifiers[c]);
    std::vector<Feature> vectors = parts.support_set.vectors();
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      samples.source.push_back(static_cast<int>(samples.origins.size()));
      SampleOrigin& origin = samples.origins.emplace_back();
      origin.place = parts.origins[i].place;
      origin.stamp = static_cast<double>(i);
      origin.age = parts.origins[i].age;
      for (std::size_t other = 0; other < model.classifiers.size(); ++other) {
        samples.features[other].push_back(other == c ? std::move(vectors[i]) : Feature());
      }
    }
  }
  samples.recorded = samples.remembered = samples.origins.size();
  std::vector<int> same(model.places.size());
  std::iota(same.begin(), same.end(), 0);
  samples.judged_before.push_back({model.held_out, std::move(same)});
  samples.image_profile = model.images;
  return samples;
}

Samples joinSamples(Samples remembered, Samples others) {
  assert(remembered.remembered == remembered.origins.size());
  Samples all;
  std::set_union(remembered.places.begin(), remembered.places.end(), others.places.begin(),
                 others.places.end(), std::back_inserter(all.places));
  all.images.assign(all.places.size(), 0);
  all.colours.assign(all.places.size(), {});
  all.adjacency = Adjacency(all.places.size());
  all.image_profile = remembered.image_profile;
  include(others.image_profile, all.image_profile);
  const int recordings = recordingCount(remembered.origins);
  append(std::move(remembered), 0, all);
  append(std::move(others), recordings, all);
  growOlder(all);
  return all;
}

void requireJoinable(const Model& model, const Model& other) {
  const auto refuse = [&](const std::string& why) {
    throw Error("The model '" + other.name + "' cannot join '" + model.name + "': " + why +
                "; train both with the same configuration.");
  };
  const std::vector<CueOptions>& cues = model.options.cues;
  if (cues.size() != other.options.cues.size()) refuse("its cues are different");
  for (std::size_t c = 0; c < cues.size(); ++c) {
    if (featuresOf(cues[c]) != featuresOf(other.options.cues[c])) {
      refuse("its cue '" + other.options.cues[c].name + "' differs from '" + cues[c].name + "'");
    }
  }
  if (networksOf(model) != networksOf(other)) refuse("its network is different");
  const std::string size = workingSize(other, other), here = workingSize(model, other);
  if (size != here) refuse("its images were scaled to " + size + " pixels, not at " + here);
  const ImageProfile &images = model.images, &others = other.images;
  if (images.levels.low != others.levels.low || images.levels.high != others.levels.high) {
    refuse("images with 16 bits were converted to 8 bits in another way");
  }
}

}  // namespace place_recognition
