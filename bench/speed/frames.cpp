#include "bench/speed/frames.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>

#include "evaluate/truth_folder.h"
#include "render/recipe.h"
#include "render/standard_sets.h"

namespace runmark::bench {

double FrameSet::markers_per_frame() const {
  double markers = 0;
  for (const TimedFrame& frame : frames) markers += frame.markers;
  return frames.empty() ? 0 : markers / static_cast<double>(frames.size());
}

Result<FrameSet> standard_frames(const std::string& name, int scenes, int first) {
  const render::StandardSet* set = render::find_standard_set(name);
  if (set == nullptr) return Error{name + ": no such standard set"};
  const auto dictionary = builtin_dictionary("tag36h11");
  if (!dictionary) return Error{dictionary.error()};
  FrameSet result{std::to_string(set->recipe.width) + "x" + std::to_string(set->recipe.height), {}};
  for (int i = first; i < first + scenes; ++i) {
    const render::RenderedFrame frame =
        render::render(render::make_scene(set->recipe, *dictionary, render::set_seed(name, 0), i));
    // The detectors get memory of OpenCV's alignment, as a camera would give it.
    cv::Mat grey(frame.height, frame.width, CV_8UC1);
    std::ranges::copy(frame.grey, grey.begin<std::uint8_t>());
    result.frames.push_back({grey, {*dictionary}, false, static_cast<int>(frame.truth.markers.size())});
  }
  return result;
}

Result<FrameSet> photo_frames(const std::filesystem::path& file, int count) {
  const auto truth = read_truth(file);
  if (!truth) return Error{truth.error()};
  const TruthFolder folder(file);
  FrameSet result{"photos", {}};
  const std::size_t all = truth->size();
  const std::size_t wanted = std::min(all, static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < wanted; ++i) {
    const TruthImage& image = (*truth)[i * all / wanted];
    const std::string path = folder.image(image).string();
    const cv::Mat grey = cv::imread(path, cv::IMREAD_GRAYSCALE);
    if (grey.empty()) return Error{path + ": cannot be read as an image"};
    auto dictionaries = folder.dictionaries(image);
    if (!dictionaries) return Error{dictionaries.error()};
    result.frames.push_back(
        {grey, *std::move(dictionaries), image.inverted, static_cast<int>(image.markers.size())});
  }
  return result;
}

}  // namespace runmark::bench
