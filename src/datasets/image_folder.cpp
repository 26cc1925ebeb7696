#include "datasets/image_folder.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <string_view>
#include <system_error>

#include "base/contains.h"
#include "base/place_name.h"
#include "base/text.h"
#include "datasets/image_file.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 17> kImages{"png", "jpg", "jpeg", "jpe",  "jfif", "webp",
                                                   "bmp", "dib", "tif",  "tiff", "pgm",  "ppm",
                                                   "pbm", "pnm", "jp2",  "ras",  "sr"};

/// Extensions of images and videos that are not read, but are reported if they lie among others.
constexpr std::array<std::string_view, 20> kUnread{
    "gif", "heic", "heif", "avif", "jxl", "svg", "psd", "dng", "cr2", "nef",
    "arw", "raw",  "exr",  "mp4",  "mov", "avi", "mkv", "zip", "tar", "gz"};

/// Extensions after that of an image, for copies kept by editors and for incomplete files.
constexpr std::array<std::string_view, 16> kCopies{
    "tmp",        "temp", "part",   "partial", "filepart", "crdownload", "download", "opdownload",
    "unfinished", "bak",  "backup", "old",     "orig",     "save",       "swp",      "copy"};

constexpr std::array<std::string_view, 18> kCameAlong{
    "__macosx",    "thumbs.db",   "ehthumbs.db",
    "desktop.ini", "@eadir",      "#recycle",
    "#snapshot",   "@recycle",    "$recycle.bin",
    "recycler",    "icon\r",      "system volume information",
    "lost+found",  "found.000",   "temporary items",
    "cvs",         "__pycache__", "network trash folder"};

/// In lower case, without its dot.
std::string endingOf(const std::string& name) {
  const std::string ending = lowerCase(fs::path(name).extension().string());
  return ending.empty() ? "" : ending.substr(1);
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Such as "0017", "0017." and "frame.0017".
bool lacksEnding(const std::string& name) {
  const std::string ending = endingOf(name);
  return std::all_of(ending.begin(), ending.end(), isDigit);
}

/// Such as "0017.jpg.part" and "0017.jpg~".
bool isCopyOfImage(const std::string& name) {
  if (!name.empty() && name.back() == '~') return isImageName(name.substr(0, name.size() - 1));
  return contains(kCopies, endingOf(name)) && isImageName(fs::path(name).stem().string());
}

/// The digits of the number that starts at `i`, without leading zeros; advances `i` past it.
std::string digits(const std::string& text, std::size_t& i) {
  const std::size_t start = i;
  while (i < text.size() && isDigit(text[i])) ++i;
  const std::size_t zeros = std::min(text.find_first_not_of('0', start), i) - start;
  return text.substr(start + zeros, i - start - zeros);
}

/// 2024-05-31, 20240531, 31.05.2024, possibly followed by a time.
bool isDate(const std::string& name) {
  static const std::regex date(
      R"(((19|20)\d\d[-_. ]?[01]?\d[-_. ]?[0-3]?\d|[0-3]?\d[-_. ][01]?\d[-_. ](19|20)\d\d)([-_. T]*\d[-_.:h\d]*)?)");
  return name.size() < 40 && std::regex_match(name, date);
}

bool hasImagesOrDatesOfThem(const fs::path& folder) {
  const FolderEntries entries = entriesOf(folder.string());
  if (!entries.images.empty()) return true;
  return std::any_of(entries.folders.begin(), entries.folders.end(), [&](const std::string& name) {
    return isDate(name) && !entriesOf((folder / name).string()).images.empty();
  });
}

/// "3 .heic files and 1 .gif file", for the names that satisfy `told`.
template <typename Told>
std::string countedByEnding(const std::vector<std::string>& names, Told told) {
  std::map<std::string, int> counts;
  for (const std::string& name : names) {
    if (told(name)) ++counts[endingOf(name)];
  }
  std::string text;
  for (auto next = counts.begin(); next != counts.end(); ++next) {
    const auto& [ending, count] = *next;
    const bool is_last = std::next(next) == counts.end();
    text += text.empty() ? "" : is_last ? " and " : ", ";
    text += std::to_string(count) + (ending.empty() ? "" : " ." + ending) +
            (count == 1 ? " file" : " files");
  }
  return text;
}

/// Collects images below a folder, and problems on the way.
class Search {
 public:
  explicit Search(FoundImages& found) : found_(found) {}

  /// For folders below `folder`, to which no link may lead back.
  Search(FoundImages& found, const fs::path& folder) : found_(found) {
    std::error_code ignored;
    open_.push_back(fs::canonical(folder, ignored));
  }

  /// Adds the contents of `folder` and below; returns why there are none, or an empty text.
  std::string add(const fs::path& folder, const std::string& place) {
    const FolderEntries entries = entriesOf(folder.string());
    if (!entries.problem.empty()) return "it cannot be opened (" + entries.problem + ")";
    std::error_code failure;
    const fs::path real = fs::canonical(folder, failure);
    if (contains(open_, real)) {
      return "it is a link that leads back to " + real.string();
    }
    open_.push_back(real);
    const std::size_t before = found_.images.size();
    addImages(folder, entries, place);
    for (const std::string& inner : entries.folders) {
      const std::string why_not = add(folder / inner, place);
      if (!why_not.empty()) warn(folder / inner, why_not);
    }
    open_.pop_back();
    return found_.images.size() > before ? "" : whyNothing(entries);
  }

  void addImages(const fs::path& folder, const FolderEntries& entries, const std::string& place) {
    for (const std::string& name : entries.images) {
      found_.images.push_back({(folder / name).string(), place});
    }
    for (const std::string& name : entries.dead) {
      warn(folder / name, "it is a broken link");
    }
    if (entries.images.empty()) return;  // whyNothing() reports the others
    const std::string unread = countedByEnding(
        entries.others, [](const std::string& name) { return contains(kUnread, endingOf(name)); });
    if (!unread.empty()) {
      found_.warnings.push_back(folder.string() + ": " + unread +
                                " cannot be read; convert them to PNG or JPEG.");
    }
    const std::string copies = countedByEnding(entries.others, isCopyOfImage);
    if (!copies.empty()) {
      found_.warnings.push_back(
          folder.string() + ": skipped " + copies +
          ", whose names indicate unfinished or older copies of images; rename those that should "
          "be used.");
    }
  }

  void warn(const fs::path& path, const std::string& why) {
    found_.warnings.push_back("Nothing was read from " + path.string() + ": " + why + ".");
  }

 private:
  static std::string whyNothing(const FolderEntries& entries) {
    const std::string others =
        countedByEnding(entries.others, [](const std::string&) { return true; });
    if (!others.empty()) return "it contains " + others + ", which cannot be read as images";
    return entries.folders.empty() && entries.dead.empty() ? "it is empty"
                                                           : "it contains no images";
  }

  FoundImages& found_;
  std::vector<fs::path> open_;  // the current folder and those above it
};

/// The entries of a folder named by a person.
FolderEntries openFolder(const std::string& folder) {
  FolderEntries entries = entriesOf(folder);
  if (entries.problem.empty()) return entries;
  throw Error("Cannot read the folder " + folder + ": " + entries.problem +
              "; check the path and its permissions.");
}

}  // namespace

bool isImageName(const std::string& name) { return contains(kImages, endingOf(name)); }

bool isSystemEntry(const std::string& name) {
  return name.empty() || name[0] == '.' || contains(kCameAlong, lowerCase(name));
}

bool naturalLess(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      const std::string x = digits(a, i), y = digits(b, j);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
    } else {
      const auto x = static_cast<unsigned char>(a[i]), y = static_cast<unsigned char>(b[j]);
      if (x != y) return x < y;
      ++i, ++j;
    }
  }
  if (i < a.size() || j < b.size()) return j < b.size();
  return a < b;  // Equal except for leading zeros.
}

FolderEntries entriesOf(const std::string& folder) {
  FolderEntries entries;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    if (isSystemEntry(name)) continue;
    std::error_code ignored;
    const fs::file_status status = entry->status(ignored);  // follows links
    if (fs::is_directory(status)) {
      entries.folders.push_back(name);
    } else if (fs::is_regular_file(status)) {
      const bool is_image =
          isImageName(name) || (lacksEnding(name) && startsAsImage(entry->path().string()));
      (is_image ? entries.images : entries.others).push_back(name);
    } else if (entry->is_symlink(ignored)) {
      entries.dead.push_back(name);
    }
  }
  if (failure) entries.problem = failure.message();
  for (auto* names : {&entries.images, &entries.folders, &entries.others, &entries.dead}) {
    std::sort(names->begin(), names->end(), naturalLess);
  }
  return entries;
}

FoundImages findRoomImages(const std::string& folder) {
  const FolderEntries entries = openFolder(folder);
  FoundImages found;
  Search search(found, folder);
  search.addImages(folder, entries, "");
  for (const std::string& room : entries.folders) {
    const std::string why_not = search.add(fs::path(folder) / room, placeName(room));
    if (!why_not.empty()) search.warn(fs::path(folder) / room, why_not);
  }
  return found;
}

FoundImages findImagesBelow(const std::string& folder) {
  openFolder(folder);
  FoundImages found;
  Search(found).add(folder, "");
  return found;
}

bool holdsRoomImages(const std::string& folder) {
  const FolderEntries entries = entriesOf(folder);
  const auto anyFolder = [&](auto is) {
    return std::any_of(entries.folders.begin(), entries.folders.end(),
                       [&](const std::string& name) { return is(fs::path(folder) / name); });
  };
  if (anyFolder(hasImagesOrDatesOfThem)) return true;
  return !entries.images.empty() &&
         !anyFolder([](const fs::path& inner) { return holdsRoomImages(inner.string()); });
}

}  // namespace place_recognition
