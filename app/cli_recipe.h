// What options say about a model that can only be understood once its file is read: lengths in mm, parts by
// number, and hints at the options that would help.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/cli_options.h"
#include "core/mesh/model_parts.h"
#include "core/mesh/repair.h"
#include "core/project/make_model.h"

namespace netwright {

/// Makes the mesh by the command's recipe and hands the recipe back as it was understood. Throws Error(Usage)
/// for a part that is not there and Error(Unfit), with the option that cures it, when the model is not fit.
struct ToldModel {
  Recipe recipe;
  std::shared_ptr<const MadeModel> made;
};
ToldModel make_as_told(const std::shared_ptr<const PolygonSoup>& source, const UnfoldCommand& command,
                       Progress& progress);

/// The separate parts as info lists them and --leave-out means them: of the model as it is, or, where that is
/// not fit, as the usual repairs make it. None when there is no mesh at all.
struct ListedParts {
  std::shared_ptr<const Mesh> mesh;
  std::vector<ModelPart> parts;
};
ListedParts listed_parts(const PolygonSoup& source, const PreparedModel& prepared, Progress& progress);

/// One sentence where the file's size can hardly be meant and the command leaves it open; else empty.
std::string size_notice(const UnfoldCommand& command, const PolygonSoup& source, const Mesh& mesh);

}  // namespace netwright
