// Viewer preferences by libqpdf. Streams are kept as cairo packed them, and the file's identity is made from
// what it holds, so that nothing depends on the day.
#include "core/sheet/print_preferences.h"

#include <exception>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFWriter.hh>

#include "core/base/error.h"

namespace netwright {

std::string with_print_preferences(const std::string& pdf, bool is_double_sided) {
  try {
    QPDF file;
    file.processMemoryFile("the drawing", pdf.data(), pdf.size());
    const std::string duplex = is_double_sided ? " /Duplex /DuplexFlipLongEdge" : "";
    file.getRoot().replaceKey("/ViewerPreferences",
                              QPDFObjectHandle::parse("<< /PrintScaling /None" + duplex + " >>"));
    QPDFWriter writer(file);
    writer.setOutputMemory();
    writer.setStreamDataMode(qpdf_s_preserve);
    writer.setDeterministicID(true);
    writer.write();
    const auto bytes = writer.getBufferSharedPointer();
    return {reinterpret_cast<const char*>(bytes->getBuffer()), bytes->getSize()};
  } catch (const std::exception& error) {
    throw Error(ErrorKind::Write, std::string("The PDF cannot be finished: ") + error.what() + ".");
  }
}

}  // namespace netwright
