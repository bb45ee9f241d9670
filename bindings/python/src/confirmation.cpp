#include "runmark/confirmation.h"

#include <algorithm>
#include <string>

#include "confirmation.h"
#include "detection.h"

namespace py = pybind11;

namespace runmark::python {
namespace {

constexpr const char* confirmation_doc =
    R"(Tells the markers of a video from what was taken for one in a single frame.

frames  in how many frames a marker must be seen, at most so many frames apart, each time no farther from where it was
        than its side is long for each frame that has passed)";

/// Keeps the names of dictionaries alive that the markers refer to.
struct Confirmer {
  Confirmation confirmation;
  std::vector<Dictionaries> dictionaries;
};

FoundMarkers next(Confirmer& self, const FoundMarkers& found) {
  if (std::ranges::find(self.dictionaries, found.dictionaries) == self.dictionaries.end()) {
    self.dictionaries.push_back(found.dictionaries);
  }
  FoundMarkers confirmed = found;
  const std::span<const Marker> markers = self.confirmation.next(found.markers);
  confirmed.markers.assign(markers.begin(), markers.end());
  return confirmed;
}

}  // namespace

void bind_confirmation(py::module_& module) {
  py::class_<Confirmer>(module, "Confirmation", confirmation_doc)
      .def(py::init([](int frames) {
             if (frames < 1)
               throw py::value_error("frames " + std::to_string(frames) + ": must be at least 1");
             return Confirmer{Confirmation(frames), {}};
           }),
           py::arg("frames"))
      .def("next", &next, py::arg("detection"), "The next frame's Detection with the confirmed markers only.")
      .def(
          "restart",
          [](Confirmer& self) {
            self.confirmation.restart();
            self.dictionaries.clear();
          },
          "The frames that follow are of another video.");
}

}  // namespace runmark::python
