#include "evaluate/scores.h"

#include <algorithm>
#include <map>

#include "evaluate/buckets.h"

namespace runmark {
namespace {

// A breakdown while it grows: rows by their place in the order, then by their label.
class Split {
 public:
  explicit Split(std::string name) : name_(std::move(name)) {}

  Tally& row(std::size_t place, const std::string& label) { return rows_[{place, label}]; }
  Tally& row(const std::string& label) { return row(0, label); }
  Tally& row(const Buckets& buckets, double value) {
    const std::size_t place = buckets.place(value);
    return row(place, buckets.label(place));
  }

  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] Breakdown finish() && {
    Breakdown breakdown{std::move(name_), {}};
    for (auto& [key, tally] : rows_) breakdown.rows.emplace_back(key.second, std::move(tally));
    return breakdown;
  }

 private:
  std::string name_;
  std::map<std::pair<std::size_t, std::string>, Tally> rows_;
};

// Sizes of the project, and sides as the real photos' own scoring script splits them.
const Buckets side_buckets{20, 40, 100};
const Buckets tilt_buckets{15, 30, 45, 60};
const Buckets blur_buckets{0.5, 1, 1.5, 2};
const Buckets motion_buckets{1, 2, 4, 6};
const Buckets noise_buckets{1, 2, 4, 6};
const Buckets contrast_buckets{30, 60, 100, 150};

class Scorer {
 public:
  void add(const TruthImage& image, const ImageObservations& seen) {
    const ImageMatch matches = match(image, seen.markers);
    ++scores_.images;
    for (std::size_t i = 0; i < image.markers.size(); ++i) {
      add_marker(image, image.markers[i], matches.markers[i]);
    }
    for (std::size_t i = 0; i < seen.markers.size(); ++i) {
      add_report(image, seen.markers[i], matches.reports[i]);
    }
    if (seen.milliseconds) scores_.milliseconds.push_back(*seen.milliseconds);
  }

  Scores finish() && {
    for (Split* split :
         {&size_, &side_, &tilt_, &blur_, &motion_, &noise_, &contrast_, &dictionary_, &source_}) {
      if (!split->empty()) scores_.breakdowns.push_back(std::move(*split).finish());
    }
    std::ranges::sort(scores_.milliseconds);
    return std::move(scores_);
  }

 private:
  void add_marker(const TruthImage& image, const TruthMarker& marker, const MarkerMatch& found) {
    const auto count = [&](Tally& tally) { tally.add(marker, found); };
    count(scores_.total);
    count(size_.row(size_buckets, marker_size(marker.corners)));
    count(side_.row(side_buckets, mean_side(marker.corners)));
    if (marker.tilt) count(tilt_.row(tilt_buckets, *marker.tilt));
    if (marker.blur) count(blur_.row(blur_buckets, *marker.blur));
    if (marker.motion) count(motion_.row(motion_buckets, *marker.motion));
    if (marker.noise) count(noise_.row(noise_buckets, *marker.noise));
    if (marker.contrast) count(contrast_.row(contrast_buckets, *marker.contrast));
    count(dictionary_.row(dictionary_of(image)));
    if (!image.source.empty()) count(source_.row(image.source));
    using enum Mistake::Kind;
    if (found.found() && found.rotation == 0) return;
    const auto kind = found.found() ? rotated : found.observation < 0 ? missed : bad_corner;
    scores_.mistakes.push_back({kind, image.image, marker.id, marker.corners});
  }

  void add_report(const TruthImage& image, const Observation& report, ReportKind kind) {
    scores_.total.add(kind);
    dictionary_.row(dictionary_of(image)).add(kind);
    if (!image.source.empty()) source_.row(image.source).add(kind);
    if (kind != ReportKind::false_alarm) return;
    scores_.mistakes.push_back({Mistake::Kind::false_alarm, image.image, report.id, report.corners});
  }

  static std::string dictionary_of(const TruthImage& image) { return image.dictionary.value_or("none"); }

  Scores scores_;
  Split size_{"size"};
  Split side_{"side"};
  Split tilt_{"tilt"};
  Split blur_{"blur"};
  Split motion_{"motion"};
  Split noise_{"noise"};
  Split contrast_{"contrast"};
  Split dictionary_{"dictionary"};
  Split source_{"source"};
};

}  // namespace

std::string_view name_of(Mistake::Kind kind) {
  switch (kind) {
    case Mistake::Kind::missed:
      return "missed";
    case Mistake::Kind::bad_corner:
      return "bad corner";
    case Mistake::Kind::rotated:
      return "rotated";
    case Mistake::Kind::false_alarm:
      return "false alarm";
  }
  return "";
}

Scores score(const std::vector<TruthImage>& truth, const Observations& observations) {
  Scorer scorer;
  for (const TruthImage& image : truth) {
    const auto seen = observations.find(image.image);
    scorer.add(image, seen == observations.end() ? ImageObservations{} : seen->second);
  }
  return std::move(scorer).finish();
}

}  // namespace runmark
