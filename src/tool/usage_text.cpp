#include "tool/usage_text.h"

#include <boost/algorithm/string.hpp>
#include <ostream>
#include <sstream>

namespace place_recognition::tool {

std::string orList(const Words& choices) {
  std::string text = choices.front();
  for (std::size_t i = 1; i < choices.size(); ++i) {
    text += (i + 1 < choices.size() ? ", " : " or ") + choices[i];
  }
  return text;
}

void printRow(const std::string& name, const std::string& meaning, std::ostream& out) {
  constexpr std::size_t kColumn = 30;
  constexpr std::size_t kWidth = 96;
  const std::string indent(kColumn, ' ');
  std::string line = "  " + name;
  line += line.size() + 1 < kColumn ? std::string(kColumn - line.size(), ' ') : "\n" + indent;
  std::size_t column = kColumn;
  std::istringstream words(meaning);
  for (std::string word; words >> word; column += word.size() + 1) {
    if (column + word.size() > kWidth) {
      line += "\n" + indent;
      column = kColumn;
    }
    line += word + " ";
  }
  boost::replace_all(line, " \n", "\n");
  out << boost::trim_right_copy(line) << "\n";
}

}  // namespace place_recognition::tool
