#include "datasets/size_count.h"

#include <algorithm>

#include "base/text.h"

namespace place_recognition {

void SizeCount::add(const cv::Size& size, const std::string& name) {
  if (!size.empty()) ++sizes_.try_emplace(size, Same{name}).first->second.count;
}

cv::Size SizeCount::usual() const {
  const auto usual = std::max_element(
      sizes_.begin(), sizes_.end(),
      [](const auto& a, const auto& b) { return a.second.count < b.second.count; });
  return usual == sizes_.end() ? cv::Size() : usual->first;
}

std::string SizeCount::note() const {
  if (sizes_.size() < 2) return "";
  const cv::Size most = usual();
  std::size_t count = 0;
  for (const auto& [size, same] : sizes_) count += same.count;
  const std::size_t others = count - sizes_.at(most).count;
  const auto other = std::find_if(sizes_.begin(), sizes_.end(),
                                  [&](const auto& entry) { return entry.first != most; });
  const std::string example =
      other->second.first + ", " + sizeText(other->first.width, other->first.height);
  return std::to_string(others) + " of " + counted(count, "image") +
         (others == 1 ? " has" : " have") + " another size than the usual " +
         sizeText(most.width, most.height) +
         (others == 1 ? ": " + example : " (such as " + example + ")") + ".";
}

}  // namespace place_recognition
