#include "report/html_page.h"

#include <algorithm>
#include <cstdint>

#include "report/svg.h"

namespace place_recognition {
namespace {

constexpr const char* kStyle =
    R"(body { font: 15px/1.5 sans-serif; color: #333; max-width: 920px; margin: 2em auto; padding: 0 1em }
h1 { font-size: 1.6em; margin-bottom: 0 }
h2 { font-size: 1.2em; margin: 2em 0 0.5em; border-bottom: 1px solid #ddd }
table { border-collapse: collapse }
th, td { padding: 3px 10px; text-align: right; font-weight: normal }
th:first-child { text-align: left; white-space: nowrap; position: sticky; left: 0; background: #fff }
td { font-variant-numeric: tabular-nums }
thead th { border-bottom: 1px solid #999; color: #666; position: sticky; top: 0; background: #fff }
.figures { display: flex; flex-wrap: wrap; gap: 1em 3em; margin: 1em 0 }
.figures b { display: block; font-size: 1.8em; font-weight: normal; color: #3b6ea5 }
.row { display: flex; flex-wrap: wrap; gap: 1em }
figure { margin: 0 }
figcaption { font-size: 0.85em; color: #666; max-width: 320px }
.legend span { display: inline-block; margin-right: 1.2em }
.legend i { display: inline-block; width: 0.9em; height: 0.9em; margin-right: 0.4em }
svg { max-width: 100% }
)";

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? kDigits[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

}  // namespace

std::string htmlPage(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" +
         escapeMarkup(title) + "</title>\n<style>\n" + kStyle + "</style>\n</head>\n<body>\n" +
         body + "</body>\n</html>\n";
}

std::string htmlImage(const std::string& jpeg, int width, const std::string& caption) {
  return "<figure><img width=\"" + std::to_string(width) +
         "\" alt=\"\" src=\"data:image/jpeg;base64," + base64(jpeg) + "\"><figcaption>" + caption +
         "</figcaption></figure>\n";
}

std::string htmlTable(const TextRows& rows) {
  std::string html = "<table>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    html += i == 0 ? "<thead><tr>" : "<tr>";
    for (std::size_t k = 0; k < rows[i].size(); ++k) {
      const std::string cell = i == 0 || k == 0 ? "th>" : "td>";
      html += "<" + cell + escapeMarkup(rows[i][k]) + "</" + cell;
    }
    html += i == 0 ? "</tr></thead>\n" : "</tr>\n";
  }
  return html + "</table>\n";
}

}  // namespace place_recognition
