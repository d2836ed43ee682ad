// What the status bar says, in words. Pure text, so that tests can read it without a window.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/counted.h"
#include "core/project/session.h"

namespace netwright {

enum class Tone { Quiet, Working, Good, Bad };

struct Status {
  Tone tone = Tone::Quiet;
  std::string text;      ///< "one piece, proved · 370 faces · 153 moves · 2.4 ms · seed 7"
  std::string in_short;  ///< "one piece, proved": for the header of the net's view
};

/// The truth about the search and the net, at the moment of the call.
Status status_of(const Session& session);

/// "2.4 ms", "0.4 s", "12 s", "2 min 5 s".
std::string duration_text(double seconds);
/// How hard a model will be to unfold, from the moves expected: "easy, about 40 moves".
std::string difficulty_text(double moves);
/// "400 of 12 000 faces"; just "12 000 faces" when that is all of them.
std::string faces_text(std::int64_t faces, std::int64_t all);
/// The simplify slider: 0 is the fewest faces, 1 all of them, logarithmic between.
int faces_of_slider(double t, int fewest, int all);
double slider_of_faces(int faces, int fewest, int all);
/// How long the rest of some work will take, from the share that is done after so many seconds; 0 as long as
/// too little is done to tell.
double seconds_left(double fraction, double elapsed);
/// "12 moves a second", "full speed".
std::string speed_text(double moves_per_second);

/// The speed slider: 0 is one move a second, 1 is full speed (infinity), logarithmic between.
double speed_of_slider(double t);
double slider_of_speed(double moves_per_second);

}  // namespace netwright
