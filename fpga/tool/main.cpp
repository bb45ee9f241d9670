// runmark-rtl: the FPGA core as a command.
#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "errors.h"
#include "hardware.h"
#include "image_source.h"
#include "input.h"
#include "library_messages.h"
#include "marker_format.h"
#include "pipeline/hardware_pipeline.h"
#include "pipeline/paper_pipeline.h"
#include "runmark/version.h"

namespace runmark::rtl {
namespace {

using cli::InputError;
using cli::UserError;

struct Command {
  Command() { hardware.options.pipeline = Pipeline::paper; }

  std::vector<std::string> images;
  std::string dictionary = "tag36h11";
  HardwareSettings hardware;
};

void add_options(CLI::App& app, Command& command) {
  Options& o = command.hardware.options;
  app.add_option("IMAGE", command.images, "Image files, folders of images")->required()->type_name("");
  const std::map<std::string, Pipeline> profiles{{"paper", Pipeline::paper},
                                                 {"hardware", Pipeline::hardware}};
  app.add_option("--pipeline", o.pipeline, "Profile of the cores; without it paper")
      ->transform(CLI::CheckedTransformer(profiles).description(""))
      ->type_name("paper|hardware");
  app.add_option("-d,--dict", command.dictionary,
                 "Dictionary to look for, in a black border, of 6x6 cells (hardware profile: 4x4 to 8x8): a "
                 "built-in name or "
                 "a .codes file")
      ->capture_default_str()
      ->type_name("NAME");
  app.add_flag("--inverted", o.inverted, "Also look for white-on-black markers");
  app.add_option("--min-size", o.min_marker_size, "Least side of a marker, in pixels")->capture_default_str();
  app.add_option("--max-size", o.max_marker_size, "Largest side of a marker, in pixels")
      ->capture_default_str();
  app.add_option("--corrected-bits", o.corrected_bits,
                 "Wrong bits corrected in a code; without it, the dictionary's safe number")
      ->check(CLI::Range(0, 64).description(""));
  app.add_option("--min-contrast", o.min_contrast,
                 "Hardware profile: least difference of dark and light, in grey levels")
      ->check(CLI::Range(0, 255).description(""))
      ->capture_default_str();
  app.add_option("--threshold", o.fixed_threshold, "Paper profile: grey levels below it are dark")
      ->check(CLI::Range(0, 256).description(""))
      ->capture_default_str();
  app.add_flag("--above-is-dark", o.above_is_dark,
               "Paper profile: levels at or above the threshold are dark instead");
  app.add_option("--corner-offset", o.corner_offset,
                 "Paper profile: offset across the direction of travel that makes a corner, in pixels")
      ->check(CLI::Range(1, 255).description(""))
      ->capture_default_str();
  app.add_flag("--give-up", command.hardware.give_up,
               "Give up the rest of a frame rather than hold the video back when events pile up");
  app.add_option("--memory-latency", command.hardware.memory_latency,
                 "Clocks until the memory answers a read; a write takes three times as long")
      ->check(CLI::Range(1, 10000).description(""))
      ->capture_default_str();
  app.add_option("--trace", command.hardware.trace, "Write the waves of all signals (FST); takes one image")
      ->type_name("FILE");
  app.footer(
      "Prints one JSON object an image, as `runmark detect --pipeline paper --format jsonl` (or hardware)\n"
      "does, and in \"hardware\" clocks, peaks, what was dropped, and each marker's latency: from the pixel "
      "at its "
      "lowest\n"
      "corner to the last word of its report, in clocks and in lines of one clock a pixel.\n"
      "Exit status: 0, also when nothing was found; 2 when something went wrong.");
}

/// Checks what the detector would check, so that the errors are the same.
void check(Command& command) {
  HardwareSettings& h = command.hardware;
  h.dictionary = cli::value_or_throw(load_dictionary(command.dictionary));
  (void)cli::value_or_throw(Detector::create(h.options, {h.dictionary}));
  const bool paper = h.options.pipeline == Pipeline::paper;
  if (h.dictionary.border != Border::black ||
      !(paper ? PaperPipeline::can_read(h.dictionary) : HardwarePipeline::can_read(h.dictionary))) {
    throw UserError("dictionary " + h.dictionary.name + ": the hardware reads " +
                    (paper ? "6x6" : "4x4 to 8x8") + " cells in a black border");
  }
}

std::string line_of(const cli::Frame& picture, const HardwareFrame& frame) {
  using Json = nlohmann::ordered_json;
  // The detector's own line, and more at its end.
  Json line =
      Json::parse(cli::make_marker_format("jsonl", {})->frame(picture, frame.markers, nullptr, nullptr));
  const auto thousandths = [](double value) { return std::round(value * 1000) / 1000; };
  Json lines = Json::array();
  for (const std::uint64_t clocks : frame.latencies) {
    lines.push_back(thousandths(static_cast<double>(clocks) / picture.pixels.cols));
  }
  line["hardware"] = {{"clocks", frame.clocks},
                      {"clocks_per_pixel", thousandths(static_cast<double>(frame.clocks) /
                                                       static_cast<double>(picture.pixels.total()))},
                      {"latency_clocks", frame.latencies},
                      {"latency_lines", lines},
                      {"record_peak", frame.record_peak},
                      {"records", frame.records},
                      {"end_peak", frame.end_peak},
                      {"ends", frame.ends},
                      {"dropped_full", frame.dropped_full},
                      {"dropped_rule", frame.dropped_rule},
                      {"dropped_queue", frame.dropped_queue},
                      {"rest_given_up", frame.lost}};
  return line.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// Runs all images; what could not be read is said at the end.
int run(Command& command) {
  check(command);
  const auto inputs = cli::find_inputs(command.images);
  for (const cli::Input& input : inputs) {
    if (input.kind != cli::InputKind::image) throw UserError(input.name + ": only images can be run");
  }
  if (!command.hardware.trace.empty() && inputs.size() > 1) throw UserError("--trace takes one image");
  const int least_width = command.hardware.options.pipeline == Pipeline::paper ? 3 : 16;
  std::unique_ptr<Hardware> small;
  std::unique_ptr<Hardware> large;
  std::vector<std::string> errors;
  for (const cli::Input& input : inputs) {
    try {
      const cli::Frame picture{input.name, 0, cli::read_image(input.name), true};
      const int width = picture.pixels.cols;
      const int height = picture.pixels.rows;
      if (width < least_width || height < 3 || width > most_width || height > most_height) {
        throw InputError(input.name + ": " + std::to_string(width) + " x " + std::to_string(height) +
                         " pixels: the hardware takes " + std::to_string(least_width) + " x 3 to " +
                         std::to_string(most_width) + " x " + std::to_string(most_height));
      }
      auto& hardware = width <= 640 && height <= 480 ? small : large;
      if (!hardware) hardware = make_hardware(command.hardware, width, height);
      const std::string line = line_of(picture, hardware->run(picture.pixels));
      if (std::fwrite(line.data(), 1, line.size(), stdout) != line.size() || std::fflush(stdout) != 0)
        throw UserError("standard output cannot be written");
    } catch (const InputError& error) {
      errors.emplace_back(error.what());
    }
  }
  for (const std::string& error : errors) cli::print_error(error, "runmark-rtl");
  return errors.empty() ? 0 : cli::exit_failure;
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("Runs the FPGA core, translated to software, on images", "runmark-rtl");
  app.set_version_flag("--version", "runmark-rtl " RUNMARK_VERSION);
  app.get_formatter()->column_width(34);
  Command command;
  add_options(app, command);
  cli::silence_libraries();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    throw UserError(std::string(error.what()) + "; see runmark-rtl --help");
  }
  return run(command);
}

}  // namespace
}  // namespace runmark::rtl

int main(int argc, char** argv) {
  try {
    return runmark::rtl::parse_and_run(argc, argv);
  } catch (const std::exception& error) {
    runmark::cli::print_error(error.what(), "runmark-rtl");
  }
  return runmark::cli::exit_failure;
}
