#include "datasets/jpeg_check.h"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
// After <cstdio>, which it requires but does not include.
#include <jerror.h>
#include <jpeglib.h>

namespace place_recognition {
namespace {

/// Some encoders leave a few bytes between the last block and the end marker. There are more if the
/// blocks continue into another image's data.
constexpr int kMaxExtraneousBytes = 64;

/// An unfilled buffer: at least this many zeros at the end of the file.
constexpr std::size_t kPadding = 16;

/// Records libjpeg's complaints instead of printing them.
struct ErrorManager : jpeg_error_mgr {
  std::jmp_buf on_fatal;
  bool lost = false;         // data of a block is missing or wrong
  bool end_missing = false;  // there is no end marker
};

ErrorManager& errorsOf(j_common_ptr jpeg) { return *static_cast<ErrorManager*>(jpeg->err); }

void onFatal(j_common_ptr jpeg) { std::longjmp(errorsOf(jpeg).on_fatal, 1); }

void onMessage(j_common_ptr jpeg, int level) {
  if (level >= 0) return;  // a trace
  ErrorManager& errors = errorsOf(jpeg);
  switch (errors.msg_code) {
    case JWRN_HIT_MARKER:
    case JWRN_HUFF_BAD_CODE:
    case JWRN_MUST_RESYNC:
      errors.lost = true;
      break;
    case JWRN_EXTRANEOUS_DATA:
      errors.lost |= errors.msg_parm.i[0] > kMaxExtraneousBytes;
      break;
    case JWRN_JPEG_EOF:
      errors.end_missing = true;
      break;
    default:
      break;
  }
}

/// Decodes at one eighth of the size, which takes little longer than reading the coefficients and
/// needs no memory for all of them.
void decodeRows(jpeg_decompress_struct& jpeg) {
  jpeg.scale_num = 1;
  jpeg.scale_denom = 8;
  if (jpeg.jpeg_color_space == JCS_YCbCr) jpeg.out_color_space = JCS_GRAYSCALE;
  jpeg.do_fancy_upsampling = FALSE;
  jpeg.do_block_smoothing = FALSE;
  jpeg.dct_method = JDCT_IFAST;
  jpeg_start_decompress(&jpeg);
  const JDIMENSION width = jpeg.output_width * static_cast<JDIMENSION>(jpeg.output_components);
  const JSAMPARRAY row =
      jpeg.mem->alloc_sarray(reinterpret_cast<j_common_ptr>(&jpeg), JPOOL_IMAGE, width, 1);
  while (jpeg.output_scanline < jpeg.output_height) jpeg_read_scanlines(&jpeg, row, 1);
}

/// Whether there was a scan for every component and, in a progressive image, for every bit.
bool hasAllScans(const jpeg_decompress_struct& jpeg) {
  for (int c = 0; c < jpeg.num_components; ++c) {
    if (jpeg.comp_info[c].quant_table == nullptr) return false;  // set by the first scan
    if (!jpeg.progressive_mode) continue;
    const int* bits = jpeg.coef_bits[c];
    if (std::any_of(bits, bits + DCTSIZE2, [](int missing) { return missing != 0; })) return false;
  }
  return true;
}

/// Everything that libjpeg may leave by longjmp.
bool readAll(jpeg_decompress_struct& jpeg, ErrorManager& errors, const std::uint8_t* bytes,
             std::size_t size) {
  if (setjmp(errors.on_fatal) != 0) return false;
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, bytes, static_cast<unsigned long>(size));
  jpeg_read_header(&jpeg, TRUE);
  decodeRows(jpeg);
  const bool all_scans = hasAllScans(jpeg);
  // The arithmetic decoder silently reads zeros after the end of the data.
  const bool tells_of_end = jpeg.arith_code == FALSE;
  jpeg_finish_decompress(&jpeg);
  return (all_scans && tells_of_end) || !errors.end_missing;
}

}  // namespace

bool isWholeJpeg(const std::uint8_t* bytes, std::size_t size) {
  jpeg_decompress_struct jpeg{};
  ErrorManager errors;
  jpeg.err = jpeg_std_error(&errors);
  errors.error_exit = onFatal;
  errors.emit_message = onMessage;
  bool whole = readAll(jpeg, errors, bytes, size) && !errors.lost;
  jpeg_destroy_decompress(&jpeg);
  if (errors.end_missing) {
    const std::uint8_t* end = bytes + size;
    whole &= std::any_of(end - std::min(size, kPadding), end, [](auto byte) { return byte != 0; });
  }
  return whole;
}

}  // namespace place_recognition
