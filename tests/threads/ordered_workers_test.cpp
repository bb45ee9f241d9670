// The command line's threads: everything that is pushed is worked on once and put out once, in order,
// whatever the pace of each part; and a failure at the end of the line stops all of it.

#include "ordered_workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <random>
#include <stdexcept>

namespace runmark::cli {
namespace {

struct Item {
  int number = 0;
  std::unique_ptr<int> square;  // made by a worker
};

void dawdle(unsigned chance) {
  if (chance % 7 == 0) std::this_thread::sleep_for(std::chrono::microseconds(chance % 300));
}

TEST(OrderedWorkers, PutOutEverythingOnceAndInOrder) {
  for (const std::size_t count : {1U, 2U, 5U, 16U}) {
    constexpr int items = 400;
    std::vector<int> out;
    std::atomic<int> worked{0};
    OrderedWorkers<Item> workers(
        count,
        [&](std::size_t worker, Item& item) {
          EXPECT_LT(worker, count);
          dawdle(static_cast<unsigned>(item.number) * 2654435761U);
          item.square = std::make_unique<int>(item.number * item.number);
          ++worked;
        },
        [&](Item& item) {
          dawdle(static_cast<unsigned>(item.number));
          ASSERT_TRUE(item.square);
          EXPECT_EQ(*item.square, item.number * item.number);
          out.push_back(item.number);
        },
        [] { FAIL() << "nothing failed"; });
    for (int i = 0; i < items; ++i) ASSERT_TRUE(workers.push({i, nullptr}));
    workers.finish();
    std::vector<int> expected(items);
    for (int i = 0; i < items; ++i) expected[static_cast<std::size_t>(i)] = i;
    EXPECT_EQ(out, expected);
    EXPECT_EQ(worked, items);
  }
}

TEST(OrderedWorkers, StopWhenPuttingOutFails) {
  for (int failing = 0; failing < 40; ++failing) {
    std::atomic<int> told{0};
    int put = 0;
    OrderedWorkers<Item> workers(
        4, [](std::size_t, Item&) {},
        [&](Item& item) {
          if (item.number == failing) throw std::runtime_error("full");
          ++put;
        },
        [&] { ++told; });
    int pushed = 0;
    while (workers.push({pushed, nullptr})) ++pushed;
    EXPECT_THROW(workers.finish(), std::runtime_error);
    EXPECT_EQ(put, failing);
    EXPECT_EQ(told, 1);
    EXPECT_GE(pushed, failing);
  }
}

TEST(OrderedWorkers, EndWithoutHavingBeenFinished) {
  for (int items = 0; items < 30; ++items) {
    std::atomic<int> put{0};
    {
      OrderedWorkers<Item> workers(
          3, [](std::size_t, Item&) {}, [&](Item&) { ++put; }, [] {});
      for (int i = 0; i < items; ++i) ASSERT_TRUE(workers.push({i, nullptr}));
    }
    EXPECT_EQ(put, items);
  }
}

}  // namespace
}  // namespace runmark::cli
