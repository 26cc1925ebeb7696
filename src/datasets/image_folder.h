#pragma once

#include <string>
#include <vector>

namespace place_recognition {

// Which files of a folder are images is decided here, for every verb.

/// Whether a name ends as an image that can be read does, in any case: png, jpg, jpeg, jpe, jfif,
/// webp, bmp, dib, tif, tiff, pgm, ppm, pbm, pnm, jp2, ras, sr.
bool isImageName(const std::string& name);

/// Whether an entry of a folder came along from elsewhere: hidden files ('.git', '._1.jpg'), and
/// what macOS, Windows and file servers leave beside those of their users ('__MACOSX', 'Thumbs.db',
/// '@eaDir', 'lost+found').
bool cameAlong(const std::string& name);

/// Whether the names of people's images are in order: frame_9 before frame_10.
bool naturalLess(const std::string& a, const std::string& b);

/// What is directly in a folder, each in natural order, symbolic links followed; what came along is
/// left out. A file whose name has no ending, or a number for one, is an image if it starts as a
/// PNG, JPEG or WebP does.
struct FolderEntries {
  std::vector<std::string> images;   ///< names
  std::vector<std::string> folders;  ///< names
  std::vector<std::string> others;   ///< names of other files
  std::vector<std::string> dead;     ///< names of links that lead nowhere
  std::string problem;               ///< why it cannot be opened; else empty
};

FolderEntries entriesOf(const std::string& folder);

/// An image of a room.
struct PlacedImage {
  std::string path;
  std::string place;  ///< see placeName(); empty for an image that lies in no room
};

/// Images, and what a person should know of how they were found.
struct FoundImages {
  std::vector<PlacedImage> images;
  std::vector<std::string> warnings;  ///< a sentence each
};

/// The images of a folder of `room/image`: the first folder below `folder` is the room, in
/// which images may lie at any depth. Every room that gives nothing is named in the warnings,
/// with the reason. Throws Error if `folder` cannot be opened.
FoundImages findRoomImages(const std::string& folder);

/// All images at any depth below `folder`, in natural order of their paths, without places. Every
/// folder that cannot be opened is named in the warnings. Throws as above.
FoundImages findImagesBelow(const std::string& folder);

/// Whether `folder` is of `room/image`, or holds images itself and no folder that is. Below a
/// room, only folders with the name of a date are looked into, for a folder of other names may be
/// one of several recordings.
bool holdsRoomImages(const std::string& folder);

}  // namespace place_recognition
