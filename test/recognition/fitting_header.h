#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "recognition/model/model_container.h"

namespace place_recognition {

/// Returns the model file `bytes` with lengths and checksums that match the contents after its
/// header. The length of the message stays as stated in the header if possible.
inline std::string withFittingHeader(std::string bytes) {
  constexpr std::size_t kHeaderSize = 32, kMessageSizeAt = 12;
  bytes.resize(std::max(bytes.size(), kHeaderSize));
  std::uint32_t message_size = 0;
  std::memcpy(&message_size, &bytes[kMessageSizeAt], sizeof(message_size));
  const std::size_t end = std::min(bytes.size(), kHeaderSize + message_size);
  return packContainer(bytes.substr(kHeaderSize, end - kHeaderSize), bytes.substr(end));
}

}  // namespace place_recognition
