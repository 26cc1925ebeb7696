#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/cell_store.h"
#include "place_recognition/progress.h"

namespace place_recognition {

/// A table as it is printed; the first row is the heading.
struct Table {
  std::string name;   ///< of its file, as in table_8_4
  std::string title;  ///< what it shows, a line
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

/// What an experiment shows.
struct Findings {
  std::vector<Table> tables;
  std::vector<Figure> figures = {};
  std::vector<Page> pages = {};
};

/// Takes the result of a cell as soon as it is there.
using CellSink = std::function<void(const Json& cell, const Json& result)>;

/// A sweep cut into cells, each of which is computed by itself with the same result whichever
/// others are computed beside it.
class Experiment {
 public:
  virtual ~Experiment() = default;

  /// What tells the cells of this experiment apart; with the data, all that determines a result.
  /// Those that have much in common are neighbours.
  virtual std::vector<Json> cells() const = 0;

  /// Computes some of cells(), in that order.
  virtual void compute(const std::vector<Json>& cells, const CellSink& finished,
                       const Progress& progress) = 0;

  /// `results`: one per cell, in the order of cells().
  virtual Findings findings(const std::vector<Json>& results) const = 0;
};

}  // namespace place_recognition
