// Any bytes as one of the JSON files the tools read: truths, detections, and what an earlier run left. The
// first byte says which. Each is refused in one line or taken, and what was taken can be worked with.

#include <sstream>

#include "earlier_run.h"
#include "errors.h"
#include "evaluate/observations.h"
#include "evaluate/report.h"
#include "evaluate/scores.h"
#include "evaluate/truth.h"
#include "memory_file.h"

namespace runmark::fuzz {
namespace {

void expect_one_line(const std::string& error) {
  expect(!error.empty() && error.find('\n') == std::string::npos, "an error is one line");
}

void read_as_truth(const std::string& path) {
  const auto truth = read_truth(path);
  if (!truth) return expect_one_line(truth.error());
  // Scored against itself, as a detector that reports the truth would be.
  Observations perfect;
  for (const TruthImage& image : *truth) {
    for (const TruthMarker& marker : image.markers)
      perfect[image.image].markers.push_back({marker.id, marker.corners});
  }
  std::ostringstream report;
  for (const Observations& seen : {Observations{}, perfect}) {
    const Scores scores = score(*truth, seen);
    write_text(report, scores);
    write_json(report, scores);
    write_csv(report, scores);
  }
}

void read_as_detections(const std::string& path) {
  const auto seen = read_observations(path);
  if (!seen) expect_one_line(seen.error());
}

void read_as_earlier_run(const std::string& path, std::uint64_t size) {
  using cli::InputKind;
  const std::vector<cli::Input> inputs{{InputKind::image, "a.png"},
                                       {InputKind::video, "b.mp4"},
                                       {InputKind::image, "a.png"},
                                       {InputKind::stream, "-"}};
  try {
    const cli::EarlierRun earlier = cli::read_earlier_run(path, inputs);
    expect(earlier.bytes <= size && earlier.inputs.size() == inputs.size(), "no more than was there");
  } catch (const cli::UserError& error) {
    expect(*error.what() != '\0', "an error says something");
  }
}

}  // namespace
}  // namespace runmark::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace runmark::fuzz;
  static MemoryFile file;
  if (size == 0) return 0;
  file.write({data + 1, size - 1});
  if (data[0] % 3 == 0) read_as_truth(file.path());
  if (data[0] % 3 == 1) read_as_detections(file.path());
  if (data[0] % 3 == 2) read_as_earlier_run(file.path(), size - 1);
  return 0;
}
