#include "evaluate_command.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <string>
#include <utility>

#include "errors.h"
#include "evaluate/report.h"
#include "evaluate/truth_folder.h"
#include "runmark/detector.h"

namespace runmark::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  fs::path truth;
  fs::path images;
  fs::path detections;
  std::string pipeline = "default";
  std::string format = "text";
};

Pipeline pipeline_of(const std::string& name) {
  if (name == "paper") return Pipeline::paper;
  return name == "hardware" ? Pipeline::hardware : Pipeline::standard;
}

// Detectors for the images of a truth file: one for each dictionary and polarity, made when first needed.
class Detectors {
 public:
  Detectors(const std::vector<TruthImage>& truth, const TruthFolder& folder, Pipeline pipeline)
      : folder_(folder) {
    options_.pipeline = pipeline;
    options_.max_width = 1;
    options_.max_height = 1;
    for (const TruthImage& image : truth) {
      options_.max_width = std::max(options_.max_width, image.width);
      options_.max_height = std::max(options_.max_height, image.height);
    }
  }

  Detector& of(const TruthImage& image) {
    const std::pair key(image.dictionary.value_or(""), image.inverted);
    if (const auto made = detectors_.find(key); made != detectors_.end()) return made->second;
    Options options = options_;
    options.inverted = image.inverted;
    auto detector = Detector::create(options, value_or_throw(folder_.dictionaries(image)));
    return detectors_.emplace(key, value_or_throw(std::move(detector), image.image)).first->second;
  }

 private:
  const TruthFolder& folder_;
  Options options_;
  std::map<std::pair<std::string, bool>, Detector> detectors_;
};

Observations detect_all(const std::vector<TruthImage>& truth, const TruthFolder& folder, Pipeline pipeline) {
  Detectors detectors(truth, folder, pipeline);
  Observations all;
  for (const TruthImage& image : truth) {
    const std::string file = folder.image(image).string();
    const cv::Mat grey = cv::imread(file, cv::IMREAD_GRAYSCALE);
    if (grey.empty()) throw UserError(file + ": cannot be read as an image");
    Detector& detector = detectors.of(image);
    const auto view =
        ImageView::grey(grey.data, grey.cols, grey.rows, static_cast<std::ptrdiff_t>(grey.step[0]));
    const auto start = std::chrono::steady_clock::now();
    const Detection detection = detector.detect(view);
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    if (detection.status != Status::ok)
      throw UserError(file + ": " + std::string(describe(detection.status)));
    all[image.image] = {observations_of(detection), taken.count()};
  }
  return all;
}

// Detections are filed under the truth's names, which may be the last part of the path they were given.
Observations read_all(const fs::path& file, const std::vector<TruthImage>& truth) {
  std::set<std::string> names;
  for (const TruthImage& image : truth) names.insert(image.image);
  Observations all;
  std::size_t strangers = 0;
  for (auto& [image, seen] : value_or_throw(read_observations(file))) {
    const std::string name = names.contains(image) ? image : fs::path(image).filename().string();
    if (!names.contains(name)) {
      ++strangers;
    } else if (!all.emplace(name, std::move(seen)).second) {
      throw UserError(file.string() + ": " + name + " comes twice");
    }
  }
  if (strangers != 0 && all.empty() && !truth.empty()) {
    throw UserError(file.string() + ": none of its images is in the truth");
  }
  if (strangers != 0) {
    std::cerr << "runmark: " << file.string() << ": " << strangers << " of its images are not in the truth\n";
  }
  return all;
}

void evaluate(const Arguments& arguments) {
  const std::vector<TruthImage> truth = value_or_throw(read_truth(arguments.truth));
  const TruthFolder folder(arguments.truth, arguments.images);
  const Observations seen = arguments.detections.empty()
                                ? detect_all(truth, folder, pipeline_of(arguments.pipeline))
                                : read_all(arguments.detections, truth);
  const Scores scores = score(truth, seen);
  if (arguments.format == "json") write_json(std::cout, scores);
  if (arguments.format == "csv") write_csv(std::cout, scores);
  if (arguments.format == "text") write_text(std::cout, scores);
  if (!std::cout.flush()) throw UserError("standard output: cannot be written");
}

}  // namespace

void add_evaluate_command(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("evaluate", "Scores detections against known truth");
  command->add_option("truth", arguments->truth, "Truth file (truth.json)")->required();
  auto* detections = command->add_option("--detections", arguments->detections,
                                         "Score this file (one JSON object a line, as detect --format jsonl "
                                         "prints) instead of detecting in the images");
  command->add_option("--images", arguments->images, "Folder of the images; default: where the truth file is")
      ->check(CLI::ExistingDirectory)
      ->excludes(detections);
  command->add_option("--pipeline", arguments->pipeline, "paper, hardware or default")
      ->check(CLI::IsMember({"paper", "hardware", "default"}))
      ->excludes(detections);
  command->add_option("--format", arguments->format, "text, json or csv")
      ->check(CLI::IsMember({"text", "json", "csv"}));
  command->callback([arguments] { evaluate(*arguments); });
}

}  // namespace runmark::cli
