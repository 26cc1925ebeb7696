#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <opencv2/core.hpp>

#include "features/batched_fft.h"
#include "features/image_fft.h"

namespace place_recognition {
namespace {

using Numbers = BatchedFft::Numbers;
using Complex = std::complex<double>;

constexpr int kLanes = BatchedFft::kLanes;

Complex turn(double fraction) { return std::polar(1.0, 2 * CV_PI * fraction); }

std::vector<Numbers> randomNumbers(int count, int seed) {
  cv::Mat1f values(count, 2 * kLanes);
  cv::RNG random(static_cast<std::uint64_t>(seed));
  random.fill(values, cv::RNG::UNIFORM, -1, 1);
  std::vector<Numbers> numbers(count);
  for (int i = 0; i < count; ++i) {
    std::copy_n(values[i], kLanes, numbers[i].real);
    std::copy_n(values[i] + kLanes, kLanes, numbers[i].imaginary);
  }
  return numbers;
}

cv::Mat1f randomImage(cv::Size size) {
  cv::Mat1f image(size);
  cv::RNG(1).fill(image, cv::RNG::UNIFORM, -1, 1);
  return image;
}

/// The transform by its definition.
Complex transformed(const std::vector<Numbers>& sequences, int lane, int k) {
  const int n = static_cast<int>(sequences.size());
  Complex sum = 0;
  for (int j = 0; j < n; ++j) {
    sum += Complex(sequences[j].real[lane], sequences[j].imaginary[lane]) *
           turn(-static_cast<double>(j * k % n) / n);
  }
  return sum;
}

TEST(BatchedFft, TransformsAsTheDefinitionSays) {
  for (const int length : {1, 2, 3, 4, 6, 8, 9, 12, 16, 27, 32, 54, 64, 72, 243, 288, 384}) {
    std::vector<Numbers> sequences = randomNumbers(length, length), scratch(length);
    const std::vector<Numbers> input = sequences;
    const Numbers* out = BatchedFft(length).transform(sequences.data(), scratch.data());
    for (int k = 0; k < length; ++k) {
      for (const int lane : {0, 5, kLanes - 1}) {
        const Complex expected = transformed(input, lane, k);
        ASSERT_NEAR(out[k].real[lane], expected.real(), 1e-6 * (length + 2)) << length;
        ASSERT_NEAR(out[k].imaginary[lane], expected.imag(), 1e-6 * (length + 2)) << length;
      }
    }
  }
}

TEST(BatchedFft, ItsLengthsAreProductsOfTwosAndThrees) {
  for (const auto& [least, length] : {std::pair(0, 1),
                                      {1, 1},
                                      {5, 6},
                                      {7, 8},
                                      {10, 12},
                                      {13, 16},
                                      {82, 96},
                                      {288, 288},
                                      {289, 324},
                                      {368, 384}}) {
    EXPECT_EQ(BatchedFft::lengthFrom(least), length);
  }
}

const cv::Size kSizes[] = {{1, 1}, {48, 36}, {18, 64}, {96, 54}};

TEST(ImageFft, TransformsAsTheDefinitionSays) {
  for (const cv::Size& size : kSizes) {
    const cv::Mat1f image = randomImage(size);
    ImageFft::Spectrum spectrum;
    ImageFft(size).forward(image, spectrum);
    for (const cv::Point f :
         {cv::Point(0, 0), {size.width - 1, size.height / 2}, {size.width / 3, size.height - 1}}) {
      Complex expected = 0;
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          expected +=
              static_cast<double>(image(y, x)) * turn(static_cast<double>(x * f.x) / size.width +
                                                      static_cast<double>(y * f.y) / size.height);
        }
      }
      const Numbers& numbers = spectrum[f.y / kLanes * size.width + f.x];
      EXPECT_NEAR(numbers.real[f.y % kLanes], expected.real(), 1e-4) << size << f;
      EXPECT_NEAR(numbers.imaginary[f.y % kLanes], expected.imag(), 1e-4) << size << f;
    }
  }
}

TEST(ImageFft, TheInverseGivesTheImageTimesItsPixels) {
  for (const cv::Size& size : kSizes) {
    const cv::Mat1f image = randomImage(size);
    ImageFft fft(size);
    ImageFft::Spectrum spectrum;
    fft.forward(image, spectrum);
    const int columns = size.width - size.width / 3;
    int read = 0;
    fft.inverse(
        [&](int band, Numbers* out) {
          std::copy_n(spectrum.data() + band * size.width, size.width, out);
        },
        columns,
        [&](int first, const Numbers* rows) {
          EXPECT_EQ(first, read);
          read += kLanes;
          for (int y = 0; y < size.height; ++y) {
            for (int x = first; x < std::min(first + kLanes, columns); ++x) {
              ASSERT_NEAR(rows[y].real[x - first] / size.area(), image(y, x), 1e-6);
              ASSERT_NEAR(rows[y].imaginary[x - first] / size.area(), 0, 1e-6);
            }
          }
        });
    EXPECT_GE(read, columns);
  }
}

}  // namespace
}  // namespace place_recognition
