// Any beats as the RTL's video input, with lines, starts and ends where they do not belong, from a camera, to
// a memory and a processor of any manners: every frame that starts also ends, every channel keeps to its
// protocol, and the next good frame is read as the C++ pipeline of the same profile reads it.

#include <Vfuzz_hardware_top.h>
#include <Vfuzz_top.h>
#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <array>

#include "expect.h"
#include "top_frames.h"

namespace runmark::fuzz {
namespace {

using rtl::VideoBeat;

constexpr int most_side = 64;
constexpr std::size_t most_damages = 12;
constexpr std::uint64_t most_cycles = 2000000;

/// The records are so few that they run out; CMakeLists.txt tells the RTL the same.
struct Paper {
  using Model = Vfuzz_top;
  static constexpr Pipeline pipeline = Pipeline::paper;
  static constexpr std::size_t records = 40;
  static constexpr int least_width = 3;
};
struct Hardware {
  using Model = Vfuzz_hardware_top;
  static constexpr Pipeline pipeline = Pipeline::hardware;
  static constexpr std::size_t records = 60;
  static constexpr int least_width = 16;
};

const Dictionary& dictionary(bool lax) {
  static const std::array<Dictionary, 2> both = [] {
    const Dictionary strict = *builtin_dictionary("DICT_6X6_50");
    return std::array{strict, rtl::made_lax(strict)};
  }();
  return both[lax ? 1 : 0];
}

template <class Profile>
Options options(FuzzedDataProvider& input) {
  Options options;
  options.pipeline = Profile::pipeline;
  options.max_width = input.ConsumeIntegralInRange(Profile::least_width, most_side);
  options.max_height = input.ConsumeIntegralInRange(3, most_side);
  options.inverted = input.ConsumeBool();
  options.above_is_dark = input.ConsumeBool();
  options.connectivity = input.PickValueInArray({Connectivity::four, Connectivity::eight});
  options.filter = input.PickValueInArray({filter_none, filter_lone_hole, filter_standard, filter_all});
  options.fixed_threshold = input.ConsumeIntegralInRange(0, 256);
  options.corner_offset = input.ConsumeIntegralInRange(1, 20);
  options.min_marker_size = input.ConsumeIntegralInRange(0, 20);
  return options;
}

rtl::Manners manners(FuzzedDataProvider& input) {
  rtl::Manners manners;
  for (int* share : {&manners.video, &manners.memory, &manners.bus, &manners.results})
    *share = input.ConsumeIntegralInRange(2, 100);  // queues fill up where a partner is slow
  manners.latency = input.ConsumeIntegralInRange(1, 400);
  manners.seed = input.ConsumeIntegral<std::uint8_t>();
  return manners;
}

/// The given bytes again and again.
rtl::Scene scene(int width, int height, const std::vector<std::uint8_t>& bytes) {
  rtl::Scene scene{width, height, 0, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height))};
  for (std::size_t i = 0; i < scene.grey.size(); ++i) scene.grey[i] = bytes[i % bytes.size()];
  return scene;
}

/// Something that a broken or unplugged camera does to the beats from some place on.
struct Damage {
  enum Kind : std::uint8_t { lose, repeat, toggle_user, toggle_lasts, cut_off, kMaxValue = cut_off };
  Kind kind = lose;
  std::size_t at = 0;
  std::size_t count = 0;

  void apply(std::vector<VideoBeat>& beats) const {
    if (beats.empty()) return;
    const std::size_t first = at % beats.size();
    const auto begin = beats.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(count, beats.size() - first));
    switch (kind) {
      case lose:
        beats.erase(begin, end);
        break;
      case repeat:
        beats.insert(begin, count, *begin);
        break;
      case toggle_user:
        begin->user = !begin->user;
        break;
      case toggle_lasts:
        for (auto beat = begin; beat != end; ++beat) beat->last = !beat->last;
        break;
      case cut_off:
        beats.erase(begin, beats.end());
        break;
    }
  }
};

std::vector<Damage> damages(FuzzedDataProvider& input) {
  std::vector<Damage> result(input.ConsumeIntegralInRange<std::size_t>(0, most_damages));
  for (Damage& damage : result) {
    damage.kind = input.ConsumeEnum<Damage::Kind>();
    damage.at = input.ConsumeIntegralInRange<std::size_t>(0, most_side * most_side - 1);
    damage.count = input.ConsumeIntegralInRange<std::size_t>(0, 255);
  }
  return result;
}

template <class Profile>
class Run {
 public:
  explicit Run(FuzzedDataProvider& input)
      : codes_(dictionary(input.ConsumeBool())),
        options_(options<Profile>(input)),
        bench_(manners(input)),
        reference_(options_, codes_, Profile::records) {
    const auto settings =
        rtl::settings_of(options_, codes_, options_.max_width, options_.max_height, RUNMARK_CONTROL_PATIENT);
    expect(runmark_configure(&bench_.device(), &settings) == RUNMARK_OK, "the settings are taken");
    expect(runmark_load_codes(&bench_.device(), codes_.codes.data(),
                              static_cast<unsigned>(codes_.codes.size())) == RUNMARK_OK,
           "the codes are taken");
    filtered_ = settings.filter != 0;
    runmark_run(&bench_.device(), 1);
  }

  void run(FuzzedDataProvider& input) {
    const std::vector<Damage> all_damages = damages(input);
    std::vector<std::uint8_t> pixels = input.ConsumeRemainingBytes<std::uint8_t>();
    if (pixels.empty()) pixels.push_back(0);
    const rtl::Scene picture = scene(options_.max_width, options_.max_height, pixels);
    std::vector<VideoBeat> beats = rtl::video_of(picture);
    for (const Damage& damage : all_damages) damage.apply(beats);
    const auto starts = std::count_if(beats.begin(), beats.end(), [](const VideoBeat& b) { return b.user; });

    bench_.send(beats);
    bench_.send(rtl::video_of(picture));
    for (std::ptrdiff_t i = 0; i < starts; ++i)
      expect(next_frame().end.id == i, "frames that start end in order");
    const rtl::FrameOutcome good = next_frame();
    const std::string difference = rtl::difference(good, reference_.run(picture));
    expect(difference.empty(), difference.c_str());
    expect(!good.end.malformed && !good.end.lost, "a good frame is not flagged");
    expect(good.end.id == starts, "a good frame has the next number");
    expect(bench_.read_register(RUNMARK_FRAMES) == starts + 1, "frames are counted");
    for (const std::string& fault : bench_.faults()) expect(false, fault.c_str());
  }

 private:
  /// Runs the clock until a frame has ended.
  rtl::FrameOutcome next_frame() {
    for (const std::uint64_t until = bench_.cycles() + most_cycles; bench_.cycles() < until;) {
      bench_.tick();
      const auto taken = bench_.take_record();
      if (!taken) continue;
      if (auto outcome = collector_.add(taken->record, options_.max_height, filtered_)) return *outcome;
    }
    expect(false, "a frame ends");
    return {};
  }

  const Dictionary& codes_;
  Options options_;
  rtl::TopBench<typename Profile::Model> bench_;
  rtl::Reference reference_;
  rtl::FrameCollector collector_;
  bool filtered_ = false;
};

}  // namespace
}  // namespace runmark::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider input(data, size);
  using namespace runmark::fuzz;
  if (input.ConsumeBool()) {
    Run<Hardware>(input).run(input);
  } else {
    Run<Paper>(input).run(input);
  }
  return 0;
}
