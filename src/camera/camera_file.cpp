#include "runmark/camera_file.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <vector>

#include "camera/one_line.h"
#include "files/read_text.h"

namespace runmark {
namespace {

/// What is wrong with a file, on its way to the Result.
struct Wrong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The first of several names under which people keep the same thing.
YAML::Node child(const YAML::Node& root, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (const YAML::Node node = root[name]) return node;
  }
  return YAML::Node(YAML::NodeType::Undefined);
}

double number(const YAML::Node& node, const std::string& what) {
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value)) throw Wrong(what + " is not a number");
  return value;
}

/// Takes numbers out of lists whose items may be lists. By YAML's aliases a list can hold itself, and a short
/// file can be one of endless lists: so depth and items are counted.
class NumberList {
 public:
  explicit NumberList(const std::string& what) : what_(what) {}

  void add(const YAML::Node& node, int depth) {
    if (depth > deepest) throw Wrong(what_ + " is nested too deeply");
    if (node.IsMap()) {
      if (!node["data"]) throw Wrong(what_ + " has no data");
      return add(node["data"], depth + 1);
    }
    if (!node.IsSequence()) throw Wrong(what_ + " is not a list of numbers");
    for (const YAML::Node& item : node) {
      if (++items_ > most_items) throw Wrong(what_ + " has too many numbers");
      if (item.IsSequence()) {
        add(item, depth + 1);
      } else {
        values_.push_back(number(item, what_));
      }
    }
  }
  [[nodiscard]] const std::vector<double>& values() const { return values_; }

 private:
  static constexpr int deepest = 4;      // a matrix, its data, its rows, and one more
  static constexpr int most_items = 64;  // no list here has as many
  const std::string& what_;
  std::vector<double> values_;
  int items_ = 0;
};

/// A plain list, a list of rows, or a matrix with its numbers under `data`.
std::vector<double> numbers(const YAML::Node& node, const std::string& what) {
  NumberList list(what);
  list.add(node, 1);
  return list.values();
}

int side(const YAML::Node& node, const char* what) {
  if (!node) return 0;
  const double value = number(node, what);
  if (value < 0 || value > 1e6 || value != static_cast<int>(value))
    throw Wrong(std::string(what) + " is not a picture's side");
  return static_cast<int>(value);
}

std::optional<Lens> named_lens(const YAML::Node& root) {
  const YAML::Node node = child(root, {"distortion_model", "distortionModel"});
  if (node && node.IsScalar()) {
    const auto name = node.as<std::string>();
    if (name == "plumb_bob" || name == "plain" || name == "radtan") return Lens::plain;
    if (name == "rational_polynomial" || name == "rational") return Lens::rational;
    if (name == "equidistant" || name == "fisheye") return Lens::fisheye;
    if (!name.empty()) {
      throw Wrong("distortion_model '" + name +
                  "' is not one of plumb_bob, rational_polynomial, equidistant, fisheye");
    }
  }
  const YAML::Node flag = root["fisheye_model"];
  if (flag && flag.IsScalar()) {
    const auto text = flag.as<std::string>();
    if (text == "1" || text == "true") return Lens::fisheye;
  }
  return {};
}

/// Trailing zeros say nothing: OpenCV writes as many coefficients as its flags allowed.
void set_lens(Camera& camera, std::optional<Lens> named, std::vector<double> values) {
  std::size_t used = values.size();
  while (used > 0 && values[used - 1] == 0) --used;
  if (values.size() > 14)
    throw Wrong("there are " + std::to_string(values.size()) + " distortion coefficients; 14 is the most");
  if (used > 12) throw Wrong("the distortion has a tilted sensor (14 coefficients), which is not supported");
  if (named) {
    camera.lens = *named;
  } else {
    camera.lens = used > 5 ? Lens::rational : Lens::plain;
  }
  const auto most = static_cast<std::size_t>(coefficients_of(camera.lens));
  if (used > most) {
    throw Wrong("there are " + std::to_string(used) + " distortion coefficients, but its model has " +
                std::to_string(most));
  }
  std::copy_n(values.begin(), std::min(used, most), camera.distortion.begin());
}

Camera camera_of(const YAML::Node& root) {
  if (!root.IsMap()) throw Wrong("this is no camera file: it has no keys");
  Camera camera;
  camera.width = side(child(root, {"image_width", "imageWidth", "image_Width", "width"}), "image_width");
  camera.height =
      side(child(root, {"image_height", "imageHeight", "image_Height", "height"}), "image_height");
  const YAML::Node matrix = child(
      root, {"camera_matrix", "cameraMatrix", "Camera_Matrix", "CameraMatrix", "intrinsic_matrix", "K", "k"});
  if (!matrix) throw Wrong("there is no camera_matrix (nor K)");
  const std::vector<double> k = numbers(matrix, "camera_matrix");
  if (k.size() != 9) throw Wrong("camera_matrix has " + std::to_string(k.size()) + " numbers, not 9");
  if (k[1] != 0 || k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1) {
    throw Wrong("camera_matrix is not [fx 0 cx; 0 fy cy; 0 0 1]");
  }
  camera.fx = k[0];
  camera.cx = k[2];
  camera.fy = k[4];
  camera.cy = k[5];
  const YAML::Node distortion =
      child(root, {"distortion_coefficients", "distCoeffs", "Distortion_Coefficients", "dist_coeffs",
                   "distortionCoefficients", "distortion", "D", "d"});
  const std::vector<double> d =
      distortion ? numbers(distortion, "distortion_coefficients") : std::vector<double>();
  set_lens(camera, named_lens(root), d);
  if (!camera.is_valid())
    throw Wrong("its numbers make no sense: focal lengths must be positive, all numbers finite");
  return camera;
}

/// OpenCV begins with a directive that no other YAML reader takes.
std::string as_yaml(std::string_view text) {
  std::string plain(text);
  if (plain.starts_with("\xef\xbb\xbf")) plain.erase(0, 3);
  if (plain.starts_with("%YAML")) plain.erase(0, std::min(plain.find('\n'), plain.size()));
  return plain;
}

/// With a point or an exponent: without one OpenCV takes a list for one of integers.
std::string decimal(double value) {
  std::array<char, 40> digits{};
  std::snprintf(digits.data(), digits.size(), "%.17g", value);
  std::string text = digits.data();
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string list(const double* values, int count) {
  std::string text = "[";
  for (int i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + decimal(values[i]);
  return text + "]";
}

std::string opencv_matrix(const char* name, int rows, int columns, const std::string& data) {
  return std::string(name) + ": !!opencv-matrix\n   rows: " + std::to_string(rows) +
         "\n   cols: " + std::to_string(columns) + "\n   dt: d\n   data: " + data + "\n";
}

std::string ros_matrix(const char* name, int rows, int columns, const std::string& data) {
  return std::string(name) + ":\n  rows: " + std::to_string(rows) + "\n  cols: " + std::to_string(columns) +
         "\n  data: " + data + "\n";
}

/// OpenCV knows 4, 5, 8 and 12 coefficients, ROS 4, 5 and 8.
int coefficients_to_write(const Camera& camera) {
  if (camera.lens != Lens::rational) return coefficients_of(camera.lens);
  const bool prism =
      std::any_of(camera.distortion.begin() + 8, camera.distortion.end(), [](double v) { return v != 0; });
  return prism ? 12 : 8;
}

}  // namespace

Result<Camera> parse_camera(std::string_view text) {
  try {
    return camera_of(YAML::Load(as_yaml(text)));
  } catch (const YAML::Exception& error) {
    const std::string where =
        error.mark.is_null() ? "" : "line " + std::to_string(error.mark.line + 1) + ": ";
    return Error{one_line(where + "this is no YAML: " + error.msg)};
  } catch (const std::exception& error) {
    return Error{one_line(error.what())};
  }
}

Result<Camera> read_camera(const std::string& path) {
  const auto text = read_text(path, 1);
  if (!text) return Error{text.error()};
  Result<Camera> camera = parse_camera(*text);
  if (!camera) return Error{path + ": " + camera.error()};
  return camera;
}

std::string camera_text(const Camera& camera, CameraFormat format, double error, std::string_view name) {
  const std::array k{camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
  const int count = coefficients_to_write(camera);
  const std::string d = list(camera.distortion.data(), count);
  const std::string size = "image_width: " + std::to_string(camera.width) +
                           "\nimage_height: " + std::to_string(camera.height) + "\n";
  if (format == CameraFormat::opencv) {
    std::string text = "%YAML:1.0\n---\n" + size + opencv_matrix("camera_matrix", 3, 3, list(k.data(), 9)) +
                       opencv_matrix("distortion_coefficients", 1, count, d);
    if (camera.lens == Lens::fisheye) text += "fisheye_model: 1\n";
    if (error >= 0) text += "avg_reprojection_error: " + decimal(error) + "\n";
    return text;
  }
  const char* model = camera.lens == Lens::plain     ? "plumb_bob"
                      : camera.lens == Lens::fisheye ? "equidistant"
                                                     : "rational_polynomial";
  const std::array r{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  const std::array p{camera.fx, 0.0, camera.cx, 0.0, 0.0, camera.fy, camera.cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  std::string text = error < 0 ? "" : "# rms reprojection error: " + decimal(error) + " px\n";
  return text + size + "camera_name: " + std::string(name) + "\n" +
         ros_matrix("camera_matrix", 3, 3, list(k.data(), 9)) + "distortion_model: " + model + "\n" +
         ros_matrix("distortion_coefficients", 1, count, d) +
         ros_matrix("rectification_matrix", 3, 3, list(r.data(), 9)) +
         ros_matrix("projection_matrix", 3, 4, list(p.data(), 12));
}

}  // namespace runmark
