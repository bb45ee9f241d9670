// Very many frames: every frame gives what it gave the first time, and the process holds no more memory at
// the end than after its first thousand frames.
//   soak [--frames N] [--threads N]    prints one JSON object; 1 when something differed or grew

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "render/recipe.h"
#include "render/scene.h"
#include "render/standard_sets.h"
#include "runmark/detector.h"

namespace runmark {
namespace {

struct Settings {
  std::int64_t frames = 20000;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

struct Frame {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> grey;
  [[nodiscard]] ImageView view() const { return ImageView::grey(grey.data(), width, height, width); }
};

Dictionary dictionary(const char* name) { return *builtin_dictionary(name); }

/// Scenes of the standard sets at two sizes, noise, and an empty frame.
std::vector<Frame> make_frames() {
  std::vector<Frame> frames;
  const render::StandardSet* set = render::find_standard_set("vga");
  for (int i = 0; i < 10; ++i) {
    render::Recipe recipe = set->recipe;
    if (i % 2 == 1) {
      recipe.width /= 2;
      recipe.height /= 2;
    }
    const auto scene = render::render(
        render::make_scene(recipe, dictionary(i % 3 == 0 ? "DICT_4X4_50" : "tag36h11"), 77, i));
    frames.push_back({scene.width, scene.height, scene.grey});
  }
  std::mt19937 random(1);
  Frame noise{320, 240, std::vector<std::uint8_t>(std::size_t{320} * 240)};
  for (std::uint8_t& grey : noise.grey) grey = (random() & 1U) != 0 ? 255 : 0;
  frames.push_back(noise);
  frames.push_back({320, 240, std::vector<std::uint8_t>(std::size_t{320} * 240, 128)});
  return frames;
}

/// Everything a frame gave, in one number.
std::uint64_t digest(const Detection& found, const FrameStats& stats) {
  std::uint64_t sum = 0;
  const auto add = [&sum](std::uint64_t value) { sum = (sum ^ value) * 0x9E3779B97F4A7C15U + (sum >> 29U); };
  add(static_cast<std::uint64_t>(found.status));
  for (const Marker& marker : found) {
    add(std::hash<std::string_view>()(marker.dictionary));
    add(static_cast<std::uint64_t>(marker.id));
    add(static_cast<std::uint64_t>(marker.hamming));
    add(static_cast<std::uint64_t>(marker.row));
    add(std::bit_cast<std::uint32_t>(marker.margin));
    for (const Point& corner : marker.corners) {
      add(std::bit_cast<std::uint64_t>(corner.x));
      add(std::bit_cast<std::uint64_t>(corner.y));
    }
  }
  for (const std::uint64_t count : {stats.pixels, stats.crack_runs, stats.closed_chains, stats.quads,
                                    stats.records_peak, stats.dropped_chains, stats.dropped_markers}) {
    add(count);
  }
  return sum;
}

Detection streamed(Detector& detector, const Frame& frame, int chunk) {
  Status status = detector.begin(frame.width, frame.height);
  for (int y = 0; y < frame.height && status == Status::ok; y += chunk) {
    status = detector.push_rows(frame.view().rows(y, std::min(chunk, frame.height - y)));
  }
  const Status ended = detector.end();
  return {status == Status::ok ? ended : status, detector.markers()};
}

std::size_t resident_bytes() {
  std::size_t total = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

struct Outcome {
  std::atomic<std::int64_t> different{0};
  std::atomic<std::int64_t> done{0};
  std::uint64_t first = 0;  ///< digest of all frames as they were found first
  std::uint64_t last = 0;   ///< and last
};

/// One thread's share: a detector of each pipeline over all frames in turn, whole and row by row.
void soak(const std::vector<Frame>& frames, std::int64_t count, unsigned thread, Outcome& outcome) {
  std::vector<Detector> detectors;
  for (const Pipeline pipeline :
       {Pipeline::standard, Pipeline::standard, Pipeline::hardware, Pipeline::paper}) {
    std::vector<Dictionary> codes{dictionary("tag36h11")};
    if (pipeline == Pipeline::standard) codes.push_back(dictionary("DICT_4X4_50"));
    Options options{.pipeline = pipeline, .max_width = 640, .max_height = 480};
    options.inverted = detectors.size() == 1;
    auto made = Detector::create(options, std::move(codes));
    if (!made) std::abort();  // these options are all within their ranges
    detectors.push_back(*std::move(made));
  }
  const std::size_t kinds = detectors.size() * frames.size();
  std::vector<std::uint64_t> first(kinds);
  std::vector<std::uint64_t> last(kinds);
  for (std::int64_t i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i) % kinds;
    Detector& detector = detectors[at % detectors.size()];
    const Frame& frame = frames[at / detectors.size()];
    // Another way each time round: what is found must not depend on it.
    const auto round = static_cast<int>(i / static_cast<std::int64_t>(kinds));
    const Detection found =
        round % 4 == 3 ? streamed(detector, frame, 1 + round % 50) : detector.detect(frame.view());
    last[at] = digest(found, detector.stats());
    if (round == 0) first[at] = last[at];
    if (last[at] != first[at]) ++outcome.different;
    ++outcome.done;
  }
  if (thread > 0) return;
  for (std::size_t at = 0; at < kinds; ++at) {
    outcome.first = outcome.first * 31 + first[at];
    outcome.last = outcome.last * 31 + last[at];
  }
}

int run(const Settings& settings) {
  const std::vector<Frame> frames = make_frames();
  Outcome outcome;
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::thread> threads;
  const std::int64_t each = (settings.frames + settings.threads - 1) / settings.threads;
  for (unsigned t = 0; t < settings.threads; ++t) {
    threads.emplace_back([&, t] { soak(frames, each, t, outcome); });
  }
  // Memory from when every thread has seen every frame, until the end.
  const std::int64_t warm = std::min<std::int64_t>(1000LL * settings.threads, settings.frames / 4);
  std::size_t held_first = 0;
  std::size_t held_most = 0;
  while (outcome.done < each * settings.threads) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    if (outcome.done < warm) continue;
    const std::size_t held = resident_bytes();
    if (held_first == 0) held_first = held;
    held_most = std::max(held_most, held);
  }
  for (std::thread& thread : threads) thread.join();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  const std::size_t grown = held_most - held_first;
  std::printf(
      "{\"frames\":%lld,\"threads\":%u,\"seconds\":%.1f,\"different\":%lld,\"digest_first\":\"%016llx\","
      "\"digest_last\":\"%016llx\",\"resident_bytes\":%zu,\"grown_bytes\":%zu}\n",
      static_cast<long long>(outcome.done), settings.threads, time.count(),
      static_cast<long long>(outcome.different), static_cast<unsigned long long>(outcome.first),
      static_cast<unsigned long long>(outcome.last), held_first, grown);
  // Nothing is allocated a frame, but a page of a stack or of the library may be touched for the first time
  // late.
#ifdef RUNMARK_SANITIZED
  constexpr std::size_t most_growth = SIZE_MAX;  // a sanitizer keeps what was freed
#else
  constexpr std::size_t most_growth = 256 * 1024;
#endif
  return outcome.different == 0 && outcome.first == outcome.last && grown <= most_growth ? 0 : 1;
}

}  // namespace
}  // namespace runmark

int main(int argc, char** argv) {
  runmark::Settings settings;
  for (int i = 1; i < argc; i += 2) {
    const long long value = i + 1 < argc ? std::atoll(argv[i + 1]) : 0;
    if (std::strcmp(argv[i], "--frames") == 0 && value > 0) {
      settings.frames = value;
    } else if (std::strcmp(argv[i], "--threads") == 0 && value > 0 && value <= 1024) {
      settings.threads = static_cast<unsigned>(value);
    } else {
      std::fprintf(stderr, "soak: usage: soak [--frames N] [--threads N]\n");
      return 2;
    }
  }
  return runmark::run(settings);
}
