// The chores behind "Open". What a file holds is never trusted before prepare() and the DualGraph have seen
// it.
#include "core/project/open_model.h"

#include <new>

#include "core/base/error.h"
#include "core/mesh/repair.h"

namespace netwright {

OpenedModel open_model(const ModelSource& source, Progress& progress) {
  const bool is_file = !source.path.empty();
  const std::string name = is_file ? source.path.filename().string() : source.name;
  progress.set_phase("Reading " + name);
  const PolygonSoup soup =
      is_file ? read_soup(source.path) : read_soup_bytes(source.name, source.bytes, source.companions);
  OpenedModel model;
  model.path = source.path;
  model.notices = soup.notices;

  progress.set_phase("Checking " + name);
  PreparedModel prepared = prepare(soup);
  if (!prepared.is_fit()) throw Error(ErrorKind::Unfit, prepared.refusal);
  for (const MeshReport::Line& line : prepared.report.lines)
    if (line.kind == MeshReport::Line::Kind::Notice) model.notices.push_back(line.text);

  model.dual = std::make_shared<const DualGraph>(prepared.mesh);
  model.report = std::move(prepared.report);
  return model;
}

std::string sentence_for_current_exception(const std::string& task) {
  try {
    throw;
  } catch (const Error& error) {
    return error.what();
  } catch (const std::bad_alloc&) {
    return task + " needs more memory than there is; close other programs or use a smaller model.";
  } catch (const std::exception& error) {
    return task + " failed: " + error.what() + ".";
  }
}

}  // namespace netwright
