#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace place_recognition {

/// Converts the text of a file to UTF-8 without a byte order mark. UTF-16 and UTF-32 are recognized
/// by their marks, UTF-16 also by its zeros in place of every other letter. Everything else is
/// assumed to be UTF-8 and left unchanged, well-formed or not.
std::string toUtf8(const std::string& bytes);

/// The lines of a text without their line endings: those of Unix, Windows or old Macs.
std::vector<std::string> linesOf(const std::string& text);

/// Composes UTF-8 text (Unicode normalization form C), removes invisible characters (soft hyphens,
/// zero width spaces, direction marks), turns blanks of any kind into single spaces, and removes
/// them at the ends. `text` must be well-formed.
std::string tidied(const std::string& text);

/// "1 image", "2 images".
std::string counted(std::uint64_t count, const std::string& noun);

/// The size of an image: "640 x 480".
template <typename Integer>
std::string sizeText(Integer width, Integer height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

/// A number with a fixed number of decimals.
std::string fixed(double number, int decimals);

/// A number with at most `digits` significant digits: 0.05, 100, 1e-06.
std::string significant(double number, int digits = 6);

/// The shortest text that reads back as the same double.
std::string shortest(double number);

/// 0.123 as "12.3 %".
std::string percent(double fraction, int decimals = 1);

/// `text` with the letters A to Z replaced by a to z.
std::string lowerCase(std::string text);

/// A form shared by all texts that differ only in case (Unicode case folding). `text` must be
/// well-formed UTF-8.
std::string caseFolded(const std::string& text);

/// A form shared by all texts that a person may have meant as the same: it ignores case, wide
/// letters and ligatures (Unicode NFKC case folding), '_', '-' and blanks, and full stops at the
/// end. `text` must be well-formed UTF-8.
std::string likeness(const std::string& text);

/// Whether `text` begins with `start`.
bool startsWith(const std::string& text, const std::string& start);

/// Whether `text` ends with `end`.
bool endsWith(const std::string& text, const std::string& end);

/// The words with `separator` between them.
std::string listed(const std::vector<std::string>& words, const std::string& separator = ", ");

/// For messages: at most `most` bytes of `text`, whole characters, and '?' for control characters.
/// If `text` is not well-formed UTF-8, '?' also stands for each byte that is not ASCII. "..."
/// stands for what is left out.
std::string printable(const std::string& text, std::size_t most = 80);

/// printable() in single quotes.
std::string inQuotes(const std::string& text, std::size_t most = 80);

}  // namespace place_recognition
