// Any bytes as a Y4M or MJPEG stream: frames come, and then an end or one error.

#include "errors.h"
#include "expect.h"
#include "memory_file.h"
#include "stream_source.h"

namespace runmark::fuzz {
namespace {

constexpr int most_frames = 64;

void read(const std::string& path) {
  std::int64_t frames = 0;
  try {
    const auto source = cli::open_stream(path);
    while (const auto frame = source->next()) {
      expect(frame->index == frames && frame->source == path, "frames are numbered");
      expect(frame->view().check() == Status::ok, "a frame can be looked at");
      if (++frames == most_frames) return;
    }
    expect(!source->next(), "an end is an end");
  } catch (const cli::InputError& error) {
    expect(std::string(error.what()).starts_with(path), "an error says where");
  }
}

}  // namespace
}  // namespace runmark::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static runmark::fuzz::MemoryFile file;
  file.write({data, size});
  runmark::fuzz::read(file.path());
  return 0;
}
