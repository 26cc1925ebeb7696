#include "recognition/training/remembered_samples.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "learning/classifier_parts.h"

namespace place_recognition {
namespace {

/// Where each of `names` stands in `all`, which holds them, ascending.
std::vector<int> positions(const std::vector<std::string>& names,
                           const std::vector<std::string>& all) {
  std::vector<int> found;
  for (const std::string& name : names) {
    found.push_back(static_cast<int>(std::lower_bound(all.begin(), all.end(), name) - all.begin()));
  }
  return found;
}

/// Numbers places and runs as `samples` does, and appends `part` to it.
void append(Samples part, int first_recording, Samples& samples) {
  const std::vector<int> places = positions(part.places, samples.places);
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
  samples.inputs.insert(samples.inputs.end(), part.inputs.begin(), part.inputs.end());
  samples.skipped += part.skipped;
  samples.passed_over += part.passed_over;
  samples.warnings.insert(samples.warnings.end(), part.warnings.begin(), part.warnings.end());
}

}  // namespace

Samples rememberedSamples(const Model& model) {
  Samples samples;
  samples.places = model.places;
  samples.images = model.provenance.place_images;
  samples.colours = colourMoments(model.colours, samples.images);
  samples.inputs = model.provenance.inputs;
  samples.skipped = model.provenance.skipped_images;
  samples.adjacency = model.adjacency;
  samples.features.resize(model.classifiers.size());
  for (std::size_t c = 0; c < model.classifiers.size(); ++c) {
    const ClassifierParts& parts = ClassifierParts::of(model.classifiers[c]);
    std::vector<Feature> vectors = parts.support_set.vectors();
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      samples.source.push_back(static_cast<int>(samples.origins.size()));
      samples.origins.push_back({parts.vector_places[i], 0, static_cast<double>(i)});
      for (std::size_t other = 0; other < model.classifiers.size(); ++other) {
        samples.features[other].push_back(other == c ? std::move(vectors[i]) : Feature());
      }
    }
  }
  samples.recorded = samples.remembered = samples.origins.size();
  samples.judged_before = model.held_out;
  return samples;
}

Samples joinSamples(Samples remembered, Samples fresh) {
  Samples all;
  std::set_union(remembered.places.begin(), remembered.places.end(), fresh.places.begin(),
                 fresh.places.end(), std::back_inserter(all.places));
  all.images.assign(all.places.size(), 0);
  all.colours.assign(all.places.size(), {});
  all.adjacency = Adjacency(all.places.size());
  all.remembered = remembered.remembered;
  all.image_profile = fresh.image_profile;
  all.judged_before = std::move(remembered.judged_before);
  all.place_before = positions(remembered.places, all.places);
  append(std::move(remembered), 0, all);
  append(std::move(fresh), 1, all);
  return all;
}

}  // namespace place_recognition
