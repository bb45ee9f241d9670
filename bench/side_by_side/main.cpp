#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>

#include "bench/side_by_side/page.h"
#include "bench/side_by_side/run.h"
#include "evaluate/report.h"

namespace runmark::bench {
namespace {

struct Arguments {
  std::filesystem::path truth;
  std::filesystem::path images;
  std::filesystem::path detections;
  std::filesystem::path page;
  std::vector<std::string> detectors;
  int rounds = 1;
};

int fail(const std::string& message) {
  std::cerr << "runmark-compare: " << message << '\n';
  return 2;
}

int compare(const Arguments& arguments) {
  const auto truth = read_truth(arguments.truth);
  if (!truth) return fail(truth.error());
  std::vector<const Contender*> chosen;
  for (const std::string& name : arguments.detectors) chosen.push_back(find_contender(name));
  if (chosen.empty()) {
    for (const Contender& contender : contenders()) chosen.push_back(&contender);
  }
  const TruthFolder folder(arguments.truth, arguments.images);
  const auto runs = run_contenders(chosen, *truth, folder, arguments.rounds, [](std::size_t) {});
  if (!runs) return fail(runs.error());
  for (const Run& run : *runs) {
    if (arguments.page.empty()) {
      std::cout << "== " << run.name << '\n';
      write_text(std::cout, score(*truth, run.observations));
    }
    if (arguments.detections.empty()) continue;
    const auto file = arguments.detections / (run.name + ".jsonl");
    if (!write_observations(file, run.observations)) return fail(file.string() + ": cannot be written");
  }
  if (arguments.page.empty()) return 0;
  std::ofstream page(arguments.page);
  page << comparison_page("runmark and its peers on " + arguments.truth.string(), *truth, folder, *runs);
  if (!page.flush()) return fail(arguments.page.string() + ": cannot be written");
  std::cout << arguments.page.string() << '\n';
  return 0;
}

}  // namespace
}  // namespace runmark::bench

int main(int argc, char** argv) {
  using namespace runmark::bench;
  CLI::App app("Runs runmark and its peers on the same images and shows them side by side",
               "runmark-compare");
  Arguments arguments;
  std::vector<std::string> names;
  for (const Contender& contender : contenders()) names.emplace_back(contender.name);
  app.add_option("truth", arguments.truth, "truth.json of the images")->required()->check(CLI::ExistingFile);
  app.add_option("--images", arguments.images, "folder of the images")->check(CLI::ExistingDirectory);
  app.add_option("-o,--output", arguments.page, "HTML page to write; without it, tables on standard output");
  app.add_option("--detectors", arguments.detectors, "which ones; default: all")
      ->delimiter(',')
      ->check(CLI::IsMember(names));
  app.add_option("--rounds", arguments.rounds, "how often; times are medians")->check(CLI::Range(1, 1000));
  app.add_option("--detections", arguments.detections, "folder to write each detector's detections to")
      ->check(CLI::ExistingDirectory);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "runmark-compare: " << error.what() << '\n';
    return 2;
  }
  return compare(arguments);
}
