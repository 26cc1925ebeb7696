#include "experiments/histogram_tables.h"

#include "base/text.h"
#include "experiments/spread.h"
#include "experiments/table_8_4.h"

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
  std::vector<std::string> head = {"descriptors", "scales", bins ? "bins" : "dim.", "gamma"};
  head.insert(head.end(), sets.begin(), sets.end());
  for (const char* name :
       {"average", "+-", "| scales", "bins", "cloudy", "night", "sunny", "average", "+-"}) {
    head.emplace_back(name);
  }
  table.rows.push_back(head);
  for (std::size_t i = 0; i < thesis.size(); ++i) {
    if (!best[i].histogram) continue;  // omitted because of its dimensions
    const CrfhOptions& options = best[i].histogram->options;
    const std::size_t dimensions = options.descriptors.size() * options.scales.size();
    std::vector<std::string> row = {
        joined(options.descriptors), joined(options.scales),
        std::to_string(bins ? static_cast<std::size_t>(options.bins[0]) : dimensions),
        significant(gammas[best[i].gamma], 3)};
    for (const double rate : best[i].by_set) row.push_back(fixed(100 * rate, 2));
    row.push_back(fixed(100 * best[i].rate.mean, 2));
    row.push_back(fixed(100 * best[i].rate.deviation, 2));
    row.push_back("| " + joined(thesis[i].scales));
    row.push_back(thesis[i].bins > 0 ? std::to_string(thesis[i].bins) : "");
    for (const double rate : {thesis[i].cloudy, thesis[i].night, thesis[i].sunny, thesis[i].average,
                              thesis[i].deviation}) {
      row.push_back(fixed(rate, 2));
    }
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace place_recognition
