#include "ros/recognizer/place_recognizer.h"

#include <place_recognition/ModelInfo.h>
#include <place_recognition/PlaceRecognition.h>

#include <algorithm>
#include <boost/make_shared.hpp>
#include <exception>
#include <opencv2/core/utility.hpp>

#include "base/place_name.h"
#include "base/user_path.h"
#include "place_recognition/error.h"
#include "ros/messages/conversions.h"
#include "ros/nodes/node_names.h"

namespace place_recognition {
namespace {

/// Between two looks at whether images have stopped, s.
constexpr double kCameraPeriod = 0.2;
/// Between two warnings of one kind, s.
constexpr double kWarningPeriod = 10;

std::string modelText(const Model& model) {
  return model.name + " (version " + model.version + "): " + std::to_string(model.places.size()) +
         " places, " + std::to_string(model.supportVectorCount()) + " support vectors";
}

/// Those of the models in use, with commas between them.
std::string modelTexts(const std::deque<ModelSlot>& slots) {
  std::string text;
  for (const ModelSlot& slot : slots) {
    if (const auto model = slot.model()) text += (text.empty() ? "" : ", ") + modelText(*model);
  }
  return text;
}

std::vector<std::string> topicsOf(const ros::NodeHandle& node,
                                  const std::vector<CameraName>& cameras) {
  std::vector<std::string> topics;
  for (const CameraName& camera : cameras) topics.push_back(node.resolveName(camera.topic));
  return topics;
}

KeepOptions readKeepOptions(Parameters& parameters, const ros::NodeHandle& node) {
  KeepOptions options;
  options.folder = userPath(parameters.text("keep_doubtful"));
  options.per_hour = parameters.integer("keep_per_hour", options.per_hour, 1, 1000000);
  options.megabytes = parameters.integer("keep_megabytes", options.megabytes, 1, 1000000);
  options.label_topic = node.resolveName(names::kPlaceLabel);
  return options;
}

ImageMessage imageOf(const Recognize::Request& request) {
  if (request.image.data.empty() == request.compressed.data.empty()) {
    throw Error("Give one image, either as image or as compressed.");
  }
  if (request.image.data.empty()) {
    return ImageMessage(boost::make_shared<const sensor_msgs::CompressedImage>(request.compressed));
  }
  return ImageMessage(boost::make_shared<const sensor_msgs::Image>(request.image));
}

/// dynamic_reconfigure reads these itself, but takes a value that it does not understand for the
/// default one and moves others into their limits, without a word.
void checkLiveParameters(Parameters& parameters, const ros::NodeHandle& private_node) {
  const auto check = [&](const char* name, double PlaceRecognizerConfig::*field) {
    const double least = PlaceRecognizerConfig::__getMin__().*field;
    const double most = PlaceRecognizerConfig::__getMax__().*field;
    const double initial = PlaceRecognizerConfig::__getDefault__().*field;
    private_node.setParam(name, parameters.real(name, initial, least, most));
  };
  check("unknown_threshold", &PlaceRecognizerConfig::unknown_threshold);
  check("smoothing", &PlaceRecognizerConfig::smoothing);
  check("maximum_rate", &PlaceRecognizerConfig::maximum_rate);
  check("embedding_rate", &PlaceRecognizerConfig::embedding_rate);
  check("deadline", &PlaceRecognizerConfig::deadline);
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
      image_timeout_(parameters.real("image_timeout", names::kImageTimeout, 0)),
      newest_(names_.size()),
      diagnostics_(node, private_node, name),
      lazy_(parameters.flag("lazy", true)),
      place_tracker_(node, parameters, topicsOf(node, names_)),
      doubtful_frames_(readKeepOptions(parameters, node)) {
  const std::string model = parameters.text("model");
  const int threads = parameters.integer("threads", 0, 0);
  if (parameters.flag("simulated_time", false) && !ros::Time::isSimTime()) {
    ROS_WARN(
        "~simulated_time has no effect by itself: remap /use_sim_time to it, as recognize.launch "
        "does.");
  }
  checkLiveParameters(parameters, private_node);
  {
    // Those who listen at once must wait until all is there.
    const std::lock_guard<std::mutex> lock(control_mutex_);
    startCameras(parameters);
    advertise();
  }
  parameters.warnOfDoubts();
  if (threads > 0) cv::setNumThreads(threads);
  reconfigure_server_ = std::make_unique<dynamic_reconfigure::Server<PlaceRecognizerConfig>>(
      reconfigure_mutex_, private_node_);
  reconfigure_server_->setCallback(
      [this](PlaceRecognizerConfig& config, std::uint32_t) { onReconfigure(config); });
  answers_.forget(place_tracker_);
  loadFirstModels(model);
  worker_ = std::thread([this] { work(); });
  updateSubscription();
  diagnostics_.start();
  // Wall time, as in diagnostics.
  if (image_timeout_ > 0) {
    camera_timer_ = private_node_.createWallTimer(
        ros::WallDuration(kCameraPeriod), [this](const ros::WallTimerEvent&) { watchCamera(); });
  }
}

PlaceRecognizer::~PlaceRecognizer() {
  {
    const std::lock_guard<std::mutex> lock(control_mutex_);
    enabled_ = false;
    for (const auto& camera : cameras_) camera->unsubscribe();
  }
  newest_.close();
  worker_.join();
}

void PlaceRecognizer::startCameras(Parameters& parameters) {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const CameraName& name = names_[i];
    const std::string of_camera = name.name.empty() ? "" : " of " + name.name;
    if (i == 0 || !name.model.empty()) {
      model_slots_.emplace_back();
      diagnostics_.add(name.model.empty() ? "Model" : "Model" + of_camera, model_slots_.back());
    }
    cameras_.push_back(std::make_unique<CameraRecognizer>(
        node_, private_node_, parameters, name, model_slots_.back(),
        [this, i](const ImageMessage& message) { onImage(i, message); },
        [this] { updateSubscription(); }));
    diagnostics_.add("Images" + of_camera, cameras_.back()->status());
  }
}

void PlaceRecognizer::advertise() {
  // Who listens to an answer wants images; ~model_info and diagnostics need none.
  answers_.advertise(private_node_, [this] { updateSubscription(); });
  model_info_publisher_ = private_node_.advertise<ModelInfo>(names::kModelInfo, 1, true);
  services_ = {
      private_node_.advertiseService(names::kLoadModel, &PlaceRecognizer::onLoadModel, this),
      private_node_.advertiseService(names::kReloadModel, &PlaceRecognizer::onReloadModel, this),
      private_node_.advertiseService(names::kSetEnabled, &PlaceRecognizer::onSetEnabled, this),
      private_node_.advertiseService(names::kReset, &PlaceRecognizer::onReset, this),
      private_node_.advertiseService(names::kRecognize, &PlaceRecognizer::onRecognize, this)};
}

void PlaceRecognizer::loadFirstModels(const std::string& name) {
  for (std::size_t i = 0; i < model_slots_.size(); ++i) {
    const std::string& wanted = names_[i].model.empty() ? name : names_[i].model;
    try {
      if (wanted.empty()) throw Error("The parameter ~model is not set.");
      model_slots_[i].load(wanted);
    } catch (const Error& e) {
      ROS_ERROR(
          "There is no model to recognize with: %s Learn one with `rosrun place_recognition "
          "place_tool train RUN.bag --model NAME` or with the node trainer, then call %s.",
          e.what(), private_node_.resolveName(names::kLoadModel).c_str());
    }
  }
  publishModelInfo();
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
    newest_.clear();
  }
  // The latched room must not wait for whoever listens next.
  const std::lock_guard<std::mutex> lock(state_mutex_);
  answers_.forget(place_tracker_);
}

void PlaceRecognizer::onImage(std::size_t camera, const ImageMessage& message) {
  ImageStatus& status = cameras_[camera]->status();
  status.arrived();
  if (!newest_.put(message, camera)) status.skipped();
}

void PlaceRecognizer::onReconfigure(PlaceRecognizerConfig& config) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  config_ = config;
}

template <typename Load, typename Response>
void PlaceRecognizer::changeModel(const Load& load, Response& response) {
  try {
    load();
    publishModelInfo();
    response.success = true;
    response.message = "Recognizing with " + modelTexts(model_slots_) + ".";
  } catch (const Error& e) {
    response.success = false;
    response.message = e.what();
    ROS_WARN("The model stays as it is: %s", e.what());
  }
}

bool PlaceRecognizer::onLoadModel(LoadModel::Request& request, LoadModel::Response& response) {
  changeModel(
      [&] {
        for (ModelSlot& slot : model_slots_) slot.load(request.name);
      },
      response);
  return true;
}

bool PlaceRecognizer::onReloadModel(std_srvs::Trigger::Request&,
                                    std_srvs::Trigger::Response& response) {
  changeModel(
      [&] {
        for (ModelSlot& slot : model_slots_) slot.reload();
      },
      response);
  return true;
}

bool PlaceRecognizer::onSetEnabled(std_srvs::SetBool::Request& request,
                                   std_srvs::SetBool::Response& response) {
  {
    const std::lock_guard<std::mutex> lock(control_mutex_);
    enabled_ = request.data;
  }
  updateSubscription();
  reset();  // after the answer that is being worked on
  response.success = true;
  response.message = request.data ? "Recognizing." : "Not recognizing until enabled again.";
  return true;
}

bool PlaceRecognizer::onReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  reset();
  response.success = true;
  response.message = "What was seen before is forgotten.";
  return true;
}

bool PlaceRecognizer::onRecognize(Recognize::Request& request, Recognize::Response& response) {
  try {
    response.recognition = newest_.ask(imageOf(request)).get();
    response.success = true;
  } catch (const std::exception& e) {
    response.message = e.what();
  }
  return true;
}

void PlaceRecognizer::work() {
  while (std::optional<Work> work = newest_.take()) {
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
    CameraRecognizer& camera = *cameras_[arrived.camera];
    camera.status().unusable(e.what());
    ROS_WARN_THROTTLE(kWarningPeriod, "An image on %s cannot be used: %s", camera.topic().c_str(),
                      e.what());
  }
}

void PlaceRecognizer::recognize(const ArrivedImage& arrived) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  CameraRecognizer& camera = *cameras_[arrived.camera];
  const ros::Time stamp = arrived.message.header().stamp;
  const double seconds = (stamp.isZero() ? ros::Time::now() : stamp).toSec();
  if (!camera.admits(seconds, config_.maximum_rate)) {
    camera.status().leftOut();
    last_image_ = arrived.arrival;
    return;
  }
  followModels();
  if (!camera.model()) {
    ROS_WARN_THROTTLE(kWarningPeriod, "There is no model to recognize with.");
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
  // One of several cameras that shows nothing must not outvote the others.
  const bool fails = cameras_.size() > 1 && camera.blind();
  if (!fails && place_tracker_.counts(arrived.camera)) {
    last_image_ = arrived.arrival;
    answers_.publishOverTime(place_tracker_.update(camera.lastStamp(), recognition, arrived.camera),
                             message, place_tracker_);
    doubtful_frames_.take(camera.topic(), arrived.message, recognition, answers_.place());
  }
  camera.publishDebugImage(image, recognition, header);
  camera.status().answered(header.stamp, arrived.arrival);
}

void PlaceRecognizer::publishModelInfo() {
  const std::shared_ptr<const Model> model = model_slots_.front().model();
  if (model) model_info_publisher_.publish(toModelInfo(*model));
  const std::string text = modelTexts(model_slots_);
  if (!text.empty()) ROS_INFO("Recognizing with %s.", text.c_str());
}

void PlaceRecognizer::reset() {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  for (const auto& camera : cameras_) camera->reset();
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
