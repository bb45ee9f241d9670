#include "image_sets.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "evaluate/truth_folder.h"
#include "render/recipe.h"
#include "render/standard_sets.h"

namespace runmark::golden {
namespace {

TruthImage truth_of(const render::FrameTruth& frame) {
  TruthImage image{.width = frame.width, .height = frame.height, .rendered = true};
  image.dictionary = frame.dictionary;
  image.inverted = frame.inverted;
  for (const render::MarkerTruth& m : frame.markers) {
    TruthMarker marker{.id = m.id, .corners = m.corners, .exact_corners = true};
    (m.optional() ? image.maybe : image.markers).push_back(marker);
    image.present_ids.push_back(m.id);
  }
  return image;
}

// (x, y) after a quarter turn clockwise of an image of that height.
Point turned_point(Point p, int height) { return {height - 1 - p.y, p.x}; }

LabelledImage turned_once(const LabelledImage& image) {
  LabelledImage result = image;
  cv::rotate(image.grey, result.grey, cv::ROTATE_90_CLOCKWISE);
  std::swap(result.truth.width, result.truth.height);
  for (auto* markers : {&result.truth.markers, &result.truth.maybe}) {
    for (TruthMarker& marker : *markers) {
      for (Point& p : marker.corners) p = turned_point(p, image.grey.rows);
    }
  }
  return result;
}

}  // namespace

std::vector<LabelledImage> rendered_scenes(const std::string& name, int scenes) {
  const render::StandardSet* set = render::find_standard_set(name);
  const auto dictionary = builtin_dictionary("tag36h11");
  if (set == nullptr || !dictionary) throw std::runtime_error(name + ": no such set");
  std::vector<LabelledImage> images;
  for (int i = 0; i < scenes; ++i) {
    const render::RenderedFrame frame =
        render::render(render::make_scene(set->recipe, *dictionary, render::set_seed(name, 0), i));
    cv::Mat grey(frame.height, frame.width, CV_8UC1);
    std::ranges::copy(frame.grey, grey.begin<std::uint8_t>());
    images.push_back({grey, truth_of(frame.truth), {*dictionary}});
  }
  return images;
}

std::string shared_folder() {
  const char* shared = std::getenv("RUNMARK_SHARED");
  return shared != nullptr ? shared : RUNMARK_SOURCE_DIR "/../shared";
}

std::vector<LabelledImage> photos() {
  const std::filesystem::path file = std::filesystem::path(shared_folder()) / "real-images" / "truth.json";
  if (!std::filesystem::exists(file)) return {};
  const auto truth = read_truth(file);
  if (!truth) throw std::runtime_error(truth.error());
  const TruthFolder folder(file);
  std::vector<LabelledImage> images;
  for (const TruthImage& image : *truth) {
    auto dictionaries = folder.dictionaries(image);
    if (!dictionaries) throw std::runtime_error(dictionaries.error());
    images.push_back(
        {cv::imread(folder.image(image).string(), cv::IMREAD_GRAYSCALE), image, *std::move(dictionaries)});
  }
  return images;
}

LabelledImage turned(const LabelledImage& image, int quarters) {
  return quarters == 0 ? image : turned(turned_once(image), quarters - 1);
}

}  // namespace runmark::golden
