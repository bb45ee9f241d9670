#include "runmark/board_file.h"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "camera/one_line.h"
#include "files/read_text.h"
#include "runmark/pose.h"

namespace runmark {
namespace {

using nlohmann::json;

/// What is wrong with a file, on its way to the Result.
struct Wrong : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class T>
T value_or_wrong(Result<T> result) {
  if (!result) throw Wrong(result.error());
  return *std::move(result);
}

template <class T>
T get(const json& object, const char* key, const std::string& where) {
  const auto found = object.find(key);
  if (found == object.end()) throw Wrong(where + "has no '" + key + "'");
  try {
    return found->get<T>();
  } catch (const json::exception&) {
    throw Wrong(where + "'" + key + "' is of the wrong kind");
  }
}

/// Whole numbers may be written with a point, but must fit.
int get_whole(const json& object, const char* key, const std::string& where) {
  const auto number = get<double>(object, key, where);
  constexpr double most = std::numeric_limits<int>::max();
  if (number != std::floor(number) || std::fabs(number) > most) {
    throw Wrong(where + "'" + key + "' is no whole number or too large");
  }
  return static_cast<int>(number);
}

template <class T>
T get_or(const json& object, const char* key, const std::string& where, T otherwise) {
  return object.contains(key) ? get<T>(object, key, where) : otherwise;
}

Point3 point(const json& object, const char* key, const std::string& where) {
  const auto values = get<std::vector<double>>(object, key, where);
  if (values.size() != 3)
    throw Wrong(where + "'" + key + "' has " + std::to_string(values.size()) + " numbers, not 3");
  return {values[0], values[1], values[2]};
}

void check_square(const std::array<Point3, 4>& c, const std::string& where) {
  const auto away = [](const Point3& a, const Point3& b) {
    return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
  };
  const double side = away(c[0], c[1]);
  const double diagonal = away(c[0], c[2]);
  const bool square = side > 0 && std::fabs(away(c[1], c[2]) - side) < 0.01 * side &&
                      std::fabs(away(c[2], c[3]) - side) < 0.01 * side &&
                      std::fabs(away(c[3], c[0]) - side) < 0.01 * side &&
                      std::fabs(diagonal - std::sqrt(2.0) * side) < 0.02 * side &&
                      std::fabs(away(c[1], c[3]) - diagonal) < 0.02 * side;
  if (!square) throw Wrong(where + "its corners are not those of a square, in order");
}

BoardMarker placed_marker(const json& object, const std::string& dictionary, std::size_t index) {
  const std::string where = "marker " + std::to_string(index) + " of the list: ";
  if (!object.is_object()) throw Wrong(where + "is not an object");
  BoardMarker marker;
  marker.dictionary = get_or<std::string>(object, "dictionary", where, dictionary);
  marker.id = get_whole(object, "id", where);
  if (object.contains("corners")) {
    const auto corners = get<std::vector<std::vector<double>>>(object, "corners", where);
    if (corners.size() != 4) throw Wrong(where + "has " + std::to_string(corners.size()) + " corners, not 4");
    for (std::size_t i = 0; i < 4; ++i) {
      if (corners[i].size() != 3) throw Wrong(where + "a corner needs x, y and z");
      marker.corners[i] = {corners[i][0], corners[i][1], corners[i][2]};
    }
  } else {
    const auto size = get<double>(object, "size", where);
    const Point3 turn = object.contains("rotation") ? point(object, "rotation", where) : Point3{};
    const Pose pose = pose_from(turn, point(object, "centre", where));
    const double h = size / 2;
    marker.corners = {pose({-h, -h, 0}), pose({h, -h, 0}), pose({h, h, 0}), pose({-h, h, 0})};
  }
  check_square(marker.corners, where);
  return marker;
}

Board placed(const json& root) {
  Board board;
  const auto dictionary = get_or<std::string>(root, "dictionary", "", "");
  const json& markers = root.at("markers");
  if (!markers.is_array() || markers.empty()) throw Wrong("'markers' is not a list of markers");
  for (std::size_t i = 0; i < markers.size(); ++i) {
    board.markers.push_back(placed_marker(markers[i], dictionary, i));
    for (std::size_t j = 0; j < i; ++j) {
      if (board.markers[j].id == board.markers[i].id &&
          board.markers[j].dictionary == board.markers[i].dictionary) {
        throw Wrong("marker " + std::to_string(i) + " of the list: id " +
                    std::to_string(board.markers[i].id) + " is there twice");
      }
    }
  }
  return board;
}

Board board_of(const json& root) {
  if (!root.is_object()) throw Wrong("a board is an object");
  if (root.contains("markers")) return placed(root);
  const auto type = get<std::string>(root, "type", "");
  const Dictionary dictionary = value_or_wrong(load_dictionary(get<std::string>(root, "dictionary", "")));
  if (type == "charuco") {
    CharucoLayout layout;
    layout.columns = get_whole(root, "columns", "");
    layout.rows = get_whole(root, "rows", "");
    layout.square = get<double>(root, "square", "");
    layout.marker = get<double>(root, "marker", "");
    layout.first_id = get_or(root, "first_id", "", 0);
    layout.legacy = get_or(root, "legacy", "", false);
    layout.turned = get_or(root, "turned", "", false);
    return value_or_wrong(charuco_board(dictionary, layout));
  }
  if (type == "grid") {
    GridLayout layout;
    layout.columns = get_whole(root, "columns", "");
    layout.rows = get_whole(root, "rows", "");
    layout.marker = get<double>(root, "marker", "");
    layout.gap = get<double>(root, "gap", "");
    layout.first_id = get_or(root, "first_id", "", 0);
    return value_or_wrong(grid_board(dictionary, layout));
  }
  throw Wrong("'type' is '" + type + "', not charuco or grid, and there are no 'markers'");
}

std::vector<std::string> split(const std::string& text, char by) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, by);) parts.push_back(part);
  return parts;
}

double length(const std::string& text) {
  std::size_t used = 0;
  double value = 0;
  try {
    value = std::stod(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  if (used != text.size() || text.empty()) throw Wrong("'" + text + "' is not a length");
  return value;
}

std::pair<int, int> columns_and_rows(const std::string& text) {
  const std::size_t cross = text.find('x');
  const auto digits = [](const std::string& s) {
    return !s.empty() && s.size() < 6 && s.find_first_not_of("0123456789") == std::string::npos;
  };
  if (cross == std::string::npos || !digits(text.substr(0, cross)) || !digits(text.substr(cross + 1))) {
    throw Wrong("'" + text + "' is not COLUMNSxROWS");
  }
  return {std::stoi(text.substr(0, cross)), std::stoi(text.substr(cross + 1))};
}

constexpr const char* forms =
    "a board is a .json file, charuco:DICTIONARY:COLUMNSxROWS:SQUARE:MARKER[:legacy][:turned] or "
    "grid:DICTIONARY:COLUMNSxROWS:MARKER:GAP";

Board described(const std::string& description) {
  const std::vector<std::string> parts = split(description, ':');
  if (parts.size() < 5 || (parts[0] != "charuco" && parts[0] != "grid")) throw Wrong(forms);
  const Dictionary dictionary = value_or_wrong(load_dictionary(parts[1]));
  const auto [columns, rows] = columns_and_rows(parts[2]);
  if (parts[0] == "grid") {
    if (parts.size() > 5) throw Wrong(forms);
    return value_or_wrong(grid_board(
        dictionary, {.columns = columns, .rows = rows, .marker = length(parts[3]), .gap = length(parts[4])}));
  }
  CharucoLayout layout{
      .columns = columns, .rows = rows, .square = length(parts[3]), .marker = length(parts[4])};
  for (std::size_t i = 5; i < parts.size(); ++i) {
    if (parts[i] == "legacy") {
      layout.legacy = true;
    } else if (parts[i] == "turned") {
      layout.turned = true;
    } else {
      throw Wrong(forms);
    }
  }
  return value_or_wrong(charuco_board(dictionary, layout));
}

}  // namespace

Result<Board> parse_board(std::string_view text) {
  try {
    return board_of(json::parse(text));
  } catch (const json::parse_error& error) {
    return Error{"this is no JSON: byte " + std::to_string(error.byte)};
  } catch (const std::exception& error) {
    return Error{one_line(error.what())};
  }
}

Result<Board> load_board(const std::string& description_or_path) {
  try {
    if (!description_or_path.ends_with(".json")) return described(description_or_path);
    const auto text = read_text(description_or_path, 8);
    if (!text) return Error{text.error()};
    Result<Board> board = parse_board(*text);
    if (!board) return Error{description_or_path + ": " + board.error()};
    return board;
  } catch (const std::exception& error) {
    return Error{description_or_path + ": " + error.what()};
  }
}

}  // namespace runmark
