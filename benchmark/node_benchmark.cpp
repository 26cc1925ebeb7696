// node_benchmark PID FRAMES RATE: publishes FRAMES images of 640 x 480 at RATE images per second
// (0: the next as soon as the last is answered) for a place_recognizer with process ID PID, and
// prints statistics of its answers as JSON. The recognizer has the name /place_recognizer and
// subscribes to /camera/image_raw.

#include <place_recognition/PlaceRecognition.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "views.h"

namespace place_recognition {
namespace {

constexpr std::size_t kImages = 30;
constexpr double kPatience = 5;  // s
/// The first frames, not counted, fill buffers and caches.
constexpr std::size_t kWarmUp = 60;

sensor_msgs::Image toMessage(const cv::Mat& image) {
  sensor_msgs::Image message;
  message.header.frame_id = "camera";
  message.height = static_cast<std::uint32_t>(image.rows);
  message.width = static_cast<std::uint32_t>(image.cols);
  message.encoding = "bgr8";
  message.step = static_cast<std::uint32_t>(image.step);
  message.data.assign(image.datastart, image.dataend);
  return message;
}

/// The resource use of another process, from /proc.
struct Process {
  std::string folder;

  double processorSeconds() const {
    std::ifstream file(folder + "/stat");
    std::string line;
    std::getline(file, line);
    std::istringstream rest(line.substr(line.rfind(')') + 2));
    std::vector<std::string> fields;
    for (std::string field; rest >> field;) fields.push_back(field);
    return static_cast<double>(std::stol(fields.at(11)) + std::stol(fields.at(12))) /
           static_cast<double>(sysconf(_SC_CLK_TCK));
  }

  double megabytes() const {
    std::ifstream file(folder + "/statm");
    long size = 0, resident = 0;
    file >> size >> resident;
    return static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / (1 << 20);
  }
};

/// Counts answers and measures their latency since the image's stamp.
class Answers {
 public:
  void receive(const PlaceRecognition& answer) {
    const double seconds = (ros::Time::now() - answer.header.stamp).toSec();
    const std::lock_guard<std::mutex> lock(mutex_);
    seconds_.push_back(seconds);
  }

  std::vector<double> seconds() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return seconds_;
  }
  std::size_t count() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return seconds_.size();
  }

  /// Waits for `count` answers; false if they do not come in time.
  bool waitFor(std::size_t count) const {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kPatience);
    while (this->count() < count) {
      if (ros::WallTime::now() > end || !ros::ok()) return false;
      ros::WallDuration(0.0002).sleep();
    }
    return true;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<double> seconds_;
};

double quantile(const std::vector<double>& sorted, double fraction) {
  return sorted[static_cast<std::size_t>(fraction * static_cast<double>(sorted.size() - 1))];
}

class Offer {
 public:
  explicit Offer(Process process) : process_(std::move(process)) {
    const Views views;
    for (std::size_t i = 0; i < kImages; ++i) images_.push_back(toMessage(views[i].image));
    publisher_ = node_.advertise<sensor_msgs::Image>("/camera/image_raw", 10);
    subscriber_ =
        node_.subscribe("/place_recognizer/recognition", 1000, &Answers::receive, &answers_);
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kPatience);
    while (publisher_.getNumSubscribers() == 0 && ros::WallTime::now() < end) {
      ros::WallDuration(0.01).sleep();
    }
  }

  /// Publishes `count` images and waits for the answers.
  void run(std::size_t count, double rate) {
    const std::size_t before = answers_.count();
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < count && ros::ok(); ++i) {
      if (rate > 0) {
        const std::chrono::duration<double> due(static_cast<double>(i) / rate);
        std::this_thread::sleep_until(start + due);
      }
      sensor_msgs::Image& image = images_[i % images_.size()];
      image.header.stamp = ros::Time::now();
      publisher_.publish(image);
      if (rate == 0 && !answers_.waitFor(before + i + 1)) break;
    }
    answers_.waitFor(before + count);
  }

  void report(std::size_t count, double rate) {
    run(kWarmUp, 30);
    const std::size_t before = answers_.count();
    const double megabytes = process_.megabytes();
    const double processor = process_.processorSeconds();
    const ros::WallTime start = ros::WallTime::now();
    run(count, rate);
    const double seconds = (ros::WallTime::now() - start).toSec();
    const double fraction = (process_.processorSeconds() - processor) / seconds;
    std::vector<double> latencies = answers_.seconds();
    latencies.erase(latencies.begin(), latencies.begin() + static_cast<std::ptrdiff_t>(before));
    std::sort(latencies.begin(), latencies.end());
    if (latencies.empty()) latencies.push_back(kPatience);
    std::cout << "{\"offered\": " << count << ", \"answered\": " << answers_.count() - before
              << ", \"seconds\": " << seconds << ", \"p50_ms\": " << 1e3 * quantile(latencies, 0.5)
              << ", \"p99_ms\": " << 1e3 * quantile(latencies, 0.99)
              << ", \"share_of_core\": " << fraction << ", \"megabytes\": " << process_.megabytes()
              << ", \"growth_megabytes\": " << process_.megabytes() - megabytes << "}\n";
  }

 private:
  ros::NodeHandle node_;
  Process process_;
  Answers answers_;
  std::vector<sensor_msgs::Image> images_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace
}  // namespace place_recognition

int main(int argc, char** argv) {
  ros::init(argc, argv, "node_benchmark");
  if (argc != 4) {
    std::cerr << "usage: node_benchmark PID FRAMES RATE\n";
    return 2;
  }
  ros::AsyncSpinner spinner(1);
  spinner.start();
  place_recognition::Offer offer({"/proc/" + std::string(argv[1])});
  offer.report(std::stoul(argv[2]), std::stod(argv[3]));
}
