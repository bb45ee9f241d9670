#include "evaluate/truth.h"

#include <gtest/gtest.h>

#include <fstream>

#include "evaluate/observations.h"
#include "evaluate/truth_folder.h"

namespace runmark {
namespace {

namespace fs = std::filesystem;

class EvaluateFiles : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("runmark_evaluate_" + std::string(info->name()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  std::string truth_error(const std::string& text) {
    const auto truth = read_truth(write("truth.json", text));
    return truth ? "no error" : truth.error().substr(folder_.string().size() + 1);
  }
  std::string detections_error(const std::string& text) {
    const auto seen = read_observations(write("seen.jsonl", text));
    return seen ? "no error" : seen.error().substr(folder_.string().size() + 1);
  }

  fs::path folder_;
};

const std::string good_marker =
    R"({"id": 3, "corners": [[1,2],[3,4],[5,6],[7,8.5]], "truth": "rendered", "tilt": 30})";

std::string image_with(const std::string& marker) {
  return R"([{"image": "a.png", "width": 64, "height": 48, "dictionary": "tag36h11", "inverted": false,
              "markers": [)" +
         marker + R"(], "maybe": [], "present_ids": [3], "rendered": true, "source": "here"}])";
}

TEST_F(EvaluateFiles, ReadsTruth) {
  const auto truth = read_truth(write("truth.json", image_with(good_marker)));
  ASSERT_TRUE(truth) << truth.error();
  const TruthImage& image = truth->at(0);
  EXPECT_EQ(image.image, "a.png");
  EXPECT_EQ(image.dictionary, "tag36h11");
  ASSERT_EQ(image.markers.size(), 1U);
  EXPECT_EQ(image.markers[0].id, 3);
  EXPECT_DOUBLE_EQ(image.markers[0].corners[3].y, 8.5);
  EXPECT_TRUE(image.markers[0].exact_corners);
  EXPECT_EQ(image.markers[0].tilt, 30);
  EXPECT_FALSE(image.markers[0].blur);
}

TEST_F(EvaluateFiles, SaysWhatIsWrongWithATruthFile) {
  EXPECT_EQ(truth_error("{}"), "truth.json: is not a list of images");
  EXPECT_EQ(truth_error("[{}]"), "truth.json: image 1: no \"image\"");
  EXPECT_EQ(truth_error(image_with(R"({"id": 3})")), "truth.json: a.png: no \"corners\"");
  EXPECT_EQ(truth_error(image_with(R"({"id": "x", "corners": []})")),
            "truth.json: a.png: \"id\" is not a whole number");
  EXPECT_EQ(truth_error(image_with(R"({"id": 1, "corners": [[1,2]]})")),
            "truth.json: a.png: \"corners\" is not a list of four");
  const std::string once = image_with(good_marker);
  const std::string item = once.substr(1, once.size() - 2);
  EXPECT_EQ(truth_error("[" + item + "," + item + "]"), "truth.json: a.png is listed twice");
  EXPECT_NE(truth_error("[").find("truth.json: not a truth file: "), std::string::npos);
  EXPECT_EQ(read_truth("/nowhere/truth.json").error(), "/nowhere/truth.json: cannot be read");
}

TEST_F(EvaluateFiles, ReadsDetections) {
  const auto seen = read_observations(
      write("seen.jsonl", R"({"image": "a.png", "markers": [)" + good_marker + R"(], "ms": 2.5}

{"image": "b.png", "markers": []})"));
  ASSERT_TRUE(seen) << seen.error();
  EXPECT_EQ(seen->size(), 2U);
  EXPECT_EQ(seen->at("a.png").markers.at(0).id, 3);
  EXPECT_EQ(seen->at("a.png").milliseconds, 2.5);
  EXPECT_FALSE(seen->at("b.png").milliseconds);
}

TEST_F(EvaluateFiles, SaysWhichLineOfDetectionsIsWrong) {
  EXPECT_EQ(detections_error("{\"image\": \"a\", \"markers\": []}\n{\"image\": \"b\"}"),
            "seen.jsonl:2: no \"markers\"");
  EXPECT_EQ(detections_error("{\"image\": \"a\", \"markers\": []}\n{\"image\": \"a\", \"markers\": []}"),
            "seen.jsonl:2: a comes twice");
  EXPECT_NE(detections_error("nonsense").find("seen.jsonl:1: "), std::string::npos);
}

TEST_F(EvaluateFiles, FindsDictionariesBesideTheTruth) {
  fs::create_directories(folder_ / "dictionaries");
  write("dictionaries/mine.codes", "4 0\n0x1234\n0x0f0f\n");
  const TruthFolder folder(folder_ / "truth.json");
  TruthImage image{.image = "a.png", .dictionary = "custom:mine"};
  const auto own = folder.dictionaries(image);
  ASSERT_TRUE(own) << own.error();
  EXPECT_EQ(own->at(0).codes.size(), 2U);
  image.dictionary = "nothing";
  EXPECT_FALSE(folder.dictionaries(image));
  image.dictionary.reset();
  EXPECT_EQ(folder.dictionaries(image)->size(), dictionaries_without_markers.size());
  EXPECT_EQ(folder.image(image), folder_ / "a.png");
}

}  // namespace
}  // namespace runmark
