// Malformed video: counted, flagged, and the next good frame is right.
#include "top_profiles.h"

namespace runmark::rtl {
namespace {

template <class Profile>
class RtlTopVideo : public RtlTop<Profile> {};
TYPED_TEST_SUITE(RtlTopVideo, Profiles, ProfileName);

/// One way of being malformed. Every frame of it ends, is flagged, and leaves the next one right.
struct Damage {
  const char* name;
  std::uint32_t counter;  ///< the register that must count it
  void (*apply)(std::vector<VideoBeat>& beats, std::mt19937_64& random);
};
constexpr int bad_width = 231;
constexpr int bad_height = 119;
const std::array damages{
    Damage{"cut off anywhere", RUNMARK_CUT_FRAMES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64& random) {
             beats.resize(1 + random() % ((bad_height - 1) * bad_width));
           }},
    Damage{"cut off after a line", RUNMARK_CUT_FRAMES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64& random) {
             beats.resize((1 + random() % (bad_height - 1)) * bad_width);
           }},
    Damage{"short lines", RUNMARK_BAD_LINES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64& random) {
             for (int n = 0; n < 5; ++n) {
               const auto line = static_cast<std::ptrdiff_t>(random() % (bad_height - 6)) * bad_width;
               beats[static_cast<std::size_t>(line) + 20].last = true;
               beats.erase(beats.begin() + line + 21, beats.begin() + line + bad_width);
             }
           }},
    Damage{"lines of one pixel", RUNMARK_BAD_LINES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64&) {
             for (VideoBeat& beat : beats) beat.last = true;
           }},
    Damage{"long lines", RUNMARK_BAD_LINES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64& random) {
             for (int n = 0; n < 5; ++n) {
               const auto line = static_cast<std::ptrdiff_t>(random() % bad_height) * bad_width;
               beats.insert(beats.begin() + line + 9, 7, {});
             }
           }},
    Damage{"a line's end is missing", RUNMARK_BAD_LINES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64& random) {
             beats[(1 + random() % bad_height) * bad_width - 1].last = false;
           }},
    Damage{"no line ends at all", RUNMARK_BAD_LINES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64&) {
             for (VideoBeat& beat : beats) beat.last = false;
           }},
    Damage{"a start of frame on every line", RUNMARK_CUT_FRAMES,
           [](std::vector<VideoBeat>& beats, std::mt19937_64&) {
             for (std::size_t i = 0; i < 6 * bad_width; i += bad_width) beats[i].user = true;
             beats.resize(6 * bad_width);
           }},
};

TYPED_TEST(RtlTopVideo, IsRightAgainAfterMalformedVideo) {
  std::mt19937_64 random(82);
  const Options options = this->options(bad_width, bad_height);
  std::size_t markers = 0;
  Station<typename TypeParam::Vga> station({95, 80, 20, 100, 100, 8}, options, this->dictionary(),
                                           TypeParam::vga_records,
                                           RUNMARK_CONTROL_READ_RESULTS | RUNMARK_CONTROL_PATIENT);
  for (int round = 0; round < 3; ++round) {
    for (const Damage& damage : damages) {
      std::vector<VideoBeat> beats = video_of(make_scene(this->dictionary(), bad_width, bad_height, random));
      damage.apply(beats, random);
      const auto starts =
          std::count_if(beats.begin(), beats.end(), [](const VideoBeat& b) { return b.user; });
      const std::uint32_t before = station.count(damage.counter);
      station.bench.send(beats);
      const Scene good = make_scene(this->dictionary(), bad_width, bad_height, random);
      station.bench.send(video_of(good));
      for (std::ptrdiff_t i = 0; i < starts; ++i) {
        const auto bad = station.next_frame();
        ASSERT_TRUE(bad) << damage.name;
        EXPECT_TRUE(bad->end.malformed) << damage.name;
      }
      const auto frame = station.next_frame();
      ASSERT_TRUE(frame) << damage.name;
      EXPECT_EQ(difference(*frame, station.plain(good)), "") << "after: " << damage.name;
      EXPECT_FALSE(frame->end.malformed) << "after: " << damage.name;
      EXPECT_GT(station.count(damage.counter), before) << damage.name;
      markers += frame->markers.size();
    }
  }
  EXPECT_GT(markers, 20U);
}

/// Too many lines are dropped without a word: between two frames everything is.
TYPED_TEST(RtlTopVideo, DropsWhatIsBelowTheLastLine) {
  std::mt19937_64 random(85);
  const Options options = this->options(200, 118);
  Station<typename TypeParam::Vga> station({}, options, this->dictionary(), TypeParam::vga_records,
                                           RUNMARK_CONTROL_PATIENT);
  for (int i = 0; i < 2; ++i) {
    const Scene scene = make_scene(this->dictionary(), 200, 118, random);
    std::vector<VideoBeat> beats = video_of(scene);
    beats.insert(beats.end(), beats.begin() + 1, beats.begin() + 5 * 200);
    station.bench.send(beats);
    const auto frame = station.next_frame();
    ASSERT_TRUE(frame);
    EXPECT_EQ(difference(*frame, station.plain(scene)), "");
    EXPECT_FALSE(frame->end.malformed);
  }
}

}  // namespace
}  // namespace runmark::rtl
