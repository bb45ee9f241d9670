#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

namespace runmark {

/// The intervals between rising edges, open at both ends: "<12", "12-16", ">=16".
class Buckets {
 public:
  Buckets(std::initializer_list<double> edges) : edges_(edges) {}

  [[nodiscard]] std::size_t count() const { return edges_.size() + 1; }

  /// The bucket that holds the value: at or above its lower edge, below its upper one.
  [[nodiscard]] std::size_t place(double value) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(edges_, value) - edges_.begin());
  }

  [[nodiscard]] std::string label(std::size_t place) const {
    if (place == 0) return "<" + number(edges_.front());
    if (place == edges_.size()) return ">=" + number(edges_.back());
    return number(edges_[place - 1]) + "-" + number(edges_[place]);
  }

 private:
  static std::string number(double edge) {
    std::string text = std::to_string(edge);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
  }

  std::vector<double> edges_;
};

/// By size of a marker in pixels, the square root of its area.
inline const Buckets size_buckets{8, 12, 16, 24, 32, 48, 64, 100, 200};

}  // namespace runmark
