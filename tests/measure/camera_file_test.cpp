#include "runmark/camera_file.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "support/cameras.h"

namespace runmark {
namespace {

void expect_same(const Camera& a, const Camera& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.fx, b.fx);
  EXPECT_EQ(a.fy, b.fy);
  EXPECT_EQ(a.cx, b.cx);
  EXPECT_EQ(a.cy, b.cy);
  EXPECT_EQ(a.distortion, b.distortion);
}

TEST(CameraFile, ReadsWhatItWrites) {
  for (const Camera& camera : test::cameras()) {
    for (const CameraFormat format : {CameraFormat::opencv, CameraFormat::ros}) {
      const auto back = parse_camera(camera_text(camera, format, 0.25));
      ASSERT_TRUE(back) << back.error();
      expect_same(*back, camera);
      EXPECT_EQ(back->lens == Lens::fisheye, camera.lens == Lens::fisheye);
    }
  }
}

TEST(CameraFile, ListsThatHoldThemselvesOrGrowWithoutEndAreRefused) {
  const auto itself = parse_camera("K: &a [1, *a]\n");
  ASSERT_FALSE(itself);
  EXPECT_NE(itself.error().find("nested too deeply"), std::string::npos) << itself.error();
  std::string text = "a: &a [1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (char c = 'b'; c < 'n'; ++c) {
    text += std::string(1, c) + ": &" + c + " [*" + static_cast<char>(c - 1);
    for (int i = 0; i < 8; ++i) text += std::string(", *") + static_cast<char>(c - 1);
    text += "]\n";
  }
  EXPECT_FALSE(parse_camera(text + "K: *m\n"));
  EXPECT_FALSE(parse_camera(text + "K: *b\n"));
}

TEST(CameraFile, ErrorsAreOneLine) {
  for (const char* text : {"a: \"\\\n\"", "distortion_model: \"a\\nb\"\nK: [1, 0, 1, 0, 1, 1, 0, 0, 1]"}) {
    const auto camera = parse_camera(text);
    ASSERT_FALSE(camera);
    EXPECT_EQ(camera.error().find('\n'), std::string::npos) << camera.error();
  }
}

TEST(CameraFile, OpenCvReadsWhatIsWrittenForIt) {
  for (const Camera& camera : test::cameras()) {
    const cv::FileStorage file(camera_text(camera, CameraFormat::opencv, 1),
                               cv::FileStorage::READ | cv::FileStorage::MEMORY);
    cv::Mat k;
    cv::Mat d;
    file["camera_matrix"] >> k;
    file["distortion_coefficients"] >> d;
    ASSERT_EQ(k.type(), CV_64F);
    EXPECT_EQ(k.at<double>(0, 0), camera.fx);
    EXPECT_EQ(k.at<double>(1, 2), camera.cy);
    for (int i = 0; i < d.cols; ++i)
      EXPECT_EQ(d.at<double>(0, i), camera.distortion[static_cast<std::size_t>(i)]);
    EXPECT_EQ(static_cast<int>(file["image_width"]), camera.width);
  }
}

TEST(CameraFile, ReadsWhatOpenCvWrites) {
  cv::FileStorage file(".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  file << "image_width" << 640 << "image_height" << 480;
  file << "camera_matrix" << cv::Mat(cv::Matx33d(500, 0, 320.5, 0, 510, 240, 0, 0, 1));
  file << "distortion_coefficients" << cv::Mat(cv::Matx<double, 5, 1>(-0.3, 0.1, 0.001, -0.002, 0.05));
  const auto camera = parse_camera(file.releaseAndGetString());
  ASSERT_TRUE(camera) << camera.error();
  expect_same(*camera, {640, 480, 500, 510, 320.5, 240, Lens::plain, {-0.3, 0.1, 0.001, -0.002, 0.05}});
}

TEST(CameraFile, ReadsRosFilesAndPrintedMessages) {
  const auto file = parse_camera(
      "image_width: 640\nimage_height: 480\ncamera_name: head\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
      "  data: [430.2, 0, 306.7, 0, 430.5, 227.2, 0, 0, 1]\ndistortion_model: plumb_bob\n"
      "distortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [-0.33, 0.11, 0.0001, -0.0003, 0]\n");
  ASSERT_TRUE(file) << file.error();
  expect_same(*file, {640, 480, 430.2, 430.5, 306.7, 227.2, Lens::plain, {-0.33, 0.11, 0.0001, -0.0003, 0}});
  const auto message = parse_camera(
      "header:\n  frame_id: camera\nheight: 480\nwidth: 640\ndistortion_model: equidistant\n"
      "d:\n- -0.01\n- 0.02\n- 0.0\n- 0.0\nk:\n- 285.0\n- 0.0\n- 319.5\n- 0.0\n- 286.0\n- 239.5\n- 0.0\n- "
      "0.0\n- 1.0\n");
  ASSERT_TRUE(message) << message.error();
  EXPECT_EQ(message->lens, Lens::fisheye);
  expect_same(*message, {640, 480, 285, 286, 319.5, 239.5, Lens::fisheye, {-0.01, 0.02}});
}

TEST(CameraFile, TellsWhatIsWrong) {
  const auto error = [](const char* text) { return parse_camera(text).error(); };
  EXPECT_NE(error("{[").find("this is no YAML"), std::string::npos);
  EXPECT_NE(error("just words").find("no keys"), std::string::npos);
  EXPECT_NE(error("a: 1").find("no camera_matrix"), std::string::npos);
  EXPECT_NE(error("K: [1, 2]").find("2 numbers, not 9"), std::string::npos);
  EXPECT_NE(error("K: [1, 0, 2, 0, x, 2, 0, 0, 1]").find("not a number"), std::string::npos);
  EXPECT_NE(error("K: [1, 0.1, 2, 0, 1, 2, 0, 0, 1]").find("[fx 0 cx"), std::string::npos);
  EXPECT_NE(error("K: [0, 0, 2, 0, 1, 2, 0, 0, 1]").find("focal lengths"), std::string::npos);
  EXPECT_NE(error("K: [1, 0, 2, 0, 1, 2, 0, 0, 1]\ndistortion_model: magic").find("'magic'"),
            std::string::npos);
  EXPECT_NE(error("K: [1, 0, 2, 0, 1, 2, 0, 0, 1]\nD: [1, 1, 1, 1, 1, 1]\ndistortion_model: plumb_bob")
                .find("6 distortion coefficients, but its model has 5"),
            std::string::npos);
  EXPECT_EQ(read_camera("/dev/zero").error(), "/dev/zero: larger than 1 MB, which no such file needs to be");
  EXPECT_NE(read_camera("/nowhere.yml").error().find("/nowhere.yml: cannot be read"), std::string::npos);
}

}  // namespace
}  // namespace runmark
