#include "ros/recognizer/place_recognizer.h"

#include <place_recognition/ModelInfo.h>
#include <place_recognition/PlaceRecognition.h>
#include <std_msgs/String.h>

#include <boost/make_shared.hpp>
#include <exception>
#include <opencv2/core/utility.hpp>

#include "base/place_name.h"
#include "place_recognition/error.h"
#include "ros/messages/conversions.h"
#include "ros/nodes/node_names.h"
#include "ros/recognizer/debug_image.h"
#include "ros/recognizer/place_marker.h"

namespace place_recognition {
namespace {

/// A stamp that lies further back than this, s, means that time has jumped, as in a looped bag.
constexpr double kTimeJump = 0.5;
/// Between two looks at whether images have stopped, s.
constexpr double kCameraPeriod = 0.2;
/// Between two warnings of one kind, s.
constexpr double kWarningPeriod = 10;

/// Seconds of a clock that also runs when a camera repeats its stamp.
double secondsOf(std::chrono::steady_clock::time_point time) {
  return std::chrono::duration<double>(time.time_since_epoch()).count();
}

std::string modelText(const Model& model) {
  return model.name + " (version " + model.version + "): " + std::to_string(model.places.size()) +
         " places, " + std::to_string(model.supportVectorCount()) + " support vectors";
}

ImageMessage pictureOf(const Recognize::Request& request) {
  if (request.image.data.empty() == request.compressed.data.empty()) {
    throw Error("Give one picture, either as image or as compressed.");
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
}

}  // namespace

PlaceRecognizer::PlaceRecognizer(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                 const std::string& name)
    : PlaceRecognizer(node, private_node, name, Parameters(private_node)) {}

PlaceRecognizer::PlaceRecognizer(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                 const std::string& name, Parameters parameters)
    : node_(node),
      private_node_(private_node),
      input_(
          node, private_node, parameters, [this](const ImageMessage& message) { onImage(message); },
          names::kImageQueue),
      diagnostics_(node, private_node, parameters, name, model_slot_, input_),
      image_timeout_(parameters.real("image_timeout", names::kImageTimeout, 0)),
      lazy_(parameters.flag("lazy", true)),
      place_tracker_(node, parameters) {
  const std::string model = parameters.text("model");
  const int threads = parameters.integer("threads", 0, 0);
  if (parameters.flag("simulated_time", false) && !ros::Time::isSimTime()) {
    ROS_WARN(
        "~simulated_time has no effect by itself: remap /use_sim_time to it, as recognize.launch "
        "does.");
  }
  checkLiveParameters(parameters, private_node);
  parameters.warnOfDoubts();
  if (threads > 0) cv::setNumThreads(threads);
  advertise();
  reconfigure_server_ = std::make_unique<dynamic_reconfigure::Server<PlaceRecognizerConfig>>(
      reconfigure_mutex_, private_node_);
  reconfigure_server_->setCallback(
      [this](PlaceRecognizerConfig& config, std::uint32_t) { onReconfigure(config); });
  publishPlace(kUnknownPlace);
  loadFirstModel(model);
  worker_ = std::thread([this] { work(); });
  updateSubscription();
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
    input_.unsubscribe();
  }
  newest_.close();
  worker_.join();
}

void PlaceRecognizer::advertise() {
  // Who listens to an answer wants images; ~model_info and diagnostics need none.
  const ros::SubscriberStatusCallback changed = [this](const ros::SingleSubscriberPublisher&) {
    updateSubscription();
  };
  const image_transport::SubscriberStatusCallback debug_changed =
      [this](const image_transport::SingleSubscriberPublisher&) { updateSubscription(); };
  const std::lock_guard<std::mutex> lock(control_mutex_);
  recognition_publisher_ = private_node_.advertise<PlaceRecognition>(
      names::kRecognition, names::kAnswerQueue, changed, changed);
  place_publisher_ = private_node_.advertise<std_msgs::String>(names::kPlace, names::kAnswerQueue,
                                                               changed, changed, nullptr, true);
  smoothed_publisher_ = private_node_.advertise<PlaceRecognition>(
      names::kSmoothed, names::kAnswerQueue, changed, changed);
  model_info_publisher_ = private_node_.advertise<ModelInfo>(names::kModelInfo, 1, true);
  marker_publisher_ = private_node_.advertise<visualization_msgs::Marker>(
      names::kMarker, names::kAnswerQueue, changed, changed);
  debug_image_publisher_ = image_transport::ImageTransport(private_node_)
                               .advertise(names::kDebugImage, 1, debug_changed, debug_changed);
  services_ = {
      private_node_.advertiseService(names::kLoadModel, &PlaceRecognizer::onLoadModel, this),
      private_node_.advertiseService(names::kReloadModel, &PlaceRecognizer::onReloadModel, this),
      private_node_.advertiseService(names::kSetEnabled, &PlaceRecognizer::onSetEnabled, this),
      private_node_.advertiseService(names::kReset, &PlaceRecognizer::onReset, this),
      private_node_.advertiseService(names::kRecognize, &PlaceRecognizer::onRecognize, this)};
}

void PlaceRecognizer::loadFirstModel(const std::string& name) {
  try {
    if (name.empty()) throw Error("The parameter ~model is not set.");
    model_slot_.load(name);
    publishModelInfo();
  } catch (const Error& e) {
    ROS_ERROR(
        "There is no model to recognize with: %s Learn one with `rosrun place_recognition "
        "place_tool train RUN.bag --model NAME` or with the node trainer, then call %s.",
        e.what(), private_node_.resolveName(names::kLoadModel).c_str());
  }
}

bool PlaceRecognizer::isWanted() const {
  return enabled_ &&
         (!lazy_ || recognition_publisher_.getNumSubscribers() > 0 ||
          place_publisher_.getNumSubscribers() > 0 || smoothed_publisher_.getNumSubscribers() > 0 ||
          marker_publisher_.getNumSubscribers() > 0 ||
          debug_image_publisher_.getNumSubscribers() > 0);
}

void PlaceRecognizer::updateSubscription() {
  {
    const std::lock_guard<std::mutex> lock(control_mutex_);
    const bool wanted = isWanted();
    if (wanted == subscribed_) return;
    subscribed_ = wanted;
    diagnostics_.listening(wanted);
    if (wanted) {
      input_.subscribe();
      return;
    }
    input_.unsubscribe();
    newest_.clear();
  }
  // The latched room must not wait for whoever listens next.
  const std::lock_guard<std::mutex> lock(state_mutex_);
  forgetPlace();
}

void PlaceRecognizer::onImage(const ImageMessage& message) {
  diagnostics_.arrived();
  if (!newest_.put(message)) diagnostics_.skipped();
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
    response.message = "Recognizing with " + modelText(*model_slot_.model()) + ".";
  } catch (const Error& e) {
    response.success = false;
    response.message = e.what();
    ROS_WARN("The model stays as it is: %s", e.what());
  }
}

bool PlaceRecognizer::onLoadModel(LoadModel::Request& request, LoadModel::Response& response) {
  changeModel([&] { model_slot_.load(request.name); }, response);
  return true;
}

bool PlaceRecognizer::onReloadModel(std_srvs::Trigger::Request&,
                                    std_srvs::Trigger::Response& response) {
  changeModel([&] { model_slot_.reload(); }, response);
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
    response.recognition = newest_.ask(pictureOf(request)).get();
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
    if (!followModel()) throw Error("There is no model to recognize with; call ~load_model.");
    const auto start = Diagnostics::Clock::now();
    DepthScale scale = depth_scale_;
    const cv::Mat arrived = question.message.image();
    const cv::Mat image = arrived.depth() == CV_16U ? scale.toEightBits(arrived) : arrived;
    const Recognition& recognition = recognizer_->recognize(image);
    const std::chrono::duration<double> spent = Diagnostics::Clock::now() - start;
    question.answer.set_value(toPlaceRecognition(recognition, recognizer_->model(),
                                                 question.message.header(), spent.count()));
  } catch (...) {
    question.answer.set_exception(std::current_exception());
  }
}

void PlaceRecognizer::answer(const ArrivedImage& arrived) {
  try {
    recognize(arrived);
  } catch (const std::exception& e) {
    diagnostics_.unusable(e.what());
    ROS_WARN_THROTTLE(kWarningPeriod, "An image cannot be used: %s", e.what());
  }
}

void PlaceRecognizer::recognize(const ArrivedImage& arrived) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  const ros::Time stamp = arrived.message.header().stamp;
  const double seconds = (stamp.isZero() ? ros::Time::now() : stamp).toSec();
  followClock(seconds);
  if (!rate_limit_.admits(seconds, config_.maximum_rate)) {
    diagnostics_.leftOut();
    last_image_ = arrived.arrival;
    return;
  }
  if (!followModel()) {
    ROS_WARN_THROTTLE(kWarningPeriod, "There is no model to recognize with.");
    return;
  }
  const auto start = Diagnostics::Clock::now();
  const cv::Mat image = inEightBits(arrived.message.image());
  for (const std::string& warning : guard_->judge(image, secondsOf(arrived.arrival))) {
    ROS_WARN("%s", warning.c_str());
  }
  diagnostics_.judged(guard_->problem());
  const Recognition& recognition = recognizer_->recognize(image, seconds);
  const std::chrono::duration<double> spent = Diagnostics::Clock::now() - start;
  publish(arrived, image, recognition, spent.count());
}

void PlaceRecognizer::followClock(double stamp) {
  if (stamp < last_stamp_ - kTimeJump) {
    ROS_INFO("Time has jumped back by %.1f s; starting afresh.", last_stamp_ - stamp);
    rate_limit_.reset();
    last_stamp_ = stamp;
  }
  last_stamp_ = std::max(last_stamp_, stamp);
}

bool PlaceRecognizer::followModel() {
  const std::shared_ptr<const Model> model = model_slot_.model();
  if (!model) return false;
  if (!recognizer_ || &recognizer_->model() != model.get()) {
    recognizer_ = std::make_unique<Recognizer>(model);
    guard_.emplace(*model);
    depth_scale_ = DepthScale(model->images.depth);
    depth_text_.clear();
    place_tracker_.setModel(model, config_.smoothing);
  }
  const double wanted = config_.unknown_threshold;
  const double threshold = wanted < 0 ? model->unknown_threshold : wanted;
  recognizer_->setUnknownThreshold(threshold);
  recognizer_->setEmbeddingRate(config_.embedding_rate, config_.smoothing);
  place_tracker_.setSmoothing(config_.smoothing);
  place_tracker_.setUnknownThreshold(threshold);
  return true;
}

cv::Mat PlaceRecognizer::inEightBits(const cv::Mat& image) {
  if (image.depth() != CV_16U) return image;
  cv::Mat scaled = depth_scale_.toEightBits(image);
  if (depth_text_ != depth_scale_.text()) {
    depth_text_ = depth_scale_.text();
    ROS_INFO("Images of 16 bits are used in 8, %s.", depth_text_.c_str());
  }
  return scaled;
}

void PlaceRecognizer::publish(const ArrivedImage& arrived, const cv::Mat& image,
                              const Recognition& recognition, double seconds) {
  {
    const std::lock_guard<std::mutex> lock(control_mutex_);
    if (!subscribed_) return;
  }
  last_image_ = arrived.arrival;
  const Model& model = recognizer_->model();
  const std_msgs::Header& header = arrived.message.header();
  const PlaceRecognition message = toPlaceRecognition(recognition, model, header, seconds);
  recognition_publisher_.publish(message);
  const std::string& place = place_tracker_.update(last_stamp_, recognition);
  publishPlace(place);
  publishSmoothed(message);
  if (marker_publisher_.getNumSubscribers() > 0) {
    marker_publisher_.publish(placeMarker(place, header));
  }
  if (debug_image_publisher_.getNumSubscribers() > 0) {
    debug_image_publisher_.publish(toImageMessage(drawAnswer(image, recognition, model), header));
  }
  diagnostics_.answered(header.stamp, arrived.arrival);
}

void PlaceRecognizer::publishPlace(const std::string& place) {
  if (place == last_place_) return;
  last_place_ = place;
  std_msgs::String message;
  message.data = place;
  place_publisher_.publish(message);
}

void PlaceRecognizer::publishSmoothed(const PlaceRecognition& message) {
  if (smoothed_publisher_.getNumSubscribers() == 0) {
    place_tracker_.dropSmoothed();
    return;
  }
  for (const PlaceRecognition& answer : place_tracker_.smooth(message)) {
    smoothed_publisher_.publish(answer);
  }
}

void PlaceRecognizer::publishModelInfo() {
  if (const std::shared_ptr<const Model> model = model_slot_.model()) {
    model_info_publisher_.publish(toModelInfo(*model));
    ROS_INFO("Recognizing with %s.", modelText(*model).c_str());
  }
}

void PlaceRecognizer::reset() {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  rate_limit_.reset();
  if (recognizer_) recognizer_->forgetStream();
  last_stamp_ = 0;
  forgetPlace();
}

void PlaceRecognizer::watchCamera() {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  if (last_place_ == kUnknownPlace) return;
  if (secondsOf(Diagnostics::Clock::now()) - secondsOf(last_image_) <= image_timeout_) return;
  ROS_WARN("No usable image for %.1f s; the place is unknown.", image_timeout_);
  forgetPlace();
}

/// Needs state_mutex_.
void PlaceRecognizer::forgetPlace() {
  for (const PlaceRecognition& answer : place_tracker_.reset()) {
    smoothed_publisher_.publish(answer);
  }
  publishPlace(kUnknownPlace);
}

}  // namespace place_recognition
