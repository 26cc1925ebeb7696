#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// Whether `path` refers to a ROS 1 bag: by its name (see hasBagName()) or its first bytes.
bool isBag(const std::string& path);

/// The file that `place_tool label` writes for the bag: RUN.labels.yaml beside RUN.bag or
/// RUN.bag.active.
std::string writtenLabelsFile(const std::string& path);

/// The file of labels with the name of the bag, RUN.labels.yaml or RUN.labels.yml beside RUN.bag or
/// RUN.bag.active; empty if there is none.
std::string ownLabelsFile(const std::string& path);

/// The file whose labels replace those in the bag: ownLabelsFile(), or labels.dat in the bag's
/// folder; empty if there is none.
std::string labelsFileBeside(const std::string& path);

/// Throws Error if a labelled bag that is written to `path` would not be read with its own labels.
void requireNoLabelsBeside(const std::string& path);

/// The name of a topic without leading slashes, which old recorders omit, and without trailing
/// ones.
std::string bareName(const std::string& topic);

/// Why a bag whose topics include no images that can be used is not a recording; a phrase that
/// follows "PATH: ", without a full stop.
std::string whyNoImages(const std::vector<std::string>& topics);

/// Whether the folder is a ROS 2 bag.
bool isRos2Bag(const std::string& folder);

/// Throws Error, saying what is there instead, unless `path` can be read and begins like a bag.
void requireBag(const std::string& path);

/// Describes a file or folder that was given as a recording but cannot be read as one: what it is
/// and what to do; a phrase that follows "PATH is ", without a full stop. Empty if nothing is
/// known.
std::string whyNoRecording(const std::string& path);

}  // namespace place_recognition
