#include "pattern/unblur.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace runmark {
namespace {

constexpr int stride = most_cells_across + 2;
using Grid = std::array<float, stride * stride>;

[[nodiscard]] constexpr int place(int x, int y) { return (y + 1) * stride + x + 1; }

/// What a cell gives to itself and its eight neighbours.
struct Kernel {
  float across[3];
  float down[3];
  float shares[3][3] = {};  // down by across
  float energy = 0;         // the sum of the shares' squares

  Kernel(float a, float d) : across{a, 1 - 2 * a, a}, down{d, 1 - 2 * d, d} {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) shares[j][i] = down[j] * across[i];
    }
    energy = (2 * a * a + across[1] * across[1]) * (2 * d * d + down[1] * down[1]);
  }
  /// The kernel's overlap with the grid about a cell.
  [[nodiscard]] float over(const Grid& grid, int x, int y) const {
    const auto along = [&](const float* row, const float* share) {
      return share[0] * row[0] + share[1] * row[1] + share[2] * row[2];
    };
    const float* row = &grid[static_cast<std::size_t>(place(x - 1, y - 1))];
    return along(row, shares[0]) + along(row + stride, shares[1]) + along(row + 2 * stride, shares[2]);
  }
};

/// The search: the cells as they may have been, from 0 to 1, and what their picture leaves unexplained.
class Search {
 public:
  Search(const CellValues& values, std::span<const Cell> cells, const Kernel& kernel)
      : values_(values), cells_(cells), kernel_(kernel) {
    truth_.fill(1);
    for (int y = 0; y < values.width; ++y) {
      for (int x = 0; x < values.width; ++x) truth_[at(x, y)] = 0;
    }
    for (const Cell cell : cells) truth_[at(cell.x, cell.y)] = 0.5F;
  }

  /// Black and white level by least squares; false when there is too little between them.
  [[nodiscard]] bool fit_levels() {
    constexpr float least_contrast = 0.25F;
    Grid picture;
    draw(picture);
    float sp = 0;
    float sv = 0;
    float spp = 0;
    float spv = 0;
    for (int y = 0; y < values_.width; ++y) {
      for (int x = 0; x < values_.width; ++x) {
        const float p = picture[at(x, y)];
        const float v = values_.at(x, y);
        sp += p;
        sv += v;
        spp += p * p;
        spv += p * v;
      }
    }
    const auto n = static_cast<float>(values_.width * values_.width);
    const float spread = spp - sp * sp / n;
    const float rise = spv - sp * sv / n;
    if (rise < least_contrast * spread || spread <= 0) return false;
    const float contrast = rise / spread;
    const float black = (sv - contrast * sp) / n;
    for (int y = 0; y < values_.width; ++y) {
      for (int x = 0; x < values_.width; ++x) {
        rest_[at(x, y)] = (values_.at(x, y) - black) / contrast - picture[at(x, y)];
      }
    }
    return true;
  }

  /// Every cell in turn to where the picture is nearest.
  void relax() {
    const float per_energy = 1 / kernel_.energy;
    for (const Cell cell : cells_) {
      const float now = truth_[at(cell.x, cell.y)];
      const float best = now + kernel_.over(rest_, cell.x, cell.y) * per_energy;
      change(cell, std::min(std::max(best, 0.0F), 1.0F) - now);
    }
  }

  void round() {
    for (const Cell cell : cells_) {
      const float now = truth_[at(cell.x, cell.y)];
      change(cell, (now > 0.5F ? 1.0F : 0.0F) - now);
    }
  }

  /// Turns over every cell that brings the picture nearer; whether there was one.
  [[nodiscard]] bool improve() {
    bool turned = false;
    for (const Cell cell : cells_) {
      if (cost(cell) >= 0) continue;
      change(cell, 1 - 2 * truth_[at(cell.x, cell.y)]);
      turned = true;
    }
    return turned;
  }

  [[nodiscard]] Unblurred result() const {
    Unblurred result;
    for (const Cell cell : cells_) {
      result.code = result.code << 1 | (truth_[at(cell.x, cell.y)] > 0.5F ? 1U : 0U);
      result.margin += std::clamp(cost(cell) / (2 * kernel_.energy), 0.0F, 0.5F);
    }
    result.margin /= static_cast<float>(cells_.size());
    return result;
  }

 private:
  /// The blurred picture of the cells: the kernel over all of them, along the rows first.
  void draw(Grid& picture) const {
    const int width = values_.width;
    Grid along;  // NOLINT(*-member-init): filled as far as used
    for (int y = -1; y <= width; ++y) {
      const float* from = &truth_[at(0, y)];
      float* to = &along[at(0, y)];
      for (int x = 0; x < width; ++x) {
        to[x] =
            kernel_.across[0] * from[x - 1] + kernel_.across[1] * from[x] + kernel_.across[2] * from[x + 1];
      }
    }
    for (int y = 0; y < width; ++y) {
      const float* from = &along[at(0, y)];
      float* to = &picture[at(0, y)];
      for (int x = 0; x < width; ++x) {
        to[x] = kernel_.down[0] * from[x - stride] + kernel_.down[1] * from[x] +
                kernel_.down[2] * from[x + stride];
      }
    }
  }

  [[nodiscard]] static std::size_t at(int x, int y) { return static_cast<std::size_t>(place(x, y)); }

  /// By how much turning a rounded cell over takes the picture away from the values.
  [[nodiscard]] float cost(Cell cell) const {
    const float step = 1 - 2 * truth_[at(cell.x, cell.y)];
    return kernel_.energy - 2 * step * kernel_.over(rest_, cell.x, cell.y);
  }

  void change(Cell cell, float step) {
    truth_[at(cell.x, cell.y)] += step;
    if (cell.x > 0 && cell.y > 0 && cell.x + 1 < values_.width && cell.y + 1 < values_.width) {
      float* rest = &rest_[at(cell.x - 1, cell.y - 1)];
      for (int j = 0; j < 3; ++j, rest += stride) {
        for (int i = 0; i < 3; ++i) rest[i] -= step * kernel_.shares[j][i];
      }
      return;
    }
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        const int x = cell.x + i;
        const int y = cell.y + j;
        if (x < 0 || y < 0 || x >= values_.width || y >= values_.width) continue;
        rest_[at(x, y)] -= step * kernel_.shares[j + 1][i + 1];
      }
    }
  }

  const CellValues& values_;
  std::span<const Cell> cells_;
  const Kernel& kernel_;
  Grid truth_{};
  Grid rest_{};  // 0 round the marker
};

}  // namespace

float spill(double blur) {
  constexpr double step = 0.15;
  constexpr std::array shares{0.0, 0.0004, 0.0478, 0.1328, 0.1961, 0.2297, 0.2415, 0.2405};
  const double place = std::min(blur / step, shares.size() - 1.001);
  const auto below = static_cast<std::size_t>(place);
  return static_cast<float>(shares[below] +
                            (place - static_cast<double>(below)) * (shares[below + 1] - shares[below]));
}

Unblurred unblur(const CellValues& values, std::span<const Cell> cells, float across, float down) {
  constexpr int relaxations = 6;
  constexpr int most_rounds = 4;
  const Kernel kernel(across, down);
  Search search(values, cells, kernel);
  for (int i = 0; i < relaxations; ++i) {
    if (!search.fit_levels()) return {};
    search.relax();
  }
  search.round();
  for (int i = 0; i < most_rounds; ++i) {
    if (!search.fit_levels()) return {};
    if (!search.improve()) break;
  }
  return search.result();
}

}  // namespace runmark
