#include "tuning/thinned_run.h"

#include <map>
#include <string>
#include <utility>

namespace place_recognition {
namespace {

class ThinnedRun : public Run {
 public:
  ThinnedRun(std::unique_ptr<Run> run, std::size_t step)
      : Run(run->name()), run_(std::move(run)), step_(step) {}

  bool next(Frame& frame) override {
    while (run_->next(frame)) {
      if (!frame.place.empty() && seen_[frame.place]++ % step_ == 0) return true;
    }
    return false;
  }

  double fraction() const override { return run_->fraction(); }

 private:
  std::unique_ptr<Run> run_;
  std::size_t step_;
  std::map<std::string, std::size_t> seen_;  // frames of each place so far
};

}  // namespace

std::unique_ptr<Run> thinOut(std::unique_ptr<Run> run, std::size_t step) {
  return std::make_unique<ThinnedRun>(std::move(run), step);
}

}  // namespace place_recognition
