#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "base/cell_store.h"
#include "place_recognition/progress.h"

namespace place_recognition {

/// A printed table; the first row is the header.
struct Table {
  std::string name;   ///< of its file, such as table_8_4
  std::string title;  ///< one line
  std::vector<std::vector<std::string>> rows;
};

/// An SVG drawing.
struct Figure {
  std::string name;
  std::string svg;
};

/// A page for a browser.
struct Page {
  std::string name;
  std::string html;
};

/// The results of an experiment.
struct Findings {
  std::vector<Table> tables;
  std::vector<Figure> figures = {};
  std::vector<Page> pages = {};
};

/// Receives the result of each cell as soon as it is complete.
using CellSink = std::function<void(const Json& cell, const Json& result)>;

/// A sweep divided into cells. Each cell is computed independently; its result does not depend on
/// which others are computed with it.
class Experiment {
 public:
  virtual ~Experiment() = default;

  /// The parameters that identify each cell; together with the data they determine its result.
  /// Cells with much in common are neighbours.
  virtual std::vector<Json> cells() const = 0;

  /// Computes some of cells(), in their order.
  virtual void compute(const std::vector<Json>& cells, const CellSink& finished,
                       const Progress& progress) = 0;

  /// `results`: one per cell, in the order of cells().
  virtual Findings findings(const std::vector<Json>& results) const = 0;

  /// For a person, after compute(): which images it left out and why.
  const std::vector<std::string>& warnings() const { return warnings_; }

 protected:
  /// Adds those sentences to warnings() that it lacks.
  void warn(const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) {
      const bool is_new =
          std::find(warnings_.begin(), warnings_.end(), sentence) == warnings_.end();
      if (is_new) warnings_.push_back(sentence);
    }
  }

 private:
  std::vector<std::string> warnings_;
};

}  // namespace place_recognition
