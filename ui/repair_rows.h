// The steps of repair as rows, in the question about a broken file and in the model's panel: a switch, what
// the step is about, and how much of it there was and is left.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/project/make_model.h"
#include "ui/ui_state.h"

namespace netwright {

/// What the user chose, and what undo calls it.
struct RecipeChange {
  Recipe recipe;
  std::string label;
};

/// A row for each step that has something to do, as wide as `width`. `wanted` is what switches show; counts
/// are the survey's. `unit_mm`: how long one of the file's units is.
std::optional<RecipeChange> repair_rows(UiState& ui, const Recipe& wanted, const RepairSurvey& survey,
                                        double unit_mm, float width);
[[nodiscard]] bool has_repair_rows(const RepairSurvey& survey);

/// What was done that no row's numbers tell, whole sentences: how far flattening moved corners.
std::vector<std::string> beyond_rows(const ModelStages& stages);

/// Would "repair all" do anything that is not done?
[[nodiscard]] bool can_repair_more(const Recipe& wanted, const RepairSurvey& survey);
/// The recipe with everything in it that usual_repair() does; what goes further stays as it is.
Recipe with_all_repairs(Recipe recipe);

/// "412 → 0"; "412" while nothing is done about them; "none".
std::string repair_count_text(int found, int left);
/// A length in the user's unit as a field has it, two digits that matter: "0.00012 mm", "0.5 mm".
std::string fine_length_format(double length, LengthUnit unit);

}  // namespace netwright
