#include "ros/recognizer/place_recognizer.h"

#include <place_recognition/PlaceRecognition.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "base/place_name.h"
#include "place_recognition/error.h"
#include "place_recognition/network.h"
#include "ros/messages/conversions.h"
#include "ros/nodes/node_names.h"
#include "ros/recognizer/live_parameters.h"

namespace place_recognition {
namespace {

/// Interval at which the arrival of images is checked, s.
constexpr double kCameraPeriod = 0.2;

std::vector<std::string> topicsOf(const ros::NodeHandle& node,
                                  const std::vector<CameraName>& cameras) {
  std::vector<std::string> topics;
  for (const CameraName& camera : cameras) topics.push_back(node.resolveName(camera.topic));
  requireDifferentTopics(cameras, topics);
  return topics;
}

void warnOfWallTime(Parameters& parameters) {
  if (!parameters.flag("simulated_time", false) || ros::Time::isSimTime()) return;
  ROS_WARN(
      "~simulated_time has no effect by itself: remap /use_sim_time to it, as recognize.launch "
      "does.");
}

}  // namespace

PlaceRecognizer::PlaceRecognizer(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                 const std::string& name)
    : PlaceRecognizer(node, private_node, name, Parameters(private_node)) {}

PlaceRecognizer::PlaceRecognizer(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                 const std::string& name, Parameters parameters)
    : node_(node),
      private_node_(private_node),
      names_(readCameras(parameters)),
      models_(private_node, names_, parameters.text("model")),
      image_timeout_(parameters.real("image_timeout", names::kImageTimeout, 0)),
      queue_(names_.size()),
      usable_(names_.size()),
      clocks_(names_.size()),
      diagnostics_(node, private_node, name),
      lazy_(parameters.flag("lazy", true)),
      place_tracker_(node, parameters, topicsOf(node, names_)),
      doubtful_frames_(readKeepOptions(parameters, node.resolveName(names::kPlaceLabel))) {
  limitOpenCvToOneThread();
  warnOfWallTime(parameters);
  checkLiveParameters(parameters, private_node);
  {
    // Subscribers that connect at once must wait until everything exists.
    const std::lock_guard<std::mutex> lock(control_mutex_);
    startCameras(parameters);
    advertise();
  }
  parameters.warnOfDoubts();
  startReconfigure();
  forgetAnswers();
  models_.loadFirst();
  startWork();
}

PlaceRecognizer::~PlaceRecognizer() {
  {
    const std::lock_guard<std::mutex> lock(control_mutex_);
    enabled_ = false;
    for (const auto& camera : cameras_) camera->unsubscribe();
  }
  queue_.close();
  worker_.join();
}

void PlaceRecognizer::startCameras(Parameters& parameters) {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const CameraName& name = names_[i];
    const std::string of_camera = name.name.empty() ? "" : " of " + name.name;
    const ModelSlot& slot = models_.slotOf(i);
    if (i == 0 || !name.model.empty()) {
      diagnostics_.add(name.model.empty() ? "Model" : "Model" + of_camera, slot);
    }
    cameras_.push_back(std::make_unique<CameraRecognizer>(
        node_, private_node_, parameters, name, slot,
        [this, i](const ImageMessage& message) { onImage(i, message); },
        [this] { updateSubscription(); }));
    diagnostics_.add("Images" + of_camera, cameras_.back()->status());
  }
}

void PlaceRecognizer::advertise() {
  // Listeners to answers need images; those to ~model_info and diagnostics do not.
  answers_.advertise(private_node_, [this] { updateSubscription(); });
  models_.advertise();
  advertiseServices();
}

void PlaceRecognizer::startReconfigure() {
  reconfigure_server_ = std::make_unique<dynamic_reconfigure::Server<PlaceRecognizerConfig>>(
      reconfigure_mutex_, private_node_);
  reconfigure_server_->setCallback(
      [this](PlaceRecognizerConfig& config, std::uint32_t) { onReconfigure(config); });
}

void PlaceRecognizer::startWork() {
  {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    followModels();  // reports now whether the map fits
  }
  worker_ = std::thread([this] { work(); });
  updateSubscription();
  diagnostics_.start();
  // Wall time, as in diagnostics.
  if (image_timeout_ > 0) {
    camera_timer_ = private_node_.createWallTimer(
        ros::WallDuration(kCameraPeriod), [this](const ros::WallTimerEvent&) { watchCamera(); });
  }
}

bool PlaceRecognizer::isWanted() const {
  return enabled_ && (!lazy_ || doubtful_frames_.isKeeping() || answers_.isWanted() ||
                      std::any_of(cameras_.begin(), cameras_.end(),
                                  [](const auto& camera) { return camera->debugImageIsWanted(); }));
}

void PlaceRecognizer::updateSubscription() {
  {
    const std::lock_guard<std::mutex> lock(control_mutex_);
    const bool wanted = isWanted();
    if (wanted == subscribed_) return;
    subscribed_ = wanted;
    for (const auto& camera : cameras_) wanted ? camera->subscribe() : camera->unsubscribe();
    if (wanted) return;
    queue_.clear();
  }
  forgetAnswers();  // the latched room must not remain until somebody listens again
}

void PlaceRecognizer::onImage(std::size_t camera, const ImageMessage& message) {
  ImageStatus& status = cameras_[camera]->status();
  status.arrived();
  if (!queue_.put(message, camera)) status.skipped();
}

void PlaceRecognizer::onReconfigure(PlaceRecognizerConfig& config) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  keepNumbers(config, config_);
  config_ = config;
}

void PlaceRecognizer::work() {
  while (std::optional<Work> work = queue_.take()) {
    std::visit([this](auto& item) { answer(item); }, *work);
  }
}

void PlaceRecognizer::answer(Question& question) {
  try {
    const std::lock_guard<std::mutex> lock(state_mutex_);
    followModels();
    CameraRecognizer& camera = *cameras_.front();
    if (!camera.model()) throw Error("There is no model to recognize with; call ~load_model.");
    const auto start = ImageStatus::Clock::now();
    const Recognition recognition = camera.recognizeImage(question.message);
    const std::chrono::duration<double> spent = ImageStatus::Clock::now() - start;
    question.answer.set_value(
        toPlaceRecognition(recognition, *camera.model(), question.message.header(), spent.count()));
  } catch (...) {
    question.answer.set_exception(std::current_exception());
  }
}

void PlaceRecognizer::answer(const ArrivedImage& arrived) {
  try {
    recognize(arrived);
  } catch (const std::exception& e) {
    cameras_[arrived.camera]->reportUnusable(e.what());
  }
}

void PlaceRecognizer::recognize(const ArrivedImage& arrived) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  CameraRecognizer& camera = *cameras_[arrived.camera];
  const double seconds = camera.timeOf(arrived.message.header().stamp, arrived.arrival);
  if (!camera.admits(seconds, config_.maximum_rate)) {
    camera.status().leftOut();
    if (usable_[arrived.camera]) last_image_ = arrived.arrival;
    return;
  }
  usable_[arrived.camera] = false;  // until publish() finds that it is
  followModels();
  if (!camera.model()) {
    camera.status().judged("not answered, because there is no model");
    ROS_WARN_THROTTLE(10, "There is no model to recognize with.");
    return;
  }
  const auto start = ImageStatus::Clock::now();
  const cv::Mat image = camera.imageOf(arrived.message);
  const Recognition& recognition = camera.recognize(image, seconds, arrived.arrival);
  const std::chrono::duration<double> spent = ImageStatus::Clock::now() - start;
  publish(arrived, image, recognition, spent.count());
}

void PlaceRecognizer::followModels() {
  bool changed = false;
  std::vector<std::shared_ptr<const Model>> models;
  for (const auto& camera : cameras_) {
    changed |= camera->follow(config_);
    models.push_back(camera->model());
  }
  if (changed) {
    place_tracker_.setModels(std::move(models), config_.smoothing);
    for (std::size_t i = 0; i < cameras_.size(); ++i) {
      const std::string why = place_tracker_.whyNotCounted(i);
      cameras_[i]->status().notCounted(why);
      if (!why.empty()) ROS_ERROR("%s: %s.", cameras_[i]->name().c_str(), why.c_str());
    }
  }
  place_tracker_.setSmoothing(config_.smoothing);
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    if (cameras_[i]->model()) {
      place_tracker_.setUnknownThreshold(cameras_[i]->unknownThreshold(), i);
    }
  }
}

void PlaceRecognizer::publish(const ArrivedImage& arrived, const cv::Mat& image,
                              const Recognition& recognition, double seconds) {
  {
    const std::lock_guard<std::mutex> lock(control_mutex_);
    if (!subscribed_) return;
  }
  CameraRecognizer& camera = *cameras_[arrived.camera];
  const std_msgs::Header& header = arrived.message.header();
  PlaceRecognition message = toPlaceRecognition(recognition, *camera.model(), header, seconds);
  message.camera = camera.name();
  answers_.publishFrame(message);
  // An image without a place is no evidence over time, and a camera that shows nothing must not
  // outvote the others.
  const bool shows_nothing = recognition.place < 0 && config_.smoothing > 0;
  const bool fails = shows_nothing || (cameras_.size() > 1 && camera.blind());
  if (const auto difference = clocks_.add(arrived.camera, camera.lastStamp(), arrived.arrival)) {
    ROS_WARN_THROTTLE(60,
                      "The stamps of the cameras %s and %s differ by %.1f s at the same time, so "
                      "their answers cannot be joined; synchronize the clocks.",
                      camera.name().c_str(), cameras_[difference->other]->name().c_str(),
                      std::abs(difference->seconds));
  }
  if (!fails && place_tracker_.counts(arrived.camera)) {
    usable_[arrived.camera] = true;
    last_image_ = arrived.arrival;
    answers_.publishOverTime(place_tracker_.update(camera.lastStamp(), recognition, arrived.camera),
                             message, place_tracker_);
    doubtful_frames_.take(camera.topic(), arrived.message, recognition, answers_.place());
  }
  camera.publishDebugImage(image, recognition, header);
  camera.status().answered(header.stamp, arrived.arrival);
}

void PlaceRecognizer::reset() {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  for (const auto& camera : cameras_) camera->reset();
  answers_.forget(place_tracker_);
}

void PlaceRecognizer::forgetAnswers() {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  answers_.forget(place_tracker_);
}

void PlaceRecognizer::watchCamera() {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  if (answers_.place() == kUnknownPlace) return;
  const std::chrono::duration<double> silence = ImageStatus::Clock::now() - last_image_;
  if (silence.count() <= image_timeout_) return;
  ROS_WARN("No usable image for %.1f s; the place is unknown.", image_timeout_);
  answers_.forget(place_tracker_);
}

}  // namespace place_recognition
