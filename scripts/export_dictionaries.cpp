// Writes data/dictionaries/*.codes from OpenCV's and AprilTag's own tables and the MIP files of the real
// image set. Run by scripts/export-dictionaries.

#include <apriltag/apriltag.h>
#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h10.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagCircle21h7.h>
#include <apriltag/tagCircle49h12.h>
#include <apriltag/tagCustom48h12.h>
#include <apriltag/tagStandard41h12.h>
#include <apriltag/tagStandard52h13.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <opencv2/aruco.hpp>
#include <string>

#include "dictionary/cell_rotation.h"
#include "dictionary/code_distance.h"
#include "runmark/dictionary.h"

namespace {

using runmark::Border;
using runmark::Cell;
using runmark::Dictionary;

std::vector<Cell> square_cells(int per_side) {
  std::vector<Cell> cells;
  for (int y = 1; y <= per_side; ++y) {
    for (int x = 1; x <= per_side; ++x) {
      cells.push_back({static_cast<std::int8_t>(x), static_cast<std::int8_t>(y)});
    }
  }
  return cells;
}

void write(Dictionary dictionary, const std::string& source, const std::filesystem::path& folder) {
  const std::size_t bits = dictionary.cells.size();
  dictionary.distance = runmark::least_distance(dictionary);
  dictionary.corrected_bits =
      runmark::safe_corrected_bits(bits, dictionary.codes.size(), dictionary.distance);
  const int per_side = dictionary.width - 2;

  std::ofstream out(folder / (dictionary.name + ".codes"));
  out << "# " << dictionary.name << ": " << dictionary.codes.size() << " codes of " << bits
      << " bits\n# from " << source << ", by scripts/export-dictionaries\n"
      << per_side << " " << dictionary.corrected_bits << "\n";
  if (dictionary.border == Border::reversed) out << "border reversed\n";
  out << "distance " << dictionary.distance << "\n";
  if (dictionary.cells != square_cells(per_side)) {
    for (std::size_t i = 0; i < bits; ++i) {
      out << (i % 12 == 0 ? i == 0 ? "cells" : "\ncells" : "") << " " << int{dictionary.cells[i].x} << ","
          << int{dictionary.cells[i].y};
    }
    out << "\n";
  }
  const runmark::CellRotation rotation(dictionary.cells, dictionary.width);
  for (std::size_t id = 0; id < dictionary.codes.size(); ++id) {
    if (rotation.is_own(dictionary.codes[id])) out << "symmetric " << id << "\n";
  }
  out << std::hex << std::setfill('0');
  for (const std::uint64_t code : dictionary.codes) {
    out << std::setw(static_cast<int>((bits + 3) / 4)) << code << "\n";
  }
  std::cout << dictionary.name << ": " << dictionary.codes.size() << " codes, " << bits << " bits, distance "
            << dictionary.distance << ", corrects " << dictionary.corrected_bits << std::endl;
  if (!out.flush()) throw std::runtime_error("cannot write " + dictionary.name + ".codes");
}

Dictionary from_opencv(const std::string& name, int predefined) {
  const auto source = cv::aruco::getPredefinedDictionary(predefined);
  Dictionary dictionary{name, source->markerSize + 2, Border::black, square_cells(source->markerSize), {}};
  for (int id = 0; id < source->bytesList.rows; ++id) {
    const cv::Mat bits =
        cv::aruco::Dictionary::getBitsFromByteList(source->bytesList.row(id), source->markerSize);
    std::uint64_t code = 0;
    for (const std::uint8_t bit : cv::Mat_<std::uint8_t>(bits)) code = code << 1U | bit;
    dictionary.codes.push_back(code);
  }
  return dictionary;
}

/// The files of 50, 100 and 250 codes are not written: they must be the first codes of the largest.
void write_opencv(const std::string& name, std::initializer_list<int> smaller, int largest,
                  const std::filesystem::path& folder) {
  const Dictionary dictionary = from_opencv(name, largest);
  for (const int predefined : smaller) {
    const auto part = from_opencv(name, predefined).codes;
    if (!std::equal(part.begin(), part.end(), dictionary.codes.begin())) {
      throw std::runtime_error(name + ": a smaller dictionary is not its beginning");
    }
  }
  write(dictionary, "OpenCV " CV_VERSION " (aruco)", folder);
}

/// Full squares become row-major; other families keep their own order of bits, and so their own codes.
void write_apriltag(apriltag_family_t* family, const std::filesystem::path& folder) {
  Dictionary dictionary{family->name,
                        family->width_at_border,
                        family->reversed_border ? Border::reversed : Border::black,
                        {},
                        {}};
  for (std::uint32_t i = 0; i < family->nbits; ++i) {
    dictionary.cells.push_back(
        {static_cast<std::int8_t>(family->bit_x[i]), static_cast<std::int8_t>(family->bit_y[i])});
  }
  dictionary.codes.assign(family->codes, family->codes + family->ncodes);
  const auto rows = square_cells(family->width_at_border - 2);
  if (std::is_permutation(rows.begin(), rows.end(), dictionary.cells.begin(), dictionary.cells.end())) {
    for (std::uint64_t& code : dictionary.codes) {
      std::uint64_t in_rows = 0;
      for (const Cell c : rows) {
        const auto bit =
            std::find(dictionary.cells.begin(), dictionary.cells.end(), c) - dictionary.cells.begin();
        in_rows = in_rows << 1U | (code >> (family->nbits - 1 - static_cast<std::uint32_t>(bit)) & 1U);
      }
      code = in_rows;
    }
    dictionary.cells = rows;
  }
  write(dictionary, "AprilTag 3.3.0", folder);
}

void write_mip(const std::string& name, const std::filesystem::path& from,
               const std::filesystem::path& folder) {
  std::ifstream in(from / (name + ".codes"));
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  auto dictionary = runmark::parse_codes(text, name);
  if (!dictionary) throw std::runtime_error(dictionary.error());
  write(*dictionary, "the UCO ArUco library 3 (via the real image set)", folder);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::cerr << "usage: export_dictionaries MIP_FOLDER OUTPUT_FOLDER\n";
    return 2;
  }
  const std::filesystem::path mip = argv[1];
  const std::filesystem::path out = argv[2];
  namespace a = cv::aruco;
  write_opencv("DICT_4X4_1000", {a::DICT_4X4_50, a::DICT_4X4_100, a::DICT_4X4_250}, a::DICT_4X4_1000, out);
  write_opencv("DICT_5X5_1000", {a::DICT_5X5_50, a::DICT_5X5_100, a::DICT_5X5_250}, a::DICT_5X5_1000, out);
  write_opencv("DICT_6X6_1000", {a::DICT_6X6_50, a::DICT_6X6_100, a::DICT_6X6_250}, a::DICT_6X6_1000, out);
  write_opencv("DICT_7X7_1000", {a::DICT_7X7_50, a::DICT_7X7_100, a::DICT_7X7_250}, a::DICT_7X7_1000, out);
  write_opencv("DICT_ARUCO_ORIGINAL", {}, a::DICT_ARUCO_ORIGINAL, out);
  for (const char* name : {"ARUCO_MIP_16h3", "ARUCO_MIP_25h7", "ARUCO_MIP_36h12"}) write_mip(name, mip, out);
  write_apriltag(tag16h5_create(), out);
  write_apriltag(tag25h9_create(), out);
  write_apriltag(tag36h10_create(), out);
  write_apriltag(tag36h11_create(), out);
  write_apriltag(tagCircle21h7_create(), out);
  write_apriltag(tagCircle49h12_create(), out);
  write_apriltag(tagStandard41h12_create(), out);
  write_apriltag(tagStandard52h13_create(), out);
  write_apriltag(tagCustom48h12_create(), out);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "export_dictionaries: " << error.what() << "\n";
  return 2;
}
