#include "tool/bag_info.h"

#include <iomanip>
#include <ostream>

namespace place_recognition::tool {

void printBag(const BagInfo& bag, const std::string& path, std::ostream& out) {
  out << "bag       " << path << "\n";
  if (bag.topics.empty()) {
    out << "no messages" << std::endl;
    return;
  }
  out << std::fixed << std::setprecision(1) << "duration  " << bag.duration << " s from "
      << bag.start << "\n"
      << "topics\n";
  for (const BagTopic& topic : bag.topics) {
    out << std::setw(8) << topic.messages << "  " << topic.name << "  " << topic.type;
    if (topic.width > 0) out << "  " << topic.width << "x" << topic.height;
    out << "\n";
  }
  const std::string source = bag.labels_file.empty() ? "" : " in " + bag.labels_file;
  out << (bag.labels.empty() ? "no labels" + source : "labels" + source + ", s since the start")
      << "\n";
  for (const BagLabel& label : bag.labels) {
    out << std::setw(8) << label.from << " .. " << std::setw(8) << label.to << "  " << label.place
        << "\n";
  }
  out << std::flush;
}

Json bagFigures(const BagInfo& bag, const std::string& path) {
  Json topics = Json::array();
  for (const BagTopic& topic : bag.topics) {
    topics.push_back({{"name", topic.name},
                      {"type", topic.type},
                      {"messages", topic.messages},
                      {"width", topic.width},
                      {"height", topic.height}});
  }
  Json labels = Json::array();
  for (const BagLabel& label : bag.labels) {
    labels.push_back({{"from", label.from}, {"to", label.to}, {"place", label.place}});
  }
  return {{"bag", path},
          {"start", bag.start},
          {"duration", bag.duration},
          {"other_images", bag.other_images},
          {"topics", topics},
          {"labels_file", bag.labels_file},
          {"labels", labels}};
}

}  // namespace place_recognition::tool
