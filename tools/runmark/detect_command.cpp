#include "detect_command.h"

#include <algorithm>
#include <memory>
#include <thread>

#include "detect_run.h"
#include "errors.h"
#include "interrupt.h"

namespace runmark::cli {

void add_detect_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("detect", "Find markers and print them");
  const auto settings = std::make_shared<DetectSettings>();
  command->add_option("INPUT", settings->inputs, input_help)->required()->type_name("");
  add_detector_options(*command, settings->detector);
  add_pose_options(*command, settings->poses);
  CLI::Option* format =
      command->add_option("-f,--format", settings->format, "How markers are printed (text)");
  format->check(CLI::IsMember({"text", "jsonl", "csv"}).description(""))->type_name("text|jsonl|csv");
  CLI::Option* output =
      command->add_option("-o,--output", settings->output, "Print into this file instead of standard output")
          ->type_name("FILE");
  command
      ->add_option_function<std::string>(
          "--resume",
          [settings](const std::string& path) {
            settings->output = path;
            settings->resume = true;
          },
          "Print JSON lines into this file, after those that a run of the same inputs left in it when it "
          "was stopped; what is done is not done again")
      ->excludes(output)
      ->type_name("FILE");
  command
      ->add_option("--annotate", settings->annotate,
                   "Draw the markers into the pictures: an image file for one image, an .mp4 or .avi for "
                   "one video, a folder for several inputs")
      ->type_name("PATH");
  command
      ->add_option(
          "--confirm", settings->confirm,
          "Print a marker only when it has been seen in this many frames of a video, near where it was "
          "before; pictures count as frames of one")
      ->check(CLI::Range(1, 1000).description(""))
      ->type_name("N");
  command
      ->add_option(
          "--row-time", settings->row_time,
          "Rolling shutter: microseconds from one row to the next; prints when each marker was seen, "
          "counted from the first row")
      ->check(CLI::Range(1e-6, 1e6).description(""))
      ->type_name("US");
  command->add_flag("--stats", settings->stats, "Also print each frame's time and counts (not with csv)");
  command->add_flag("--strict", settings->strict, "Stop at the first input that cannot be read");
  settings->jobs = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 1024U));
  command
      ->add_option("-j,--jobs", settings->jobs,
                   "Threads that detect; without it, one for each processor core")
      ->check(CLI::Range(1, 1024).description(""))
      ->type_name("N");
  command->footer(
      "A pose takes points of the marker's or board's frame (x to the right, y down, z into the sheet) to "
      "the\n"
      "camera's (x to the right, y down, z forwards), in the unit of the sizes given.\n"
      "Pixels are taken as stored: an EXIF or video rotation is not applied. The centre of the top-left\n"
      "pixel is (0, 0); corners run from the marker's top-left clockwise.\n"
      "Exit status: 0, also when nothing was found; 2 when something went wrong; 130 after Ctrl-C.");
  command->callback([settings, format] {
    if (settings->resume && format->count() == 0) settings->format = "jsonl";
    if (settings->resume && settings->format != "jsonl") throw UserError("--resume goes with jsonl only");
    if (settings->resume && settings->confirm > 1) {
      throw UserError("--confirm: what was seen before a run was stopped is not known to --resume");
    }
    if (settings->stats && settings->format == "csv") throw UserError("--stats has no place in csv");
    if (!settings->poses.board.empty() && settings->format == "csv")
      throw UserError("--board has no place in csv");
    catch_interrupts();
    DetectRun(*settings).run();
  });
}

}  // namespace runmark::cli
