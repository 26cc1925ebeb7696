#include "experiments/histogram_tables.h"

#include "base/text.h"
#include "experiments/spread.h"
#include "experiments/thesis_histograms.h"

namespace place_recognition {
namespace {

/// The best histogram and gamma of a row.
struct Best {
  const HistogramResult* histogram = nullptr;
  std::size_t gamma = 0;
  Spread rate;
  std::vector<double> by_set;
};

void improve(Best& best, const HistogramResult& histogram, std::size_t gamma) {
  std::vector<double> by_set;
  for (const std::vector<double>& rates : histogram.rates) by_set.push_back(rates[gamma]);
  const Spread rate = spreadOf(by_set);
  if (best.histogram && rate.mean <= best.rate.mean) return;
  best = {&histogram, gamma, rate, by_set};
}

template <typename Values>
std::string joined(const Values& values) {
  std::string text;
  for (const auto& value : values) {
    if (!text.empty()) text += " ";
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>) {
      text += value;
    } else {
      text += fixed(static_cast<double>(value), 0);
    }
  }
  return text;
}

std::vector<std::string> headOf(HistogramSweep sweep, const std::vector<std::string>& sets) {
  const bool bins = sweep == HistogramSweep::kBins;
  std::vector<std::string> head = {"descriptors", "scales", bins ? "bins" : "dim.", "gamma"};
  head.insert(head.end(), sets.begin(), sets.end());
  for (const char* name :
       {"average", "+-", "| scales", "bins", "cloudy", "night", "sunny", "average", "+-"}) {
    head.emplace_back(name);
  }
  return head;
}

/// `gamma`: the best one.
std::vector<std::string> rowOf(HistogramSweep sweep, const Best& best, double gamma,
                               const ThesisRow& thesis) {
  const CrfhOptions& options = best.histogram->options;
  const std::size_t dimensions = options.descriptors.size() * options.scales.size();
  const bool bins = sweep == HistogramSweep::kBins;
  std::vector<std::string> row = {
      joined(options.descriptors), joined(options.scales),
      std::to_string(bins ? static_cast<std::size_t>(options.bins[0]) : dimensions),
      significant(gamma, 3)};
  for (const double rate : best.by_set) row.push_back(fixed(100 * rate, 2));
  row.push_back(fixed(100 * best.rate.mean, 2));
  row.push_back(fixed(100 * best.rate.deviation, 2));
  row.push_back("| " + joined(thesis.scales));
  row.push_back(thesis.bins > 0 ? std::to_string(thesis.bins) : "");
  for (const double rate :
       {thesis.cloudy, thesis.night, thesis.sunny, thesis.average, thesis.deviation}) {
    row.push_back(fixed(rate, 2));
  }
  return row;
}

}  // namespace

Table histogramTable(HistogramSweep sweep, const std::vector<std::string>& sets,
                     const std::vector<double>& gammas,
                     const std::vector<HistogramResult>& histograms) {
  const bool bins = sweep == HistogramSweep::kBins;
  const std::vector<ThesisRow>& thesis = bins ? table85() : table84();
  std::vector<Best> best(thesis.size());
  for (const HistogramResult& histogram : histograms) {
    for (std::size_t g = 0; g < gammas.size(); ++g) improve(best[histogram.row], histogram, g);
  }

  Table table;
  table.name = bins ? "table_8_5" : "table_8_4";
  table.title = bins ? "Table 8.5: number of bins. Best bins and gamma of each row, in hindsight; "
                       "rates in per cent by training set; right, the thesis"
                     : "Table 8.4: descriptors and scales. Best scales and gamma of each row, in "
                       "hindsight; rates in per cent by training set; right, the thesis";
  table.rows.push_back(headOf(sweep, sets));
  for (std::size_t i = 0; i < thesis.size(); ++i) {
    if (!best[i].histogram) continue;  // omitted because of its dimensions
    table.rows.push_back(rowOf(sweep, best[i], gammas[best[i].gamma], thesis[i]));
  }
  return table;
}

}  // namespace place_recognition
