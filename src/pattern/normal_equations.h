#pragma once

#include <array>
#include <cstddef>

namespace runmark {

/// Normal equations of weighted least squares for twelve parameters. Every sum takes the observations in
/// their order, so all vector extensions give the same bits.
class NormalEquations {
 public:
  static constexpr std::size_t parameters = 12;
  using Step = std::array<double, parameters>;

  /// One observation: how it changes with each parameter, and what is left of it to explain.
  struct Observation {
    static constexpr std::size_t size = 16;
    static constexpr std::size_t rest = parameters;
    alignas(64) std::array<float, size> values;  ///< slopes, `rest`, zeros
    std::array<float, parameters> weighted;      ///< the slopes times the weight
  };

  void add(const Observation* observations, std::size_t count);

  /// Holds a parameter near what it is, as if so much had been seen of it.
  void hold(std::size_t parameter, double weight) { held_[parameter] += weight; }

  /// The step to the least sum of squares, by Cholesky's decomposition; false when some direction is not
  /// held.
  [[nodiscard]] bool solve(Step& step) const;

 private:
  std::array<std::array<float, Observation::size>, parameters> sums_{};
  Step held_{};
};

}  // namespace runmark
