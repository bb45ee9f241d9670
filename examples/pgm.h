#pragma once

#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

/// A grey picture and the least reader for it, so that the examples need no image library.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> grey;  ///< width * height, row-major
};

/// Reads a binary PGM (P5, 8 bits, no comments). Throws std::runtime_error with the path and what is wrong.
inline Picture read_pgm(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be opened");
  Picture picture;
  std::string magic;
  int most = 0;
  file >> magic >> picture.width >> picture.height >> most;
  file.get();
  const bool good = file && magic == "P5" && most == 255 && picture.width > 0 && picture.width < 65536 &&
                    picture.height > 0 && picture.height < 65536;
  if (!good) throw std::runtime_error(path + ": not a binary 8-bit PGM");
  picture.grey.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  file.read(reinterpret_cast<char*>(picture.grey.data()), static_cast<std::streamsize>(picture.grey.size()));
  if (!file) throw std::runtime_error(path + ": ends before its last row");
  return picture;
}
