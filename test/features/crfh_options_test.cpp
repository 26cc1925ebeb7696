#include <gtest/gtest.h>

#include <functional>

#include "base/options.h"
#include "error_of.h"
#include "place_recognition/feature_options.h"

namespace place_recognition {
namespace {

void expectRefused(const std::function<void(CrfhOptions&)>& change, const std::string& word) {
  CrfhOptions options;
  change(options);
  const std::string error = errorOf([&] { options.check(); });
  EXPECT_NE(error.find(word), std::string::npos) << "expected " << word << " in: " << error;
}

TEST(CrfhOptions, DefaultsAreTheThesisBest) {
  const CrfhOptions options;
  EXPECT_NO_THROW(options.check());
  EXPECT_EQ(options.variances(), (std::vector<double>{1, 4}));
}

TEST(CrfhOptions, BadFieldsAreNamed) {
  for (const char* name : {"", "x", "Lz", "Lxxx", "Lyx", "C3", "l", "grad", "grad()", "grad(Lx)",
                           "sum(L)", "det(L", "(L)"}) {
    expectRefused([&](CrfhOptions& o) { o.descriptors = {name}; }, "'" + std::string(name) + "'");
  }
  expectRefused([](CrfhOptions& o) { o.descriptors.clear(); }, "descriptors");
  for (double t : {0.0, -1.0, 401.0, 0.009}) {
    expectRefused([&](CrfhOptions& o) { o.scales = {1, t}; }, "scales");
  }
  expectRefused([](CrfhOptions& o) { o.scales.clear(); }, "scales");
  for (double sigma : {0.0, -1.0, 20.5, 0.09}) {
    expectRefused([&](CrfhOptions& o) { o.sigmas = {sigma}; }, "sigmas");
  }
  for (int bins : {0, -1, 65537}) {
    expectRefused([&](CrfhOptions& o) { o.bins = {bins}; }, "bins");
  }
  expectRefused([](CrfhOptions& o) { o.bins = {28, 28}; }, "bins");
  expectRefused([](CrfhOptions& o) { o.bins.clear(); }, "bins");
  expectRefused([](CrfhOptions& o) { o.derivatives = "sobel"; }, "sobel");
  expectRefused([](CrfhOptions& o) { o.levels = "log"; }, "levels");
  expectRefused([](CrfhOptions& o) { o.derivative_range = 0; }, "derivative_range");
  expectRefused([](CrfhOptions& o) { o.half_width = 0; }, "half_width");
  expectRefused([](CrfhOptions& o) { o.border = -1; }, "border");
}

TEST(CrfhOptions, IndicesFit64Bits) {
  CrfhOptions options;
  options.descriptors = {"L"};
  options.scales.assign(13, 1);
  EXPECT_NO_THROW(options.check());  // 28^13 = 6.5e18
  expectRefused(
      [](CrfhOptions& o) {
        o.scales.assign(14, 1);
        o.descriptors = {"L"};
      },
      "64");
  expectRefused(
      [](CrfhOptions& o) {
        o.scales.assign(4, 1);
        o.descriptors = {"L"};
        o.bins = {65536};
      },
      "64");  // 2^64 itself
}

TEST(CrfhOptions, YamlRoundTrip) {
  CrfhOptions options, copy;
  options.descriptors = {"C1xy", "det(R)"};
  options.sigmas = {1.5};
  options.bins = {7, 9};
  readOptions(parseYaml(writeOptions(options), "test"), "", copy);
  EXPECT_EQ(writeOptions(copy), writeOptions(options));
  EXPECT_EQ(copy.variances(), std::vector<double>{2.25});
}

}  // namespace
}  // namespace place_recognition
