// The C driver, and the registers as software sees them.
#include <gtest/gtest.h>

#include "Vrunmark_top.h"
#include "Vrunmark_top_hardware.h"
#include "top_frames.h"

namespace runmark::rtl {
namespace {

const Dictionary& dictionary() {
  static const Dictionary it = *builtin_dictionary("DICT_6X6_250");
  return it;
}

class RtlDriver : public testing::Test {
 protected:
  static Options options(int width, int height) { return options_of(Pipeline::paper, width, height); }
  runmark_settings settings(int width, int height, std::uint32_t control) {
    return settings_of(options(width, height), dictionary(), width, height, control);
  }
  void load() { ASSERT_EQ(runmark_load_codes(&device, dictionary().codes.data(), 250), RUNMARK_OK); }
  void TearDown() override { EXPECT_EQ(bench.faults(), std::vector<std::string>{}); }

  TopBench<Vrunmark_top> bench{{100, 90, 10, 70, 100, 3}};
  const runmark_device& device = bench.device();
};

/// Nothing but the registers: settings, dictionary, pixels in, results out, the interrupt.
TEST_F(RtlDriver, FeedsAFrameAndReadsItsMarkers) {
  std::mt19937_64 random(91);
  const runmark_settings s = settings(
      120, 118, RUNMARK_CONTROL_FEED | RUNMARK_CONTROL_READ_RESULTS | RUNMARK_CONTROL_INTERRUPT_FRAME);
  ASSERT_EQ(runmark_configure(&device, &s), RUNMARK_OK);
  load();
  runmark_run(&device, 1);
  Reference reference(options(120, 118), dictionary(), 1023);
  std::size_t markers = 0;
  for (unsigned number = 0; number < 2; ++number) {
    const Scene scene = make_scene(dictionary(), 120, 118, random);
    FrameCollector collector;
    std::optional<FrameOutcome> frame;
    std::size_t fed = 0;
    EXPECT_FALSE(bench.irq());
    for (int step = 0; step < 200000 && !frame; ++step) {
      if (fed < scene.grey.size()) {
        fed += static_cast<std::size_t>(runmark_feed(&device, scene.grey[fed], fed == 0, fed % 120 == 119));
      }
      runmark_record record{};
      while (!frame && runmark_next_result(&device, &record) != 0) frame = collector.add(record, 118, true);
    }
    ASSERT_TRUE(frame);
    EXPECT_EQ(fed, scene.grey.size());
    EXPECT_EQ(difference(*frame, reference.run(scene)), "");
    EXPECT_EQ(frame->end.id, number);
    EXPECT_TRUE(bench.irq());
    EXPECT_EQ(bench.read_register(RUNMARK_STATUS), RUNMARK_STATUS_FRAME_DONE | RUNMARK_STATUS_PIXEL_FREE);
    bench.write_register(RUNMARK_STATUS, RUNMARK_STATUS_FRAME_DONE);
    EXPECT_FALSE(bench.irq());
    markers += frame->markers.size();
  }
  EXPECT_GT(markers, 0U);
}

/// An interrupt for every result: software need not wait for the end of the frame.
TEST_F(RtlDriver, IsInterruptedByAMarkerBeforeTheFrameEnds) {
  std::mt19937_64 random(92);
  const runmark_settings s =
      settings(240, 230, RUNMARK_CONTROL_READ_RESULTS | RUNMARK_CONTROL_INTERRUPT_RESULT);
  ASSERT_EQ(runmark_configure(&device, &s), RUNMARK_OK);
  load();
  runmark_run(&device, 1);
  bench.send(video_of(make_scene(dictionary(), 240, 230, random)));
  for (int clock = 0; clock < 100000 && !bench.irq(); ++clock) bench.tick();
  ASSERT_TRUE(bench.irq());
  EXPECT_GT(bench.video().size(), 240U * 80) << "rows of the frame still to come";
  EXPECT_NE(bench.read_register(RUNMARK_STATUS) & RUNMARK_STATUS_FRAME_OPEN, 0U);
  runmark_record record{};
  ASSERT_EQ(runmark_next_result(&device, &record), 1);
  EXPECT_EQ(record.end_of_frame, 0);
}

/// Stopping takes effect at the next start of frame; what comes then goes by unseen.
TEST_F(RtlDriver, StopsAndRunsBetweenFrames) {
  std::mt19937_64 random(93);
  const runmark_settings s = settings(120, 118, RUNMARK_CONTROL_READ_RESULTS);
  ASSERT_EQ(runmark_configure(&device, &s), RUNMARK_OK);
  load();
  const Scene scene = make_scene(dictionary(), 120, 118, random);
  Reference reference(options(120, 118), dictionary(), 1023);
  const FrameOutcome plain = reference.run(scene);
  const auto finish = [&] {
    for (int clock = 0; clock < 200000 && !bench.video().empty(); ++clock) bench.tick();
    for (int clock = 0; clock < 20000; ++clock) bench.tick();
  };
  bench.send(video_of(scene));  // not running yet
  finish();
  EXPECT_EQ(bench.read_register(RUNMARK_FRAMES), 0U);
  runmark_run(&device, 1);
  bench.send(video_of(scene));
  for (int clock = 0; clock < 5000; ++clock) bench.tick();
  runmark_run(&device, 0);  // in the middle of the frame
  bench.send(video_of(scene));
  finish();
  EXPECT_EQ(bench.read_register(RUNMARK_FRAMES), 1U);
  runmark_run(&device, 1);
  bench.send(video_of(scene));
  finish();
  EXPECT_EQ(bench.read_register(RUNMARK_FRAMES), 2U);
  EXPECT_EQ(bench.read_register(RUNMARK_CUT_FRAMES), 0U);
  FrameCollector collector;
  runmark_record record{};
  int frames = 0;
  while (runmark_next_result(&device, &record) != 0) {
    if (const auto frame = collector.add(record, 118, true)) {
      EXPECT_EQ(difference(*frame, plain), "");
      ++frames;
    }
  }
  EXPECT_EQ(frames, 2);
}

TEST_F(RtlDriver, ReadsBackWhatItWrote) {
  const runmark_settings s = settings(320, 200, RUNMARK_CONTROL_RGB);
  ASSERT_EQ(runmark_configure(&device, &s), RUNMARK_OK);
  load();
  EXPECT_EQ(bench.read_register(RUNMARK_ID), 0x524D4B31U);
  EXPECT_EQ(bench.read_register(RUNMARK_SIZE), 320U | 200U << 16);
  EXPECT_EQ(bench.read_register(RUNMARK_LARGEST), 640U | 480U << 16);
  EXPECT_EQ(bench.read_register(RUNMARK_CAPACITY), 1023U | 1024U << 16);
  EXPECT_EQ(bench.read_register(RUNMARK_THRESHOLD), 128U);
  EXPECT_EQ(bench.read_register(RUNMARK_FILTER), 63U);
  EXPECT_EQ(bench.read_register(RUNMARK_CHAIN_LIMITS), 30U | 4U << 16);
  EXPECT_EQ(bench.read_register(RUNMARK_CORNER_OFFSET), 5U);
  EXPECT_EQ(bench.read_register(RUNMARK_MIN_AREA), 128U);
  EXPECT_EQ(bench.read_register(RUNMARK_MAX_AREA), 640U * 480 * 2);
  EXPECT_EQ(bench.read_register(RUNMARK_MATCH), 250U | 3U << 16);
  EXPECT_EQ(bench.read_register(RUNMARK_CODE_INDEX), 250U);
  EXPECT_EQ(bench.read_register(RUNMARK_FRAME_ADDRESS), AxiMemory::base);
  EXPECT_EQ(bench.read_register(0xFC), 0U) << "no such register";
  EXPECT_EQ(bench.read_register(RUNMARK_STATUS), RUNMARK_STATUS_PIXEL_FREE);
}

TEST_F(RtlDriver, RefusesWhatIsOutOfRange) {
  const runmark_settings good = settings(320, 200, 0);
  const auto with = [&](auto&& change) {
    runmark_settings s = good;
    change(s);
    return runmark_configure(&device, &s);
  };
  EXPECT_EQ(with([](auto&) {}), RUNMARK_OK);
  EXPECT_EQ(with([](auto& s) { s.width = 2; }), RUNMARK_BAD_SIZE);
  EXPECT_EQ(with([](auto& s) { s.width = 641; }), RUNMARK_BAD_SIZE);
  EXPECT_EQ(with([](auto& s) { s.height = 481; }), RUNMARK_BAD_SIZE);
  EXPECT_EQ(with([](auto& s) { s.threshold = 257; }), RUNMARK_BAD_SETTING);
  EXPECT_EQ(with([](auto& s) { s.filter = 64; }), RUNMARK_BAD_SETTING);
  EXPECT_EQ(with([](auto& s) { s.max_turns = 32; }), RUNMARK_BAD_SETTING);
  EXPECT_EQ(with([](auto& s) { s.corner_offset = 0; }), RUNMARK_BAD_SETTING);
  EXPECT_EQ(with([](auto& s) { s.max_errors = 64; }), RUNMARK_BAD_SETTING);
  EXPECT_EQ(with([](auto& s) { s.frame_address += 64; }), RUNMARK_BAD_SETTING);
  EXPECT_EQ(runmark_load_codes(&device, nullptr, 1025), RUNMARK_TOO_MANY_CODES);
  const runmark_device nobody{[](void*, std::uint32_t) { return 0U; },
                              [](void*, std::uint32_t, std::uint32_t) {}, nullptr};
  EXPECT_EQ(runmark_configure(&nobody, &good), RUNMARK_NO_CORE);
}

/// The registers of the hardware profile alone, and a frame through them.
class RtlDriverHardware : public testing::Test {
 protected:
  static Options options(int width, int height) { return options_of(Pipeline::hardware, width, height); }
  runmark_settings settings(std::uint32_t control) {
    return settings_of(options(150, 140), codes, 150, 140, control);
  }
  void TearDown() override { EXPECT_EQ(bench.faults(), std::vector<std::string>{}); }

  const Dictionary codes = *builtin_dictionary("DICT_7X7_50");  // more bits than a word and a half
  TopBench<Vrunmark_top_hardware> bench{{100, 90, 10, 70, 100, 4}};
  const runmark_device& device = bench.device();
};

TEST_F(RtlDriverHardware, FeedsAFrameAndReadsItsMarkers) {
  std::mt19937_64 random(94);
  const runmark_settings s = settings(RUNMARK_CONTROL_FEED | RUNMARK_CONTROL_READ_RESULTS);
  ASSERT_EQ(runmark_configure(&device, &s), RUNMARK_OK);
  ASSERT_EQ(runmark_load_codes(&device, codes.codes.data(), 50), RUNMARK_OK);
  runmark_run(&device, 1);
  const Scene scene = make_scene(codes, 150, 140, random);
  FrameCollector collector;
  std::optional<FrameOutcome> frame;
  std::size_t fed = 0;
  for (int step = 0; step < 200000 && !frame; ++step) {
    if (fed < scene.grey.size()) {
      fed += static_cast<std::size_t>(runmark_feed(&device, scene.grey[fed], fed == 0, fed % 150 == 149));
    }
    runmark_record record{};
    while (!frame && runmark_next_result(&device, &record) != 0) {
      EXPECT_NE(record.fine, record.end_of_frame);
      frame = collector.add(record, 140, false);
    }
  }
  ASSERT_TRUE(frame);
  EXPECT_EQ(difference(*frame, Reference(options(150, 140), codes, 2047).run(scene)), "");
  EXPECT_EQ(frame->markers.size(), 1U);
}

TEST_F(RtlDriverHardware, ReadsBackWhatItWroteAndRefusesWhatIsOutOfRange) {
  const runmark_settings good = settings(0);
  ASSERT_EQ(runmark_configure(&device, &good), RUNMARK_OK);
  EXPECT_EQ(bench.read_register(RUNMARK_PROFILE), 1U);
  EXPECT_EQ(bench.read_register(RUNMARK_CAPACITY), 2047U | 1024U << 16);
  EXPECT_EQ(bench.read_register(RUNMARK_MIN_CONTRAST), 20U);
  EXPECT_EQ(bench.read_register(RUNMARK_SQUARE), 2U | 13U << 16 | 9U << 24);
  EXPECT_EQ(bench.read_register(RUNMARK_MIN_AREA), 51U);
  EXPECT_EQ(bench.read_register(RUNMARK_MAX_AREA), 640U * 480);
  const auto with = [&](auto&& change) {
    runmark_settings s = good;
    change(s);
    return runmark_configure(&device, &s);
  };
  EXPECT_EQ(with([](auto& s) { s.width = 15; }), RUNMARK_BAD_SIZE);
  EXPECT_EQ(with([](auto& s) { s.cells = 5; }), RUNMARK_BAD_SETTING);
  EXPECT_EQ(with([](auto& s) { s.cells = 11; }), RUNMARK_BAD_SETTING);
  EXPECT_EQ(with([](auto& s) { s.min_side = 65535; }), RUNMARK_OK) << "no side is as long";
  EXPECT_EQ(bench.read_register(RUNMARK_SQUARE) & RUNMARK_SQUARE_MIN_SIDE_MASK, 639U);
}

}  // namespace
}  // namespace runmark::rtl
