#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>
#include <vector>

#include "place_recognition/error.h"
#include "place_recognition/run.h"
#include "recognition/image_file.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// The number that starts at `i`, without leading zeros, as digits; moves `i` behind it.
std::string digits(const std::string& text, std::size_t& i) {
  const std::size_t start = i;
  while (i < text.size() && isDigit(text[i])) ++i;
  const std::size_t zeros = std::min(text.find_first_not_of('0', start), i) - start;
  return text.substr(start + zeros, i - start - zeros);
}

/// The order in which people number pictures: frame_9 before frame_10.
bool naturalLess(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      const std::string x = digits(a, i), y = digits(b, j);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
    } else {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
    }
  }
  if (i < a.size() || j < b.size()) return j < b.size();
  return a < b;  // Equal but for leading zeros.
}

bool isPicture(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

/// Names of the visible entries of `folder`, in natural order: its pictures or its sub-folders.
std::vector<std::string> namesIn(const fs::path& folder, bool pictures) {
  std::vector<std::string> names;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    const bool wanted = pictures ? isPicture(name) && entry->is_regular_file(ignored)
                                 : entry->is_directory(ignored);
    if (name[0] != '.' && wanted) names.push_back(name);
  }
  if (failure) {
    throw Error("Cannot read the folder " + folder.string() + ": " + failure.message() +
                "; check the path and its permissions.");
  }
  std::sort(names.begin(), names.end(), naturalLess);
  return names;
}

/// What to say of a folder without pictures; points at recordings one level further down.
[[noreturn]] void throwNoPictures(const std::string& folder) {
  for (const std::string& inner : namesIn(folder, false)) {
    for (const std::string& room : namesIn(fs::path(folder) / inner, false)) {
      if (!namesIn(fs::path(folder) / inner / room, true).empty()) {
        throw Error("The folder " + folder +
                    " holds recordings, not rooms; give one of them, as in " +
                    (fs::path(folder) / inner).string() + ".");
      }
    }
  }
  throw Error("The folder " + folder +
              " holds no pictures; arrange them as room/picture.jpg "
              "(png, jpg or jpeg).");
}

class FolderRun : public Run {
 public:
  explicit FolderRun(const std::string& folder) : Run(folder) {
    add(folder, "");
    for (const std::string& room : namesIn(folder, false)) add(fs::path(folder) / room, room);
    if (pictures_.empty()) throwNoPictures(folder);
  }

  bool next(Frame& frame) override {
    if (position_ == pictures_.size()) return false;
    const Picture& picture = pictures_[position_];
    DecodedImage decoded = readImageFile(picture.path);
    frame.image = std::move(decoded.image);
    frame.problem = std::move(decoded.problem);
    frame.place = picture.place;
    frame.stamp = static_cast<double>(position_);
    frame.name = picture.path;
    ++position_;
    return true;
  }

  double fraction() const override {
    return static_cast<double>(position_) / static_cast<double>(pictures_.size());
  }

 private:
  struct Picture {
    std::string path;
    std::string place;
  };

  void add(const fs::path& folder, const std::string& place) {
    for (const std::string& name : namesIn(folder, true)) {
      pictures_.push_back({(folder / name).string(), place});
    }
  }

  std::vector<Picture> pictures_;
  std::size_t position_ = 0;
};

}  // namespace

std::unique_ptr<Run> openFolderRun(const std::string& folder) {
  return std::make_unique<FolderRun>(folder);
}

}  // namespace place_recognition
