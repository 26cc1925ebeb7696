#include "tuning/thinned_run.h"

#include <map>
#include <string>
#include <utility>

#include "recognition/training/sampling.h"

namespace place_recognition {
namespace {

class ThinnedRun : public Run {
 public:
  ThinnedRun(std::unique_ptr<Run> run, std::size_t step, std::uint64_t seed)
      : Run(run->name()), run_(std::move(run)), step_(step), seed_(seed) {}

  bool next(Frame& frame) override {
    while (run_->next(frame)) {
      if (!frame.place.empty() && streamOf(frame.place).keepsNext()) return true;
    }
    return false;
  }

  void setDepthExtent(const DepthExtent& extent) override { run_->setDepthExtent(extent); }
  DepthExtent depthExtent() const override { return run_->depthExtent(); }
  double fraction() const override { return run_->fraction(); }

 private:
  StratifiedStream& streamOf(const std::string& place) {
    return streams_.try_emplace(place, step_, seed_ + streams_.size()).first->second;
  }

  std::unique_ptr<Run> run_;
  std::size_t step_;
  std::uint64_t seed_;
  std::map<std::string, StratifiedStream> streams_;  // of each place so far
};

}  // namespace

std::unique_ptr<Run> thinOut(std::unique_ptr<Run> run, std::size_t step, std::uint64_t seed) {
  return std::make_unique<ThinnedRun>(std::move(run), step, seed);
}

}  // namespace place_recognition
