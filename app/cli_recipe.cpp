// Turns the words about repairs, parts and sizes into a Recipe for the file at hand.
#include "app/cli_recipe.h"

#include <algorithm>

#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/project/open_model.h"
#include "core/project/real_size.h"

namespace netwright {
namespace {

/// Where another option would help, the refusal ends with how to ask for it.
std::string hint(const std::shared_ptr<const PolygonSoup>& source, const Recipe& refused, Progress& progress) {
  const auto is_fit = [&](const Recipe& recipe) {
    return make_model(source, recipe, nullptr, progress).dual != nullptr;
  };
  const bool refuses_uneven = refused.uneven == UnevenFaces::Refuse;
  if (refuses_uneven && is_fit({.repairs = refused.repairs, .uneven = UnevenFaces::Split}))
    return " Or add --planarize to move corners a little, or --split to divide the faces.";
  const Recipe usual = usual_repair();
  if (refused.repairs == usual.repairs && !refuses_uneven) return "";
  const bool helps =
      is_fit({.repairs = usual.repairs, .uneven = refuses_uneven ? usual.uneven : refused.uneven});
  return helps ? " Or add --repair." : "";
}

/// The command's words about parts as what the recipe knows them by.
std::vector<int> left_out(const LeaveOut& wanted, const Mesh& whole) {
  const std::vector<ModelPart> parts = parts_of(whole);
  std::vector<int> faces;
  for (const ModelPart& part : parts) {
    if ((wanted.inner && part.is_inner) || (wanted.small && part.is_small)) faces.push_back(part.first_face);
  }
  for (const int number : wanted.numbers) {
    if (number > static_cast<int>(parts.size())) {
      throw Error(ErrorKind::Usage, "There is no part " + std::to_string(number) +
                                        " to leave out: " + whole.name() + " has " +
                                        counted(static_cast<std::int64_t>(parts.size()), "part", "parts") +
                                        "; netwright-cli info lists them.");
    }
    faces.push_back(parts[static_cast<std::size_t>(number) - 1].first_face);
  }
  std::ranges::sort(faces);
  faces.erase(std::ranges::unique(faces).begin(), faces.end());
  return faces;
}

MadeModel fit_model(const std::shared_ptr<const PolygonSoup>& source, const Recipe& recipe,
                    const std::shared_ptr<const ModelStages>& before, Progress& progress) {
  MadeModel made = make_model(source, recipe, before, progress);
  if (!made.dual) throw Error(ErrorKind::Unfit, made.refusal + hint(source, recipe, progress));
  return made;
}

}  // namespace

ToldModel make_as_told(const std::shared_ptr<const PolygonSoup>& source, const UnfoldCommand& command,
                       Progress& progress) {
  Recipe recipe = command.recipe;
  if (command.weld_mm) recipe.repairs.weld_tolerance = *command.weld_mm / guess_unit(*source).in_mm;
  std::shared_ptr<const ModelStages> stages;
  if (command.leave_out.is_any()) {
    Recipe base = recipe;
    base.faces = 0;
    base.merges = false;
    stages = fit_model(source, base, nullptr, progress).stages;
    recipe.left_out = left_out(command.leave_out, *stages->whole);
  }
  return {recipe, std::make_shared<const MadeModel>(fit_model(source, recipe, stages, progress))};
}

std::string size_notice(const UnfoldCommand& command, const PolygonSoup& source, const Mesh& mesh) {
  const RealSize size = real_size(source, mesh);
  if (!size.is_worth_asking() || command.given.size || command.outputs.empty()) return "";
  const std::string usual = std::to_string(static_cast<int>(kUsualHeight));
  return "By its file " + source.name + " is " + real_length_text(size.height_mm) +
         " tall; it is printed as large as a page allows, or " + usual + " mm tall with --height " + usual +
         ".";
}

}  // namespace netwright
