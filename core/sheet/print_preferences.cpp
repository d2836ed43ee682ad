// Viewer preferences by libqpdf, through its C interface (clang cannot read the other one as C++20). Streams
// are kept as cairo packed them, and the file's identity is made from what it holds, so that nothing depends
// on the day.
#include "core/sheet/print_preferences.h"

#include <qpdf/qpdf-c.h>

#include <memory>

#include "core/base/error.h"

namespace netwright {

namespace {

struct Cleaner {
  void operator()(_qpdf_data* file) const { qpdf_cleanup(&file); }
};
using File = std::unique_ptr<_qpdf_data, Cleaner>;

void check(const File& file) {
  if (!qpdf_has_error(file.get())) return;
  qpdf_error const error = qpdf_get_error(file.get());
  throw Error(ErrorKind::Write, std::string("The PDF cannot be finished: ") +
                                    qpdf_get_error_full_text(file.get(), error) + ".");
}

const char* words_of(Duplex duplex) {
  switch (duplex) {
    case Duplex::FlipLongEdge:
      return " /Duplex /DuplexFlipLongEdge";
    case Duplex::FlipShortEdge:
      return " /Duplex /DuplexFlipShortEdge";
    default:
      return "";
  }
}

}  // namespace

std::string with_print_preferences(const std::string& pdf, Duplex duplex) {
  const File file(qpdf_init());
  qpdf_silence_errors(file.get());
  qpdf_set_suppress_warnings(file.get(), QPDF_TRUE);
  qpdf_read_memory(file.get(), "the drawing", pdf.data(), pdf.size(), nullptr);
  check(file);
  const std::string preferences = std::string("<< /PrintScaling /None") + words_of(duplex) + " >>";
  qpdf_oh_replace_key(file.get(), qpdf_get_root(file.get()), "/ViewerPreferences",
                      qpdf_oh_parse(file.get(), preferences.c_str()));
  check(file);
  qpdf_init_write_memory(file.get());
  qpdf_set_stream_data_mode(file.get(), qpdf_s_preserve);
  qpdf_set_deterministic_ID(file.get(), QPDF_TRUE);
  qpdf_write(file.get());
  check(file);
  return {reinterpret_cast<const char*>(qpdf_get_buffer(file.get())), qpdf_get_buffer_length(file.get())};
}

}  // namespace netwright
