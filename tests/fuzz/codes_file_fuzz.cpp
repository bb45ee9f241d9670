// Any text as a .codes file: it is refused with a line that names what is wrong, or it is a dictionary that
// every part of the library agrees with.

#include <string>

#include "detectors.h"

namespace runmark::fuzz {
namespace {

/// The same dictionary as a file.
std::string written(const Dictionary& dictionary, const std::vector<std::size_t>& symmetric) {
  const int ring = dictionary.border == Border::included ? 0 : 2;
  std::string text =
      std::to_string(dictionary.width - ring) + ' ' + std::to_string(dictionary.corrected_bits);
  constexpr std::array borders{"black", "reversed", "included"};
  text += std::string("\nborder ") + borders[static_cast<std::size_t>(dictionary.border)];
  text += "\ndistance " + std::to_string(dictionary.distance) + "\ncells";
  for (const Cell cell : dictionary.cells)
    text += ' ' + std::to_string(cell.x) + ',' + std::to_string(cell.y);
  if (!symmetric.empty()) text += "\nsymmetric";
  for (const std::size_t id : symmetric) text += ' ' + std::to_string(id);
  for (const std::uint64_t code : dictionary.codes) {
    std::array<char, 24> line{};
    std::snprintf(line.data(), line.size(), "\n%llx", static_cast<unsigned long long>(code));
    text += line.data();
  }
  return text + '\n';
}

void expect_one_line(const std::string& error) {
  expect(!error.empty() && error.find('\n') == std::string::npos, "an error is one line");
}

void run(std::string_view text) {
  const auto read = parse_codes(text, "name");
  if (!read) return expect_one_line(read.error());
  const Dictionary& dictionary = *read;
  expect(!dictionary.codes.empty() && !dictionary.cells.empty() && dictionary.cells.size() <= 64,
         "codes and cells");
  // Written down and read again it is the same.
  std::vector<std::size_t> symmetric;
  std::optional<Dictionary> again;
  for (std::size_t id = 0; id < dictionary.codes.size() && !again; ++id) {
    auto other = parse_codes(written(dictionary, symmetric), "name");
    if (other) {
      again = *std::move(other);
      break;
    }
    // Codes that look the same turned are to be named: the error says which.
    const std::size_t at = other.error().find("code of id ");
    expect(at != std::string::npos, "a dictionary that was read can be written and read");
    symmetric.push_back(std::stoul(other.error().substr(at + 11)));
  }
  if (!again) return;  // all codes are symmetric
  expect(again->codes == dictionary.codes && again->cells == dictionary.cells, "the same codes and cells");
  expect(again->width == dictionary.width && again->border == dictionary.border, "the same shape");
  expect(again->distance == dictionary.distance && again->corrected_bits == dictionary.corrected_bits,
         "the same distances");
  // A detector takes it, and survives a frame.
  Options small;
  small.max_width = 24;
  small.max_height = 24;
  auto made = Detector::create(small, {dictionary});
  expect(static_cast<bool>(made), "what was read from a file suits the default pipeline");
  static const std::vector<std::uint8_t> grey = [] {
    std::vector<std::uint8_t> square(24 * 24, 220);
    for (std::size_t y = 5; y < 19; ++y)
      std::fill_n(square.begin() + static_cast<std::ptrdiff_t>(24 * y) + 5, 14, 20);
    return square;
  }();
  expect(made->detect(ImageView::grey(grey.data(), 24, 24, 24)).status == Status::ok, "a frame is read");
  for (const Pipeline pipeline : {Pipeline::paper, Pipeline::hardware}) {
    small.pipeline = pipeline;
    auto other = Detector::create(small, {dictionary});
    if (!other) expect_one_line(other.error());
  }
}

}  // namespace
}  // namespace runmark::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  runmark::fuzz::run({reinterpret_cast<const char*>(data), size});
  return 0;
}
