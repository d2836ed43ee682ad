// How a worker's thread tells the window's loop that there is something to take in. The listener may be
// changed at any time from the main thread.
#pragma once

#include <functional>
#include <mutex>
#include <utility>

namespace netwright {

class Bell {
 public:
  void set_listener(std::function<void()> listener) {
    const std::lock_guard lock(mutex_);
    listener_ = std::move(listener);
  }

  /// Calls the listener, if there is one, on the caller's thread.
  void ring() const {
    const std::lock_guard lock(mutex_);
    if (listener_) listener_();
  }

 private:
  mutable std::mutex mutex_;
  std::function<void()> listener_;
};

}  // namespace netwright
