#pragma once

#include <cstdint>
#include <istream>
#include <string>
#include <string_view>

namespace place_recognition {

// The outer format of a model file: a header of 32 bytes with two checksums, the message of
// model.proto, and the numbers: arrays, each as its count (8 bytes) and its elements, in
// little-endian order. Any altered byte is detected before it is interpreted.

/// Maximum size of a model file.
constexpr std::uint64_t kMaxModelBytes = 0x7fffffff;

/// Collects arrays for packContainer().
class NumberWriter {
 public:
  template <typename Vector>
  void operator()(const Vector& numbers) {
    const std::uint64_t count = numbers.size();
    append(&count, sizeof(count));
    append(numbers.data(), count * sizeof(numbers[0]));
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void append(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }

  std::string bytes_;
};

/// Whether a file begins like a model file.
bool startsAsContainer(std::istream& file);

/// A model file with this message and these numbers.
std::string packContainer(std::string_view message, std::string_view numbers);

/// Reads a model file sequentially. Throws Error, a phrase without a source, if it is invalid.
class ContainerReader {
 public:
  /// Reads and checks everything except the numbers. `file` must outlive this.
  explicit ContainerReader(std::istream& file);

  const std::string& message() const { return message_; }
  /// The checksum over every byte of the file, as 8 hexadecimal digits.
  std::string version() const;

  /// Reads the next array directly into its final memory. Trust it only after finish().
  template <typename Vector>
  void operator()(Vector& numbers) {
    numbers = Vector(nextCount(sizeof(numbers[0])));
    read(numbers.data(), numbers.size() * sizeof(numbers[0]));
  }
  /// Checks that there are no more arrays and that those read are unaltered.
  void finish() const;

 private:
  /// The count of the next array, whose elements have `element_bytes` each; the file contains all
  /// of them.
  std::size_t nextCount(std::size_t element_bytes);
  void read(void* data, std::size_t size);

  std::istream& file_;
  std::string message_;
  std::uint32_t version_ = 0;
  std::uint64_t bytes_left_ = 0;        ///< of the numbers
  std::uint32_t numbers_checksum_ = 0;  ///< as stored in the file
  std::uint32_t checksum_ = 0;          ///< of the numbers read
};

}  // namespace place_recognition
