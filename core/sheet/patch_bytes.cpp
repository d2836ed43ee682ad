// Small additions to finished files: a viewer preference appended to a PDF, the resolution put into a PNG.
#include "core/sheet/patch_bytes.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace netwright {

namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

/// The number that follows a word, searched from the end of the file; -1 when there is none.
long number_after_last(const std::string& text, std::string_view word) {
  const std::size_t at = text.rfind(word);
  return at == std::string::npos ? -1 : std::strtol(text.c_str() + at + word.size(), nullptr, 10);
}

std::string padded(std::size_t value, std::size_t digits) {
  std::string text = std::to_string(value);
  return text.size() < digits ? std::string(digits - text.size(), '0') + text : text;
}

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>((value >> shift) & 0xffU);
  return bytes;
}

}  // namespace

std::string with_true_size_printing(std::string pdf) {
  const long table = number_after_last(pdf, "startxref");
  const long size = number_after_last(pdf, "/Size");
  const long root = number_after_last(pdf, "/Root");
  const long info = number_after_last(pdf, "/Info");
  if (table <= 0 || size <= 0 || root <= 0) return pdf;
  const std::string head = "\n" + std::to_string(root) + " 0 obj\n<<";
  const std::size_t start = pdf.find(head);
  const std::size_t end = start == std::string::npos ? start : pdf.find("endobj", start);
  if (end == std::string::npos) return pdf;

  // A new version of the catalogue, then a cross-reference section for it that points back to the first one.
  std::string catalogue = pdf.substr(start + 1, end - start - 1);
  catalogue.insert(head.size() - 1, " /ViewerPreferences << /PrintScaling /None >>\n  ");
  if (pdf.back() != '\n') pdf += '\n';
  const std::size_t object_at = pdf.size();
  pdf += catalogue + "endobj\n";
  const std::size_t table_at = pdf.size();
  pdf += "xref\n" + std::to_string(root) + " 1\n" + padded(object_at, 10) + " 00000 n \n";
  pdf += "trailer\n<< /Size " + std::to_string(size) + " /Root " + std::to_string(root) + " 0 R";
  if (info > 0) pdf += " /Info " + std::to_string(info) + " 0 R";
  pdf += " /Prev " + std::to_string(table) + " >>\nstartxref\n" + std::to_string(table_at) + "\n%%EOF\n";
  return pdf;
}

std::string with_resolution(std::string png, double dpi) {
  constexpr std::size_t kHeaderEnd =
      8 + 4 + 4 + 13 + 4;  // signature, then length, name, data and sum of IHDR
  if (png.size() < kHeaderEnd || !png.starts_with(kPngSignature)) return png;
  const auto per_metre = static_cast<std::uint32_t>(std::lround(dpi / 0.0254));
  const std::string body = "pHYs" + big_endian(per_metre) + big_endian(per_metre) + '\x01';
  png.insert(kHeaderEnd, big_endian(9) + body + big_endian(crc32(body)));
  return png;
}

}  // namespace netwright
