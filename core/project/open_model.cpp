// The chores behind "Open". What a file holds is never trusted before prepare() and the DualGraph have seen
// it.
#include "core/project/open_model.h"

#include <new>

#include "core/base/error.h"

namespace netwright {

OpenedModel open_model(const ModelSource& source, Progress& progress) {
  const bool is_file = !source.path.empty();
  const std::string name = is_file ? source.path.filename().string() : source.name;
  progress.set_phase("Reading " + name);
  OpenedModel model;
  model.path = source.path;
  model.source = std::make_shared<const PolygonSoup>(
      is_file ? read_soup(source.path) : read_soup_bytes(source.name, source.bytes, source.companions));
  model.made = make_model(model.source, {}, nullptr, progress);
  if (!model.made.dual && !progress.is_cancelled()) {
    auto repaired = std::make_shared<MadeModel>(make_model(model.source, usual_repair(), nullptr, progress));
    if (!repaired->dual) throw Error(ErrorKind::Unfit, repaired->refusal);
    add_survey(*repaired, progress);
    model.repaired = std::move(repaired);
    model.notices = model.source->notices;
    return model;
  }
  add_survey(model.made, progress);
  for (const MeshReport::Line& line : model.made.report.lines)
    if (line.kind == MeshReport::Line::Kind::Notice) model.notices.push_back(line.text);
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
