// One slot between two threads in which the latest value wins: a slow reader never slows the writer, and
// the writer can ask whether its last value was taken before it makes another.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace netwright {

template <class T>
class Mailbox {
 public:
  /// `on_post` is called on the poster's thread after every post, outside the lock; it may be empty.
  explicit Mailbox(std::function<void()> on_post = {}) : on_post_(std::move(on_post)) {}

  /// Replaces whatever lies in the slot; the old value is released outside the lock.
  void post(std::shared_ptr<const T> value) {
    {
      const std::lock_guard lock(mutex_);
      slot_.swap(value);
      ++version_;
    }
    if (on_post_) on_post_();
  }

  /// The newest value, or null when nothing came since the last take.
  std::shared_ptr<const T> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(slot_, nullptr);
  }

  /// True when the last value was taken (or none was ever posted): time to make the next one.
  [[nodiscard]] bool is_empty() const {
    const std::lock_guard lock(mutex_);
    return slot_ == nullptr;
  }

  /// How many values were posted so far.
  [[nodiscard]] std::uint64_t version() const {
    const std::lock_guard lock(mutex_);
    return version_;
  }

 private:
  const std::function<void()> on_post_;
  mutable std::mutex mutex_;
  std::shared_ptr<const T> slot_;
  std::uint64_t version_ = 0;
};

}  // namespace netwright
