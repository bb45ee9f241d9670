#include "bench/side_by_side/run.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "bench/cpu_clock.h"

namespace runmark::bench {
namespace {

// A reader for each contender and each task that the images ask for, made once.
class Readers {
 public:
  Readers(const std::vector<const Contender*>& contenders, const TruthFolder& folder, cv::Size largest)
      : contenders_(contenders), folder_(folder), largest_(largest) {}

  Result<std::vector<std::unique_ptr<Reader>>*> of(const TruthImage& image) {
    auto& readers = readers_[{image.dictionary.value_or(""), image.inverted}];
    if (!readers.empty()) return &readers;
    const auto dictionaries = folder_.dictionaries(image);
    if (!dictionaries) return Error{dictionaries.error()};
    for (const Contender* contender : contenders_) {
      readers.push_back(contender->make({*dictionaries, image.inverted, largest_}));
    }
    return &readers;
  }

 private:
  const std::vector<const Contender*>& contenders_;
  const TruthFolder& folder_;
  cv::Size largest_;
  std::map<std::pair<std::string, bool>, std::vector<std::unique_ptr<Reader>>> readers_;
};

}  // namespace

Result<std::vector<Run>> run_contenders(const std::vector<const Contender*>& contenders,
                                        const std::vector<TruthImage>& truth, const TruthFolder& folder,
                                        int rounds, const std::function<void(std::size_t)>& progress) {
  std::vector<Run> runs;
  for (const Contender* contender : contenders) runs.push_back({std::string(contender->name), {}});
  cv::Size largest;
  for (const TruthImage& image : truth) {
    largest = {std::max(largest.width, image.width), std::max(largest.height, image.height)};
  }
  Readers all(contenders, folder, largest);
  for (std::size_t n = 0; n < truth.size(); ++n) {
    const auto readers = all.of(truth[n]);
    if (!readers) return Error{readers.error()};
    const std::filesystem::path file = folder.image(truth[n]);
    const cv::Mat grey = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
    if (grey.empty()) return Error{file.string() + ": cannot be read as an image"};
    std::vector<std::vector<double>> times(runs.size());
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < runs.size(); ++i) {
        const double start = cpu_milliseconds();
        auto markers = (**readers)[i]->read(grey);
        times[i].push_back(cpu_milliseconds() - start);
        runs[i].observations[truth[n].image].markers = std::move(markers);
      }
    }
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const auto middle = times[i].begin() + static_cast<std::ptrdiff_t>(times[i].size() / 2);
      std::ranges::nth_element(times[i], middle);
      runs[i].observations[truth[n].image].milliseconds = *middle;
    }
    progress(n + 1);
  }
  return runs;
}

bool write_observations(const std::filesystem::path& file, const Observations& observations) {
  using nlohmann::json;
  std::ofstream out(file);
  for (const auto& [image, seen] : observations) {
    json markers = json::array();
    for (const Observation& marker : seen.markers) {
      json corners = json::array();
      for (const Point& p : marker.corners) corners.push_back({p.x, p.y});
      markers.push_back({{"id", marker.id}, {"corners", std::move(corners)}});
    }
    json line{{"image", image}, {"markers", std::move(markers)}};
    if (seen.milliseconds) line["ms"] = *seen.milliseconds;
    out << line << '\n';
  }
  return static_cast<bool>(out.flush());
}

}  // namespace runmark::bench
