#pragma once

#include <string>
#include <vector>

namespace place_recognition {

// Decides for every verb which files of a folder are images.

/// Whether a name has the extension of a readable image format, in upper or lower case: png, jpg,
/// jpeg, jpe, jfif, webp, bmp, dib, tif, tiff, pgm, ppm, pbm, pnm, jp2, ras, sr.
bool isImageName(const std::string& name);

/// Whether an entry of a folder is not the user's own: hidden files ('.git', '._1.jpg'), and what
/// macOS, Windows and file servers add ('__MACOSX', 'Thumbs.db', '@eaDir', 'lost+found').
bool isSystemEntry(const std::string& name);

/// Natural order of file names: frame_9 before frame_10; else by bytes.
bool naturalLess(const std::string& a, const std::string& b);

/// The entries directly in a folder, each kind in natural order; symbolic links are followed, and
/// entries that are not the user's own are omitted. A file without an extension, or with a number
/// as one, is an image if it begins like a PNG, JPEG or WebP image.
struct FolderEntries {
  std::vector<std::string> images;   ///< names
  std::vector<std::string> folders;  ///< names
  std::vector<std::string> others;   ///< names of other files
  std::vector<std::string> dead;     ///< names of broken links
  std::string problem;               ///< why the folder cannot be opened; empty if it can
};

FolderEntries entriesOf(const std::string& folder);

/// An image of a room.
struct PlacedImage {
  std::string path;
  std::string place;  ///< see placeName(); empty for an image outside of any room
};

/// Images, and remarks for a person on how they were found.
struct FoundImages {
  std::vector<PlacedImage> images;
  std::vector<std::string> warnings;  ///< one sentence each
};

/// Finds the images in a folder of `room/image`: the first folder below `folder` is the room, in
/// which images may lie at any depth. The warnings name every room without images, and the reason.
/// Throws Error if `folder` cannot be opened.
FoundImages findRoomImages(const std::string& folder);

/// Finds all images at any depth below `folder`, in natural order of their paths, without places.
/// The warnings name every folder that cannot be opened. Throws as above.
FoundImages findImagesBelow(const std::string& folder);

/// Whether `folder` has the form `room/image`, or contains images itself but no folder of that
/// form. Below a room, only folders named by a date are searched, because a folder with another
/// name may be one of several recordings.
bool holdsRoomImages(const std::string& folder);

}  // namespace place_recognition
