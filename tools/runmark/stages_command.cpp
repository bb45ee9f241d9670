#include "stages_command.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "detector_settings.h"
#include "errors.h"
#include "image_source.h"
#include "output_file.h"
#include "png_file.h"
#include "stage_pictures.h"

namespace runmark::cli {
namespace {

namespace fs = std::filesystem;

struct StagesSettings {
  std::string image;
  std::string folder;
  DetectorSettings detector;
};

void run_stages(const StagesSettings& settings) {
  const std::vector<Dictionary> dictionaries = load_dictionaries(settings.detector);
  const cv::Mat image = read_image(settings.image);
  const StageTrace trace = trace_stages(image, settings.detector.options, dictionaries);

  const fs::path folder(settings.folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw UserError(settings.folder + ": cannot make this folder: " + error.message());
  OutputFile output;
  const auto write = [&](const std::string& name, const std::string& caption, const cv::Mat& picture) {
    const fs::path path = folder / (name + ".png");
    if (fs::equivalent(path, settings.image, error)) {
      throw UserError(path.string() + ": the picture would replace the input");
    }
    write_png(path.string(), picture);
    output.write(path.string() + ": " + caption + '\n');
  };
  const std::vector<StagePicture> pictures = draw_stages(trace);
  for (const StagePicture& picture : pictures) write(picture.name, picture.caption, picture.picture);
  const Pipeline pipeline = settings.detector.options.pipeline;
  const std::string name = pipeline == Pipeline::paper      ? "paper"
                           : pipeline == Pipeline::hardware ? "hardware"
                                                            : "default";
  const std::string title = fs::path(settings.image).filename().string() + ", " + name + " pipeline";
  write("sheet", "all of them", draw_sheet(pictures, trace, title));
  output.close();
}

}  // namespace

void add_stages_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("stages", "Show what each core makes of an image");
  const auto settings = std::make_shared<StagesSettings>();
  command->add_option("IMAGE", settings->image, "The image")->required()->type_name("");
  command->add_option("-o,--output", settings->folder, "Folder for the pictures; made when it is not there")
      ->required()
      ->type_name("DIR");
  add_detector_options(*command, settings->detector);
  command->footer(
      "Writes one PNG for each stage (original, threshold, preprocess, contours, corners, sample grid,\n"
      "markers; the default pipeline's half sizes too) and sheet.png with all of them.");
  command->callback([settings] { run_stages(*settings); });
}

}  // namespace runmark::cli
