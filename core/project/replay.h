// Plays the recorded moves of a run, forwards and backwards: start trees and exchanges of hinges. Reaching a
// moment costs two bits a move, so leaps over a million moves take milliseconds; most of a picture's time
// goes into laying out its net.
#pragma once

#include <memory>

#include "core/project/run_log.h"

namespace netwright {

class Replay {
 public:
  explicit Replay(std::shared_ptr<const RunLog> log);

  [[nodiscard]] const RunLog& log() const { return *log_; }
  [[nodiscard]] int position() const { return position_; }

  /// Goes to the picture of this position, forwards or back; past the ends it stops there.
  void seek(int position);

  /// The net of the moment reached, laid out from the result's roots, so that it holds still.
  [[nodiscard]] Net net() const;

  /// How long it should take to be pleasant when it plays by itself, at most kLongest seconds.
  [[nodiscard]] double seconds() const;
  static constexpr double kLongest = 2;

 private:
  void begin_episode(int number);
  void exchange(const HalfedgeId& from, const HalfedgeId& to);

  std::shared_ptr<const RunLog> log_;
  IdVector<EdgeId, char> is_fold_;
  int episode_ = 0;
  int position_ = 0;
};

}  // namespace netwright
