#pragma once

#include <string>
#include <vector>

namespace place_recognition {

// Which files of a folder are pictures is decided here, for every verb.

/// Whether a name ends as a picture that can be read does, in any case: png, jpg, jpeg, jpe, jfif,
/// webp, bmp, dib, tif, tiff, pgm, ppm, pbm, pnm, jp2, ras, sr.
bool isPictureName(const std::string& name);

/// Whether an entry of a folder came along from elsewhere: hidden files ('.git', '._1.jpg'), and
/// what macOS, Windows and file servers leave beside those of their users ('__MACOSX', 'Thumbs.db',
/// '@eaDir', 'lost+found').
bool cameAlong(const std::string& name);

/// Whether the names of people's pictures are in order: frame_9 before frame_10.
bool naturalLess(const std::string& a, const std::string& b);

/// What is directly in a folder, each in natural order, symbolic links followed; what came along is
/// left out. A file whose name has no ending, or a number for one, is a picture if it starts as a
/// PNG, JPEG or WebP does.
struct FolderEntries {
  std::vector<std::string> pictures;  ///< names
  std::vector<std::string> folders;   ///< names
  std::vector<std::string> others;    ///< names of other files
  std::vector<std::string> dead;      ///< names of links that lead nowhere
  std::string problem;                ///< why it cannot be opened; else empty
};

FolderEntries entriesOf(const std::string& folder);

/// A picture of a room.
struct PlacedPicture {
  std::string path;
  std::string place;  ///< see placeName(); empty for a picture that lies in no room
};

/// Pictures, and what a person should know of how they were found.
struct FoundPictures {
  std::vector<PlacedPicture> pictures;
  std::vector<std::string> warnings;  ///< a sentence each
};

/// The pictures of a folder of `room/picture`: the first folder below `folder` is the room, in
/// which pictures may lie at any depth. Every room that gives nothing is named in the warnings,
/// with the reason. Throws Error if `folder` cannot be opened.
FoundPictures findRoomPictures(const std::string& folder);

/// All pictures at any depth below `folder`, in natural order of their paths, without places. Every
/// folder that cannot be opened is named in the warnings. Throws as above.
FoundPictures findPicturesBelow(const std::string& folder);

/// Whether `folder` is of `room/picture`, or holds pictures itself and no folder that is. Below a
/// room, only folders with the name of a date are looked into, for a folder of other names may be
/// one of several recordings.
bool holdsRoomPictures(const std::string& folder);

}  // namespace place_recognition
