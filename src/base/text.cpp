#include "base/text.h"

#include <unicode/normalizer2.h>
#include <unicode/uchar.h>
#include <unicode/ucnv.h>
#include <unicode/unistr.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "base/place_name.h"

namespace place_recognition {
namespace {

/// The encoding indicated by a byte order mark or by many zeros; nullptr if there are neither.
const char* encodingOf(const std::string& bytes) {
  UErrorCode status = U_ZERO_ERROR;
  const auto size = static_cast<std::int32_t>(std::min<std::size_t>(bytes.size(), 1000));
  const char* marked = ucnv_detectUnicodeSignature(bytes.data(), size, nullptr, &status);
  if (marked) return marked;
  std::int32_t zeros[2] = {0, 0};  // at even and at odd positions
  for (std::int32_t i = 0; i < size; ++i) {
    if (bytes[static_cast<std::size_t>(i)] == 0) ++zeros[i % 2];
  }
  if (4 * zeros[1] > size) return "UTF-16LE";
  if (4 * zeros[0] > size) return "UTF-16BE";
  return nullptr;
}

std::string utf8(const icu::UnicodeString& text) {
  std::string bytes;
  return text.toUTF8String(bytes);
}

/// Whether `c` is invisible and does not change a neighbouring letter: soft hyphens, zero width
/// spaces, direction and byte order marks, which occur in pasted text. Joiners and variation
/// selectors are kept, because emoji and some scripts need them.
bool isInvisible(UChar32 c) {
  return c == 0xad || c == 0x200b || c == 0x200e || c == 0x200f || (c >= 0x202a && c <= 0x202e) ||
         (c >= 0x2060 && c <= 0x2064) || (c >= 0x2066 && c <= 0x2069) || c == 0xfeff;
}

bool isBlank(UChar32 c) { return u_charType(c) == U_SPACE_SEPARATOR; }

bool isTrimmed(UChar32 c) { return u_isUWhiteSpace(c) || c == 0; }

icu::UnicodeString visible(const icu::UnicodeString& text) {
  icu::UnicodeString shown;
  for (std::int32_t i = 0; i < text.length(); i = text.moveIndex32(i, 1)) {
    if (!isInvisible(text.char32At(i))) shown.append(text.char32At(i));
  }
  return shown;
}

}  // namespace

std::string toUtf8(const std::string& bytes) {
  const char* encoding = encodingOf(bytes);
  if (!encoding) return bytes;
  icu::UnicodeString text(bytes.data(), static_cast<std::int32_t>(bytes.size()), encoding);
  if (!text.isEmpty() && text[0] == 0xfeff) text.remove(0, 1);
  return utf8(text);
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }
  return lines;
}

std::string tidied(const std::string& text) {
  UErrorCode status = U_ZERO_ERROR;
  const icu::Normalizer2* composer = icu::Normalizer2::getNFCInstance(status);
  const icu::UnicodeString original = visible(icu::UnicodeString::fromUTF8(text));
  const icu::UnicodeString composed =
      U_SUCCESS(status) ? composer->normalize(original, status) : original;
  std::int32_t begin = 0, end = composed.length();
  while (begin < end && isTrimmed(composed.char32At(begin))) {
    begin = composed.moveIndex32(begin, 1);
  }
  while (end > begin && isTrimmed(composed.char32At(composed.moveIndex32(end, -1)))) {
    end = composed.moveIndex32(end, -1);
  }
  icu::UnicodeString tidy;
  bool after_blank = false;
  for (std::int32_t i = begin; i < end; i = composed.moveIndex32(i, 1)) {
    const UChar32 c = composed.char32At(i);
    if (!isBlank(c)) {
      tidy.append(c);
    } else if (!after_blank) {
      tidy.append(static_cast<UChar32>(' '));
    }
    after_blank = isBlank(c);
  }
  return utf8(tidy);
}

std::string counted(std::uint64_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string fixed(double number, int decimals) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", decimals, number);
  return text;
}

std::string significant(double number, int digits) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.*g", digits, number);
  return text;
}

std::string shortest(double number) {
  std::string text;
  for (int digits = 15; digits <= 17; ++digits) {
    text = significant(number, digits);
    if (std::strtod(text.c_str(), nullptr) == number) break;
  }
  return text;
}

std::string percent(double fraction, int decimals) {
  return fixed(100 * fraction, decimals) + " %";
}

std::string caseFolded(const std::string& text) {
  return utf8(icu::UnicodeString::fromUTF8(text).foldCase());
}

std::string likeness(const std::string& text) {
  UErrorCode status = U_ZERO_ERROR;
  const icu::Normalizer2* folder = icu::Normalizer2::getNFKCCasefoldInstance(status);
  const icu::UnicodeString original = icu::UnicodeString::fromUTF8(text);
  std::string folded = utf8(U_SUCCESS(status) ? folder->normalize(original, status) : original);
  std::replace_if(
      folded.begin(), folded.end(), [](char c) { return c == '_' || c == '-'; }, ' ');
  folded.erase(folded.find_last_not_of(" .,;:!") + 1);
  return tidied(folded);
}

std::string lowerCase(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

bool startsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string listed(const std::vector<std::string>& words, const std::string& separator) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : separator) + word;
  return list;
}

std::string printable(const std::string& text, std::size_t most) {
  std::size_t end = std::min(most, text.size());
  const auto continues = [&](std::size_t i) { return i < text.size() && (text[i] & 0xc0) == 0x80; };
  while (end > 0 && continues(end)) --end;
  std::string shown = text.substr(0, end);
  const unsigned char last = isUtf8(text) ? 0xff : 0x7e;
  std::replace_if(
      shown.begin(), shown.end(),
      [last](unsigned char c) { return c < 0x20 || c == 0x7f || c > last; }, '?');
  return shown + (end < text.size() ? "..." : "");
}

std::string inQuotes(const std::string& text, std::size_t most) {
  return "'" + printable(text, most) + "'";
}

}  // namespace place_recognition
