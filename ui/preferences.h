// What people set once and for all: the dialog's rows, and carrying the settings over to the session.
#pragma once

#include "core/solve/aims.h"
#include "ui/ui_state.h"

namespace netwright {

/// What nets are polished for.
PolishSettings polish_of(const Settings& settings);

/// Hands the session what it should know of the settings: threads, streams, time limit, paper of new models.
void apply_preferences(Session& session, const Settings& settings);

/// The rows of the preferences dialog, into the present window; every change counts at once.
void preference_rows(UiContext& context);

}  // namespace netwright
