#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "stream.h"

namespace runmark::hls_form {
namespace {

TEST(HlsStream, HoldsNoMoreThanItsDepth) {
  hls::stream<int, 4> stream("test");
  std::atomic<int> written = 0;
  const std::jthread writer([&] {
    for (int i = 0; i < 100; ++i) {
      stream.write(i);
      ++written;
    }
  });
  for (int i = 0; i < 100; ++i) {
    EXPECT_LE(written, i + 5);
    EXPECT_EQ(stream.read(), i);
  }
  EXPECT_TRUE(stream.empty());
}

TEST(HlsStreamDeathTest, ADeadlockShows) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  hls::patience = std::chrono::milliseconds(50);
  hls::stream<int, 2> stream("narrow");
  EXPECT_DEATH((void)stream.read(), "deadlock: stream narrow stays empty");
  stream.write(1);
  stream.write(2);
  EXPECT_DEATH(stream.write(3), "deadlock: stream narrow stays full");
  hls::patience = std::chrono::milliseconds(20000);
}

}  // namespace
}  // namespace runmark::hls_form
