// Turns the words about repairs, parts and sizes into a Recipe for the file at hand.
#include "app/cli_recipe.h"

#include <algorithm>
#include <unordered_set>

#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/mesh/repair.h"
#include "core/project/open_model.h"
#include "core/project/real_size.h"

namespace netwright {
namespace {

/// Where another option would help, the refusal ends with how to ask for it.
std::string hint(const std::shared_ptr<const PolygonSoup>& source, const Recipe& refused,
                 Progress& progress) {
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

/// The file's faces that these numbers stand for, whatever the command does to the model.
std::unordered_set<int> faces_of_numbers(const std::vector<int>& numbers, const PolygonSoup& source,
                                         Progress& progress) {
  std::unordered_set<int> faces;
  if (numbers.empty()) return faces;
  const ListedParts listed = listed_parts(source, prepare(source), progress);
  for (const int number : numbers) {
    const auto n_parts = static_cast<std::int64_t>(listed.parts.size());
    if (number > n_parts) {
      throw Error(ErrorKind::Usage,
                  "There is no part " + std::to_string(number) + " to leave out: " + source.name + " has " +
                      counted(n_parts, "part", "parts") + "; netwright-cli info lists them.");
    }
    for (const int f : listed.parts[static_cast<std::size_t>(number) - 1].faces)
      faces.insert(listed.mesh->face_source(FaceId(f)));
  }
  faces.erase(-1);  // what repairs filled in is nothing of the file
  return faces;
}

/// The command's words about parts as what the recipe knows them by.
std::vector<int> left_out(const LeaveOut& wanted, const PolygonSoup& source, const Mesh& whole,
                          Progress& progress) {
  const std::unordered_set<int> named = faces_of_numbers(wanted.numbers, source, progress);
  std::vector<int> faces;
  for (const ModelPart& part : parts_of(whole)) {
    const bool is_named =
        std::ranges::any_of(part.faces, [&](int f) { return named.contains(whole.face_source(FaceId(f))); });
    if (is_named || (wanted.inner && part.is_inner) || (wanted.small && part.is_small))
      faces.push_back(part.first_face);
  }
  std::ranges::sort(faces);
  return faces;
}

MadeModel fit_model(const std::shared_ptr<const PolygonSoup>& source, const Recipe& recipe,
                    const std::shared_ptr<const ModelStages>& before, Progress& progress) {
  MadeModel made = make_model(source, recipe, before, progress);
  if (!made.dual) throw Error(ErrorKind::Unfit, made.refusal + hint(source, recipe, progress));
  return made;
}

}  // namespace

ListedParts listed_parts(const PolygonSoup& source, const PreparedModel& prepared, Progress& progress) {
  ListedParts listed;
  listed.mesh = prepared.is_fit() ? prepared.mesh : repair_all(source, {}, progress).prepared.mesh;
  if (listed.mesh) listed.parts = parts_of(*listed.mesh);
  return listed;
}

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
    recipe.left_out = left_out(command.leave_out, *source, *stages->whole, progress);
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
