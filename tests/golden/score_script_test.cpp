// Our scores and those of the photos' own script, on the same detections, number for number. The detections
// are the truth with things done to it that reach every branch of the scoring.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <sstream>

#include "evaluate/report.h"
#include "image_sets.h"

namespace runmark::golden {
namespace {

namespace fs = std::filesystem;

Observations spoilt(const std::vector<TruthImage>& truth) {
  std::mt19937 random(7);
  const auto chance = [&](double share) { return static_cast<double>(random()) < share * 4294967296.0; };
  const auto jitter = [&](double size) {
    return (static_cast<double>(random()) / 4294967296.0 - 0.5) * size;
  };
  Observations all;
  for (const TruthImage& image : truth) {
    if (chance(0.05)) continue;
    std::vector<Observation>& seen = all[image.image].markers;
    for (const auto* markers : {&image.markers, &image.maybe}) {
      for (const TruthMarker& marker : *markers) {
        if (chance(0.1)) continue;
        Observation report{marker.id, marker.corners};
        if (chance(0.03)) report.id += 1;
        if (chance(0.05))
          std::rotate(report.corners.begin(), report.corners.begin() + 1, report.corners.end());
        const double shift = chance(0.1) ? 12 : 1;
        for (Point& p : report.corners) p = {p.x + jitter(shift), p.y + jitter(shift)};
        seen.push_back(report);
        if (chance(0.05)) seen.push_back(report);
      }
    }
    if (chance(0.1)) seen.push_back({9999, {Point{1, 1}, Point{20, 1}, Point{20, 20}, Point{1, 20}}});
  }
  return all;
}

void write(const fs::path& file, const Observations& observations) {
  std::ofstream out(file);
  out.precision(17);
  for (const auto& [image, seen] : observations) {
    out << "{\"image\": \"" << image << "\", \"markers\": [";
    for (std::size_t i = 0; i < seen.markers.size(); ++i) {
      out << (i == 0 ? "" : ", ") << "{\"id\": " << seen.markers[i].id << ", \"corners\": [";
      for (std::size_t j = 0; j < 4; ++j) {
        const Point p = seen.markers[i].corners[j];
        out << (j == 0 ? "[" : ", [") << p.x << ", " << p.y << ']';
      }
      out << "]}";
    }
    out << "]}\n";
  }
}

std::string output_of(const std::string& command) {
  std::string text;
  std::FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) text += buffer.data();
  return pclose(pipe) == 0 ? text : "";
}

// Our scores in the script's own words.
std::string in_the_scripts_words(const Scores& scores) {
  const Tally& t = scores.total;
  std::array<char, 400> line{};
  std::snprintf(
      line.data(), line.size(),
      "recall %.4f (%d/%d) false %d extra %d badcorner %d rotated %d dup/maybe %d | corner error median "
      "%.3f p90 %.3f rms %.3f px",
      t.recall(), t.found, t.truth, t.false_alarms, t.extra, t.bad_corners, t.rotated, t.duplicates,
      t.corners.percentile(0.5), t.corners.percentile(0.9), t.corners.rms());
  return line.data();
}

TEST(ScoreScript, AgreesNumberForNumber) {
  const fs::path folder = fs::path(shared_folder()) / "real-images";
  if (!fs::exists(folder / "score.py")) GTEST_SKIP() << "no real photos at " << folder;
  const auto truth = read_truth(folder / "truth.json");
  ASSERT_TRUE(truth) << truth.error();
  const fs::path file = fs::path(testing::TempDir()) / "runmark_spoilt.jsonl";
  const Observations observations = spoilt(*truth);
  write(file, observations);
  const std::string said = output_of("python3 '" + (folder / "score.py").string() + "' '" +
                                     (folder / "truth.json").string() + "' '" + file.string() + "' -v");
  fs::remove(file);
  ASSERT_FALSE(said.empty()) << "score.py did not run";
  const Scores scores = score(*truth, observations);
  for (const int count : {scores.total.false_alarms, scores.total.extra, scores.total.bad_corners,
                          scores.total.rotated, scores.total.duplicates}) {
    EXPECT_GT(count, 0) << "the detections reach every branch";
  }
  EXPECT_EQ(said.substr(0, said.find('\n')), in_the_scripts_words(scores));

  // "  dictionary DICT_4X4_50    recall 116/122 false 40"
  int rows = 0;
  for (const Breakdown& breakdown : scores.breakdowns) {
    const bool sides = breakdown.name == "side";
    if (!sides && breakdown.name != "dictionary" && breakdown.name != "source") continue;
    for (const auto& [label, tally] : breakdown.rows) {
      const std::string name = label == ">=100" ? ">100" : label;
      std::array<char, 200> line{};
      std::snprintf(line.data(), line.size(), "  %-10s %-44s recall %d/%d false %d\n",
                    sides ? "side px" : breakdown.name.c_str(), name.c_str(), tally.found, tally.truth,
                    tally.false_alarms);
      EXPECT_NE(said.find(line.data()), std::string::npos) << line.data() << said;
      ++rows;
    }
  }
  EXPECT_EQ(rows, std::count(said.begin(), said.end(), '\n') - 1) << said;
}

}  // namespace
}  // namespace runmark::golden
