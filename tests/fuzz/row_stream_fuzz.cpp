// The streaming calls in any order and with any rows: each is answered as the documentation says, and a frame
// that came row by row gives what the whole frame gives, whatever was done before it.

#include <memory>
#include <vector>

#include "detectors.h"

namespace runmark::fuzz {
namespace {

constexpr int most_side = 80;
constexpr int most_calls = 64;

/// What the calls so far have come to, worked out from the documentation.
struct Expected {
  bool streaming = false;
  int width = 0;
  int height = 0;
  int rows = 0;
  int step = 0;
  PixelFormat format = PixelFormat::grey;
  bool plain = false;  ///< all rows came from the picture, in its order

  [[nodiscard]] Status begin(int w, int h) {
    if (streaming) return Status::wrong_order;
    if (w < 1 || h < 1) return Status::bad_view;
    if (w > most_side || h > most_side) return Status::frame_too_large;
    *this = {true, w, h, 0, 0, PixelFormat::grey, true};
    return Status::ok;
  }
  [[nodiscard]] Status push(const ImageView& view, bool from_picture) {
    if (!streaming) return Status::wrong_order;
    if (view.check() != Status::ok) return Status::bad_view;
    if (view.width != width || view.height > height - rows) return Status::wrong_order;
    if (rows > 0 && (view.step != step || view.format != format)) return Status::bad_view;
    step = view.step;
    format = view.format;
    rows += view.height;
    plain = plain && from_picture;
    return Status::ok;
  }
  [[nodiscard]] Status end() {
    if (!streaming) return Status::wrong_order;
    streaming = false;
    return rows == height ? Status::ok : Status::wrong_order;
  }
};

/// Pixels of every frame of a run: grey, or with `channels` equal bytes a pixel.
struct Picture {
  std::vector<std::uint8_t> bytes;
  int channels = 1;

  [[nodiscard]] ImageView rows(int width, int first, int count) const {
    const std::ptrdiff_t stride = std::ptrdiff_t{most_side} * channels;
    const std::uint8_t* data = bytes.data() + first * stride;
    return channels == 1 ? ImageView::grey(data, width, count, stride)
                         : ImageView::bgr(data, width, count, stride, channels);
  }
};

Picture picture(FuzzedDataProvider& input) {
  Picture result;
  result.channels = input.PickValueInArray({1, 1, 3, 4});
  std::vector<std::uint8_t> grey = input.ConsumeRemainingBytes<std::uint8_t>();
  if (grey.empty()) grey.push_back(0);
  for (int i = 0; i < most_side * most_side; ++i) {
    result.bytes.insert(result.bytes.end(), static_cast<std::size_t>(result.channels),
                        grey[static_cast<std::size_t>(i) % grey.size()]);
  }
  return result;
}

struct Call {
  enum { begin, push, odd_push, end, detect, kinds } kind = begin;
  int a = 0;
  int b = 0;
};

std::vector<Call> calls(FuzzedDataProvider& input) {
  std::vector<Call> result(input.ConsumeIntegralInRange<std::size_t>(1, most_calls));
  for (Call& call : result) {
    call.kind = static_cast<decltype(call.kind)>(input.ConsumeIntegralInRange<int>(0, Call::kinds - 1));
    call.a = input.ConsumeIntegralInRange(-1, most_side + 1);
    call.b = input.ConsumeIntegralInRange(-1, most_side + 1);
  }
  return result;
}

class Run {
 public:
  explicit Run(FuzzedDataProvider& input)
      : options_(options(input, most_side, most_side)),
        codes_(dictionaries(input, options_.pipeline)),
        calls_(calls(input)),
        picture_(picture(input)),
        streamed_(detector(options_, codes_)),
        whole_(detector(options_, codes_)) {}

  void run() {
    for (const Call& call : calls_) make(call);
    // Whatever state that left it in, the next frame is as new.
    if (expected_.streaming) (void)streamed_.end();
    expected_.streaming = false;
    make({Call::begin, most_side, most_side});
    while (expected_.rows < most_side) make({Call::push, 0, 1 + expected_.rows % 7});
    make({Call::end, 0, 0});
    const Detection wanted = whole_.detect(picture_.rows(most_side, 0, most_side));
    expect(wanted.status == Status::ok, "the whole frame is read");
    expect_same(streamed_.markers(), wanted.markers, "the frame after all that is right");
  }

 private:
  void make(const Call& call) {
    switch (call.kind) {
      case Call::begin:
        expect(streamed_.begin(call.a, call.b) == expected_.begin(call.a, call.b), "begin");
        known_.clear();
        break;
      case Call::push:
        push(picture_.rows(expected_.width, expected_.rows,
                           std::min(call.b, expected_.height - expected_.rows)),
             true);
        break;
      case Call::odd_push: {
        ImageView view = picture_.rows(call.a, 0, call.b);
        if (call.a % 4 == 0) view.format = PixelFormat::rgb;
        if (call.b % 8 == 0) view.data = nullptr;
        if (call.a > most_side || call.b > most_side) view.data = nullptr;  // the picture has not so many
        if (view.format != PixelFormat::grey && picture_.channels == 1) view.data = nullptr;
        push(view, false);
        break;
      }
      case Call::end:
        end();
        break;
      case Call::detect:
        detect_in_between(call);
        break;
      default:
        break;
    }
  }

  void push(const ImageView& view, bool from_picture) {
    const Status wanted = expected_.push(view, from_picture);
    if (options_.copy_rows && view.check() == Status::ok) {
      // Those rows are gone as soon as they have been taken.
      std::vector<std::uint8_t> own(view.data, view.row(view.height - 1) + (view.width - 1) * view.step +
                                                   (view.format == PixelFormat::grey ? 1 : 3));
      ImageView copy = view;
      copy.data = own.data();
      expect(streamed_.push_rows(copy) == wanted, "push_rows");
    } else {
      expect(streamed_.push_rows(view) == wanted, "push_rows");
    }
    const auto markers = streamed_.markers();
    expect(markers.size() >= known_.size(), "markers are never withdrawn");
    expect_same(markers.first(known_.size()), known_, "markers never change");
    known_.assign(markers.begin(), markers.end());
  }

  void end() {
    const bool plain = expected_.streaming && expected_.plain;
    const Status wanted = expected_.end();
    expect(streamed_.end() == wanted, "end");
    if (wanted != Status::ok) return;
    expect_sound(streamed_, streamed_.markers(), expected_.width, expected_.height);
    if (!plain) return;
    const Detection same_frame = whole_.detect(picture_.rows(expected_.width, 0, expected_.height));
    expect_same(streamed_.markers(), same_frame.markers, "streamed rows give what the whole frame gives");
  }

  /// `detect` in the middle of a streamed frame is a call out of order; else it is a frame of its own.
  void detect_in_between(const Call& call) {
    const int width = std::clamp(call.a, 1, most_side);
    const int height = std::clamp(call.b, 1, most_side);
    const Detection found = streamed_.detect(picture_.rows(width, 0, height));
    expect(found.status == (expected_.streaming ? Status::wrong_order : Status::ok), "detect");
    if (!expected_.streaming) known_.assign(found.begin(), found.end());
  }

  Options options_;
  std::vector<Dictionary> codes_;
  std::vector<Call> calls_;
  Picture picture_;
  Detector streamed_;
  Detector whole_;
  Expected expected_;
  std::vector<Marker> known_;  // of the frame that is being streamed
};

}  // namespace
}  // namespace runmark::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider input(data, size);
  runmark::fuzz::Run(input).run();
  return 0;
}
