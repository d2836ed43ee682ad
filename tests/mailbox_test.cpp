// The mailbox between two threads: the latest value wins, nothing is read twice, the bell rings at every
// post.
#include "core/base/mailbox.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace netwright {
namespace {

TEST(Mailbox, IsEmptyUntilSomethingIsPosted) {
  Mailbox<int> box;
  EXPECT_TRUE(box.is_empty());
  EXPECT_EQ(box.take(), nullptr);
  EXPECT_EQ(box.version(), 0u);
}

TEST(Mailbox, HandsOutTheLatestValueOnce) {
  Mailbox<int> box;
  box.post(std::make_shared<int>(1));
  box.post(std::make_shared<int>(2));
  EXPECT_FALSE(box.is_empty());
  const auto value = box.take();
  ASSERT_NE(value, nullptr);
  EXPECT_EQ(*value, 2);
  EXPECT_EQ(box.take(), nullptr);
  EXPECT_TRUE(box.is_empty());
  EXPECT_EQ(box.version(), 2u);
}

TEST(Mailbox, ReleasesAValueThatWasReplaced) {
  Mailbox<int> box;
  auto first = std::make_shared<int>(1);
  const std::weak_ptr<int> watched = first;
  box.post(std::move(first));
  box.post(std::make_shared<int>(2));
  EXPECT_TRUE(watched.expired());
}

TEST(Mailbox, RingsAfterThePostSoThatTheListenerFindsTheValue) {
  int seen = 0;
  Mailbox<int>* reader = nullptr;
  Mailbox<int> box([&] { seen = *reader->take(); });
  reader = &box;
  box.post(std::make_shared<int>(7));
  EXPECT_EQ(seen, 7);
}

TEST(Mailbox, GivesAReaderRisingValuesAndAlwaysTheLast) {
  constexpr int kLast = 20000;
  Mailbox<int> box;
  std::jthread writer([&box] {
    for (int i = 1; i <= kLast; ++i) box.post(std::make_shared<int>(i));
  });
  int latest = 0;
  while (latest < kLast) {
    const auto value = box.take();
    if (!value) {
      std::this_thread::yield();
      continue;
    }
    ASSERT_GT(*value, latest);
    latest = *value;
  }
  EXPECT_EQ(box.version(), static_cast<std::uint64_t>(kLast));
}

TEST(Mailbox, TellsAWriterWhetherItsLastValueWasTaken) {
  Mailbox<int> box;
  std::atomic<int> taken{0};
  std::jthread reader([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      if (box.take()) ++taken;
      std::this_thread::yield();
    }
  });
  int posted = 0;
  while (posted < 500) {
    if (!box.is_empty()) {
      std::this_thread::yield();
      continue;
    }
    box.post(std::make_shared<int>(posted));
    ++posted;
  }
  while (!box.is_empty()) std::this_thread::yield();
  reader.request_stop();
  reader.join();
  EXPECT_EQ(taken.load(), posted);
}

}  // namespace
}  // namespace netwright
