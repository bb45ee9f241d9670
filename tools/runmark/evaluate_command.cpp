#include "evaluate_command.h"

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include "detector_settings.h"
#include "errors.h"
#include "evaluate/report.h"
#include "evaluate/truth_folder.h"
#include "fitting_detector.h"
#include "frame_source.h"
#include "output_file.h"
#include "progress.h"

namespace runmark::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  fs::path truth;
  fs::path images;
  fs::path detections;
  DetectorSettings settings;
  std::string format = "text";
};

// Detectors for the images of a truth file: one for each dictionary and polarity, made when first needed.
class Detectors {
 public:
  Detectors(const TruthFolder& folder, const DetectorSettings& settings)
      : folder_(folder), settings_(settings) {}

  FittingDetector& of(const TruthImage& image) {
    const std::pair key(image.dictionary.value_or(""), image.inverted);
    if (const auto made = detectors_.find(key); made != detectors_.end()) return made->second;
    Options options = settings_.options;
    options.inverted = options.inverted || image.inverted;
    auto dictionaries = settings_.dictionary_names.empty() ? value_or_throw(folder_.dictionaries(image))
                                                           : load_dictionaries(settings_);
    return detectors_.try_emplace(key, options, std::move(dictionaries)).first->second;
  }

 private:
  const TruthFolder& folder_;
  const DetectorSettings& settings_;
  std::map<std::pair<std::string, bool>, FittingDetector> detectors_;
};

Observations detect_all(const std::vector<TruthImage>& truth, const TruthFolder& folder,
                        const DetectorSettings& settings) {
  Detectors detectors(folder, settings);
  Observations all;
  Progress progress;
  for (const TruthImage& image : truth) {
    const std::string file = folder.image(image).string();
    const auto frame = open_source({InputKind::image, file})->next();
    if (!frame) throw UserError(file + ": holds no picture");
    FittingDetector& detector = detectors.of(image);
    const auto start = std::chrono::steady_clock::now();
    const Detection detection = detector.detect(*frame);
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    all[image.image] = {observations_of(detection), taken.count()};
    progress.update(static_cast<std::int64_t>(all.size()),
                    static_cast<double>(all.size()) / static_cast<double>(truth.size()));
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
    print_error(file.string() + ": " + std::to_string(strangers) + " of its images are not in the truth");
  }
  return all;
}

void evaluate(const Arguments& arguments) {
  const std::vector<TruthImage> truth = value_or_throw(read_truth(arguments.truth));
  const TruthFolder folder(arguments.truth, arguments.images);
  const Observations seen = arguments.detections.empty() ? detect_all(truth, folder, arguments.settings)
                                                         : read_all(arguments.detections, truth);
  const Scores scores = score(truth, seen);
  std::ostringstream report;
  if (arguments.format == "json") write_json(report, scores);
  if (arguments.format == "csv") write_csv(report, scores);
  if (arguments.format == "text") write_text(report, scores);
  OutputFile output;
  output.write(report.str());
  output.close();
}

}  // namespace

void add_evaluate_command(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("evaluate", "Scores detections against known truth");
  command->add_option("TRUTH", arguments->truth, "Truth file of the images, see docs/evaluation.md")
      ->required();
  command->add_option(
      "--detections", arguments->detections,
      "Score this file, as detect --format jsonl writes it, instead of detecting in the images");
  command
      ->add_option("--images", arguments->images, "Folder of the images; without it, beside the truth file")
      ->check(CLI::ExistingDirectory);
  command->add_option("--format", arguments->format, "How to print the result")
      ->check(CLI::IsMember({"text", "json", "csv"}));
  add_detector_options(*command, arguments->settings);
  command->get_option("--dict")->description("Look for this dictionary instead of each image's own");
  command->callback([arguments] { evaluate(*arguments); });
}

}  // namespace runmark::cli
