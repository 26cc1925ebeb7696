#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <set>

#include "base/place_name.h"
#include "base/text.h"
#include "datasets/image_folder.h"
#include "datasets/image_sequence.h"
#include "datasets/layouts.h"
#include "labels/labels.h"
#include "place_recognition/error.h"
#include "ros/bags/bag_file.h"
#include "ros/bags/labelled_bag_writer.h"
#include "tool/output.h"
#include "tool/unusable_images.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct ImportOptions {
  std::string folder;
  std::string out;
  Layout layout;
  double rate = 0;  // Hz; 0: that of the layout
  bool raw = false;
  OutputOptions output;
};

/// Throws Error unless ROS can store the stamps of the images, which are in order.
void requireSeconds(const std::vector<LabelledImage>& images) {
  constexpr double kEnd = 4294967295.;  // of ROS time, s since 1970
  for (const LabelledImage* image : {&images.front(), &images.back()}) {
    if (image->stamp >= 0 && image->stamp < kEnd) continue;
    throw Error("The time in the name of " + image->path +
                " is not in seconds since 1970; rename the images.");
  }
}

/// Says if a gap between the images is so long that they hardly are one recording.
void warnOfGap(const std::vector<LabelledImage>& images, std::vector<std::string>& warnings) {
  constexpr double kDay = 24 * 60 * 60;  // s
  const auto before = std::adjacent_find(images.begin(), images.end(),
                                         [](const LabelledImage& image, const LabelledImage& next) {
                                           return next.stamp - image.stamp > kDay;
                                         });
  if (before == images.end()) return;
  warnings.push_back("More than a day lies between " + before->path + " and " +
                     std::next(before)->path +
                     "; a bag holds one recording, so import each into a bag of its own.");
}

/// The folder of the images to import: for the layout of rooms, `folder` or the one run in it.
std::string folderOfRun(const std::string& folder, const std::string& layout) {
  const std::string what = whyNoRecording(folder);
  if (!what.empty()) throw Error(folder + " is " + what + ".");
  if (layout != "rooms" || holdsRoomImages(folder)) return folder;
  std::vector<std::string> runs;
  for (const std::string& name : entriesOf(folder).folders) {
    const std::string path = (std::filesystem::path(folder) / name).string();
    if (holdsRoomImages(path)) runs.push_back(path);
  }
  if (runs.size() > 1) {
    throw Error("The folder " + folder + " contains " + counted(runs.size(), "recording") +
                "; give one of them, such as " + runs.front() +
                ", or put the images of each room directly into its folder.");
  }
  return runs.empty() ? folder : runs.front();
}

bool hasStamps(const Layout& layout) { return layout.name == "idol" || layout.name == "cold"; }

/// Throws UsageError for an option that the layout does not have.
Layout layoutOf(const ImportOptions& options) {
  Layout layout = options.layout;
  if (!layout.camera.empty() && layout.name != "cold") {
    throw UsageError("--camera requires --layout cold");
  }
  if (!layout.condition.empty() && layout.name != "indecs") {
    throw UsageError("--condition requires --layout indecs");
  }
  if (options.rate > 0 && hasStamps(layout)) {
    throw UsageError("--rate requires --layout rooms or indecs, because the others have stamps");
  }
  if (options.rate > 0) layout.rate = options.rate;
  return layout;
}

/// The images in the folder. Throws Error if a bag cannot store their labels or stamps.
std::vector<LabelledImage> imagesFor(const std::string& folder, const Layout& layout,
                                     std::vector<std::string>& warnings) {
  std::vector<LabelledImage> images = listImages(folder, layout, warnings);
  std::set<std::string> checked;
  for (const LabelledImage& image : images) {
    const bool is_new = !image.place.empty() && checked.insert(image.place).second;
    if (is_new) checkLabel(image.place, image.path);
  }
  if (hasStamps(layout)) {
    requireSeconds(images);
    warnOfGap(images, warnings);
  }
  return images;
}

struct WrittenBag {
  std::set<std::string> places;
  std::map<std::string, std::string> problems;  ///< the first one, by place
  UnusableImages unusable;
  std::string note;  ///< on the images as a whole; may be empty
};

WrittenBag writeBag(const ImportOptions& options, const std::vector<LabelledImage>& images,
                    const Progress& progress) {
  LabelledBagOptions bag_options;
  bag_options.jpeg = !options.raw;
  // Stamps that start at 0 are shifted to a time that ROS accepts; others are kept.
  if (images.front().stamp > 0) bag_options.base_time = 0;

  const NewFolder folder(std::filesystem::absolute(options.out).parent_path().string());
  LabelledBagWriter bag(options.out, bag_options);
  WrittenBag written;
  std::vector<std::string> paths;
  for (const LabelledImage& image : images) paths.push_back(image.path);
  ImageSequence sequence(std::move(paths));
  for (std::size_t i = 0; i < images.size(); ++i) {
    const LabelledImage& image = images[i];
    report(progress, "Importing", static_cast<double>(i) / images.size());
    const DecodedImage decoded = sequence.read(i);
    if (decoded.image.empty()) {
      written.unusable.add(image.path, decoded.problem);
      written.problems.emplace(image.place, image.path + ": " + decoded.problem);
      continue;
    }
    bag.write(decoded.image, image.place, image.stamp);
    written.places.insert(image.place);
  }
  written.unusable.requireOthers(images.size());
  written.note = sequence.note();
  bag.close();
  return written;
}

void warnOfPlaces(const WrittenBag& written, std::vector<std::string>& warnings) {
  for (const auto& [place, problem] : written.problems) {
    if (written.places.count(place) > 0) continue;
    warnings.push_back("'" + place + "' is not in the bag: its images cannot be used (" + problem +
                       ").");
  }
  for (std::string& sentence : warnOfLikeNames({written.places.begin(), written.places.end()})) {
    warnings.push_back(std::move(sentence));
  }
}

void importImages(const ImportOptions& options) {
  const Layout layout = layoutOf(options);
  requireWritable(options.out, Contents::kBag);
  requireNoLabelsBeside(options.out);
  const std::string folder = folderOfRun(options.folder, layout.name);
  std::vector<std::string> warnings;
  const std::vector<LabelledImage> images = imagesFor(folder, layout, warnings);
  const bool replaces = std::filesystem::exists(options.out);
  ProgressDisplay display(options.output.progress);
  const WrittenBag written = writeBag(options, images, display.callback());
  if (!written.note.empty()) warnings.push_back(folder + ": " + written.note);
  warnOfPlaces(written, warnings);
  display.clear();
  printWarnings(warnings);
  written.unusable.warn(std::cerr);
  if (replaces) std::cerr << "note: " << options.out << " existed and was replaced.\n";
  const std::size_t count = images.size() - written.unusable.count();
  options.output.text() << options.out << ": " << counted(count, "image") << " of "
                        << counted(written.places.size(), "place") << std::endl;
  options.output.writeJson({{"path", options.out},
                            {"images", count},
                            {"unusable_images", written.unusable.count()},
                            {"places", written.places},
                            {"warnings", warnings}});
}

}  // namespace

void addImport(CommandLine& tool) {
  Verb& verb = tool.verb("import", "Makes a labelled bag from images on disk");
  const auto options = std::make_shared<ImportOptions>();
  verb.argument("FOLDER", options->folder, "Folder of images");
  verb.option("--out", "RUN.bag", options->out, "Bag to write").required().written();
  verb.option("--layout", "NAME", options->layout.name,
              "Layout of the images: rooms (default), indecs, idol or cold")
      .oneOf({"rooms", "indecs", "idol", "cold"});
  verb.option("--condition", "NAME", options->layout.condition,
              "indecs: the light to import if the folder holds several: cloudy, night or sunny")
      .oneOf({"cloudy", "night", "sunny"});
  verb.option("--rate", "HZ", options->rate,
              "rooms, indecs: images per second (default 5); the other layouts have stamps")
      .positive();
  verb.option("--camera", "NAME", options->layout.camera,
              "cold: the camera, std_cam (default) or omni_cam; train on the latter with --set "
              "image.panorama.mirror=found")
      .oneOf({"std_cam", "omni_cam"});
  verb.flag("--raw", options->raw, "Store pixels (sensor_msgs/Image) instead of JPEG");
  options->output.addTo(verb);
  verb.footer(
      "Layouts:\n"
      "  rooms   ROOM/IMAGE\n"
      "  indecs  cloudy, night or sunny and the room as folders or words of the name, then marker\n"
      "          and angle: cloudy/kitchen/kitchen_07_120.png\n"
      "  idol    one sequence: tTIME_rROOM_xX_yY_aANGLE.png\n"
      "  cold    one sequence: std_cam/tTIME_xX_yY_aANGLE.jpeg, localization/places.lst\n"
      "Example:\n"
      "  place_tool import dum_cloudy1 --layout idol --out dum_cloudy1.bag");
  verb.run([options] { importImages(*options); });
}

}  // namespace place_recognition::tool
