#pragma once

#include <place_recognition/ModelInfo.h>
#include <place_recognition/PlaceRecognition.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "place_recognition/model.h"
#include "place_recognition/recognizer.h"
#include "place_recognition/temporal_filter.h"

namespace place_recognition {

/// Larger images are rejected before any memory is allocated for them.
constexpr std::uint32_t kMaxImageSide = 8192;

/// Throws Error for an image without pixels or with more than kMaxImageSide pixels on a side.
void checkImageSize(std::uint64_t width, std::uint64_t height);

/// Converts a message to an image, BGR or grey, with 8 or 16 bits per channel (see LevelScale). If
/// the encoding already has this form, the image shares the message's memory, so the message must
/// outlive it. Supports rgb, bgr, rgba, bgra, mono and bayer with 8 or 16 bits, yuv422,
/// yuv422_yuy2, 8UC1, 8UC3 and 16UC1. Throws Error for other encodings and for inconsistent sizes;
/// nothing else, whatever the message contains.
cv::Mat toImage(const sensor_msgs::Image& message);
cv::Mat toImage(sensor_msgs::Image&& message) = delete;

/// The same for an image that decodeImage() accepts. Its `format`, as in image_transport, states
/// the encoding before compression and the stored one: "rgb8; jpeg compressed bgr8" contains BGR,
/// "rgb8; jpeg compressed rgb8" has red and blue swapped, "bayer_rggb8; png compressed" is a
/// mosaic. Without a semicolon ("jpeg") it is BGR or grey.
cv::Mat toImage(const sensor_msgs::CompressedImage& message);

/// The message of an answer to the image with `header`; `seconds` is the time it took.
PlaceRecognition toPlaceRecognition(const Recognition& recognition, const Model& model,
                                    const std_msgs::Header& header, double seconds);

/// Sets the place and the probabilities of all places in `message` to those of `answer`. In the
/// message they sum to 1 without 'unknown'; the probability of 'unknown' is 1 - `evidence`.
void revise(const FilteredAnswer& answer, PlaceRecognition& message);

ModelInfo toModelInfo(const Model& model);

/// The message of a CV_8UC3 or CV_8UC1 image: bgr8 or mono8.
sensor_msgs::Image toImageMessage(const cv::Mat& image, const std_msgs::Header& header);

}  // namespace place_recognition
