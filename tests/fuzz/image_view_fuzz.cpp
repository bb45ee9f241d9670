// Views of every size, stride and step, sound ones and others: what is wrong with a view is told, what is
// right is read without touching anything outside of it.

#include <climits>
#include <memory>

#include "detectors.h"
#include "wide_memory.h"

namespace runmark::fuzz {
namespace {

constexpr std::int64_t most_pixels = 1 << 16;

int side(FuzzedDataProvider& input) {
  if (input.ConsumeBool()) return input.ConsumeIntegralInRange(1, 96);
  return input.PickValueInArray({0,   1,   2,    3,    4,     5,     8,     63,      64, 65,     127,
                                 255, 256, 1024, 4095, 65534, 65535, 65536, INT_MAX, -1, INT_MIN});
}

std::int64_t channels_of(const ImageView& view) { return view.format == PixelFormat::grey ? 1 : 3; }

/// What a view's fields come to, worked out anew in wider numbers.
bool sound(const ImageView& view) {
  using Wide = __int128;
  const auto size_of = [](Wide value) { return value < 0 ? -value : value; };
  const Wide channels = channels_of(view);
  const Wide step = size_of(view.step);
  const Wide stride = size_of(view.stride);
  if (view.data == nullptr || step < channels) return false;
  if (view.width < 1 || view.width > 65535 || view.height < 1 || view.height > 65535) return false;
  const bool rows_apart = view.height == 1 || stride >= (view.width - 1) * step + channels;
  const bool columns_apart = stride >= channels && step >= (view.height - 1) * stride + channels;
  return rows_apart || columns_apart;
}

struct Extent {
  std::int64_t first = 0;  ///< of the view's bytes, from `data`
  std::int64_t last = 0;   ///< behind the last one
};

/// Of a sound view with few pixels; nothing when it is larger than any memory.
std::optional<Extent> extent(const ImageView& view) {
  constexpr std::int64_t most = WideMemory::size;
  if (view.height > 1 && (view.stride > most || view.stride < -most)) return {};
  const std::int64_t across = std::int64_t{view.width - 1} * view.step;
  const std::int64_t down = view.height > 1 ? std::int64_t{view.height - 1} * view.stride : 0;
  return Extent{std::min<std::int64_t>(across, 0) + std::min<std::int64_t>(down, 0),
                std::max<std::int64_t>(across, 0) + std::max<std::int64_t>(down, 0) + channels_of(view)};
}

void detect_twice(const Options& options, std::vector<Dictionary> codes, const ImageView& view) {
  Detector reader = detector(options, std::move(codes));
  const std::size_t memory = reader.memory();
  const Detection first = reader.detect(view);
  expect(first.status == Status::ok, "a sound view that fits is read");
  const std::vector<Marker> markers(first.begin(), first.end());
  expect_sound(reader, markers, view.width, view.height);
  const Detection second = reader.detect(view);
  expect(second.status == Status::ok, "again");
  expect_same(second.markers, markers, "the same frame gives the same markers");
  expect(reader.memory() == memory, "a detector's memory does not grow");
}

void run(FuzzedDataProvider& input) {
  static WideMemory wide;
  ImageView view;
  view.format = input.PickValueInArray({PixelFormat::grey, PixelFormat::rgb, PixelFormat::bgr});
  view.width = side(input);
  view.height = side(input);
  view.step =
      input.ConsumeBool()
          ? input.ConsumeIntegralInRange(-8, 8)
          : input.PickValueInArray({1, 3, 255, 4096, -4096, 65536, 1 << 20, -(1 << 20), INT_MAX, INT_MIN});
  const std::int64_t row = (std::int64_t{view.width} - 1) * view.step + channels_of(view);
  view.stride = input.ConsumeBool()
                    ? row + input.ConsumeIntegralInRange(-2, 70)
                    : input.PickValueInArray<std::ptrdiff_t>({0, 1, 3, 4096, 65536, -65536, 1 << 20, 1 << 24,
                                                              PTRDIFF_MAX, PTRDIFF_MIN, INT_MAX});
  if (input.ConsumeBool() && view.stride != PTRDIFF_MIN) view.stride = -view.stride;
  Options chosen = options(input, 1, 1);
  const auto codes = dictionaries(input, chosen.pipeline);
  const bool too_small = input.ConsumeIntegralInRange(0, 15) == 0;
  std::vector<std::uint8_t> pixels = input.ConsumeRemainingBytes<std::uint8_t>();
  if (pixels.empty()) pixels.push_back(0);

  view.data = pixels.data();
  expect((view.check() == Status::ok) == sound(view), "a view is sound or is not");
  if (!sound(view)) {
    Detector reader = detector(chosen, codes);
    expect(reader.detect(view).status == Status::bad_view, "a bad view is refused");
    return;
  }
  if (std::int64_t{view.width} * view.height > most_pixels) return;
  chosen.max_width = std::max(view.width - (too_small ? 1 : 0), 1);
  chosen.max_height = view.height;
  if (view.width > chosen.max_width) {
    expect(detector(chosen, codes).detect(view).status == Status::frame_too_large,
           "a large frame is refused");
    return;
  }
  const auto bytes = extent(view);
  if (!bytes) return;
  const std::int64_t length = bytes->last - bytes->first;
  if (length <= 4 * most_pixels) {
    // Exactly as many bytes as the view has: the sanitizer sees what is read beside them.
    const auto size = static_cast<std::size_t>(length);
    const auto exact = std::make_unique<std::uint8_t[]>(size);
    for (std::size_t i = 0; i < size; ++i) exact[i] = pixels[i % pixels.size()];
    view.data = exact.get() - bytes->first;
    detect_twice(chosen, codes, view);
  } else if (length <= static_cast<std::int64_t>(WideMemory::size)) {
    wide.fill(pixels);
    view.data = wide.begin() - bytes->first;
    detect_twice(chosen, codes, view);
    view.data = wide.end() - bytes->last;
    detect_twice(chosen, codes, view);
  }
}

}  // namespace
}  // namespace runmark::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider input(data, size);
  runmark::fuzz::run(input);
  return 0;
}
