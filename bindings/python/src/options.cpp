#include "options.h"

namespace py = pybind11;

namespace runmark::python {

Pipeline pipeline_of(const std::string& name) {
  if (name == "default") return Pipeline::standard;
  if (name == "paper") return Pipeline::paper;
  if (name == "hardware") return Pipeline::hardware;
  throw py::value_error("pipeline '" + name + "': must be 'default', 'paper' or 'hardware'");
}

Connectivity connectivity_of(std::optional<int> neighbours) {
  if (!neighbours) return Connectivity::standard;
  if (*neighbours == 4) return Connectivity::four;
  if (*neighbours == 8) return Connectivity::eight;
  throw py::value_error("connectivity " + std::to_string(*neighbours) + ": must be 4, 8 or None");
}

std::uint8_t filter_of(const std::optional<std::string>& cases) {
  if (!cases) return filter_standard;
  unsigned bits = filter_none;
  for (const char letter : *cases) {
    if (letter < 'a' || letter > 'f') {
      throw py::value_error("filter '" + *cases + "': must be letters from a to f, '' or None");
    }
    bits |= 1U << static_cast<unsigned>(letter - 'a');
  }
  return static_cast<std::uint8_t>(bits);
}

}  // namespace runmark::python
