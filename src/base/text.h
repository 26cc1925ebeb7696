#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace place_recognition {

/// The text of a file as UTF-8 without a byte order mark. UTF-16 and UTF-32 are told by their mark,
/// UTF-16 also by the zeros that it has instead of every other letter. Everything else is taken for
/// UTF-8 and left as it is, well formed or not.
std::string toUtf8(const std::string& bytes);

/// The lines of a text, without their ends: those of Unix, Windows and of old Macs.
std::vector<std::string> linesOf(const std::string& text);

/// UTF-8 text composed (Unicode normalization form C), without characters that show nothing (soft
/// hyphens, zero width spaces, marks of direction), its blanks of any kind single ones, and none of
/// them at its ends. `text` must be well formed.
std::string tidied(const std::string& text);

/// "1 image", "2 images".
std::string counted(std::uint64_t count, const std::string& noun);

/// A number with a fixed count of decimals.
std::string fixed(double number, int decimals);

/// 0.123 as "12.3 %".
std::string percent(double fraction, int decimals = 1);

/// `text` with the letters A to Z as a to z.
std::string lowerCase(std::string text);

/// The same for all texts that differ in case only (Unicode case folding). `text` must be well
/// formed UTF-8.
std::string caseFolded(const std::string& text);

/// The same for texts that a person may have written for one another: beside case, wide letters and
/// ligatures (Unicode NFKC case folding), '_', '-' and blanks, and stops at the end do not matter.
/// `text` must be well-formed UTF-8.
std::string likeness(const std::string& text);

/// Whether `text` begins with `start`.
bool startsWith(const std::string& text, const std::string& start);

}  // namespace place_recognition
