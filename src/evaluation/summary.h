#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/evaluation.h"
#include "evaluation/metrics.h"
#include "evaluation/over_time.h"
#include "recognition/model/scores.h"

namespace place_recognition {

/// The answers to the images of one room, in one recording or in all. Rates count the most probable
/// place, even if the answer is 'unknown'; the fraction of 'unknown' is separate.
struct RoomSummary {
  int place = 0;  ///< index into Summary::places
  std::uint64_t count = 0;
  std::uint64_t correct = 0;
  std::uint64_t unknown = 0;

  double rate() const { return static_cast<double>(correct) / static_cast<double>(count); }
  double unknownFraction() const {
    return static_cast<double>(unknown) / static_cast<double>(count);
  }
};

/// Text such as "96.5 %"; empty without a rate.
std::string rateText(const std::optional<double>& rate);

/// The rooms in one run (usually one illumination condition).
struct RecordingSummary {
  std::string name;
  std::string condition;                    ///< last part of the name, without `.bag`
  std::vector<RoomSummary> rooms;           ///< learned rooms with images
  std::optional<double> average_rate = {};  ///< mean of their rates; empty without rooms

  /// The rate of a room, such as "96.5 %"; empty if the recording does not show it.
  std::string rateText(int place) const;
};

/// The answers to the single frames of one of several cameras.
struct CameraSummary {
  std::string name;         ///< its topic; "images in folders" for folders, which have none
  std::uint64_t count = 0;  ///< images of learned rooms
  std::optional<double> average_rate = {};  ///< mean of the rooms' rates; empty without images
};

/// Counts by true place (row) and most probable place (column).
struct Confusion {
  std::vector<std::vector<std::uint64_t>> counts;
  std::vector<std::uint64_t> none;  ///< by true place: images without any feature
};

/// Detection of places that were never learned.
struct UnknownSummary {
  double roc_area = 0;          ///< of the evidence, learned places against other places
  double false_alarm_rate = 0;  ///< fraction of images of learned places answered 'unknown'
  double detection_rate = 0;    ///< fraction of images of other places answered 'unknown'
  std::vector<RocPoint> roc;    ///< learned (positive) and other places below each threshold
};

/// The figures of an evaluation.
struct Summary {
  std::vector<std::string> places;  ///< as in Evaluation
  std::vector<RoomSummary> rooms;   ///< over all runs: learned rooms with images
  double average_rate = 0;          ///< mean of their rates, with equal weight per room
  std::vector<RecordingSummary> recordings;
  double test_set_rate = 0;  ///< mean over the rooms of each recording, all with equal weight
                             ///< (thesis section 8.1); equals average_rate for a single run
  std::vector<CameraSummary> cameras;  ///< if there are several
  Confusion confusion;
  std::vector<ConfusedPair> confused;       ///< indices into places; the most confused first
  std::vector<ReliabilityBin> reliability;  ///< from here on: of images of learned places
  double calibration_error = 0;
  std::vector<RiskPoint> risk_coverage;
  double unknown_share = 0;               ///< fraction answered 'unknown'
  std::optional<UnknownSummary> unknown;  ///< if there are images of other places
  std::optional<OverTime> over_time;      ///< if a run is a drive
  double latency_p50 = 0;                 ///< s, of all images; see quantile()
  double latency_p95 = 0;
  double latency_p99 = 0;
};

Summary summarize(const Evaluation& evaluation);

}  // namespace place_recognition
