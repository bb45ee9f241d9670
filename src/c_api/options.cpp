#include "c_api/options.h"

#include <array>
#include <string>

#include "c_api/number.h"

namespace runmark::c_api {
namespace {

constexpr std::array pipelines{Pipeline::paper, Pipeline::hardware, Pipeline::standard};
constexpr std::array connectivities{Connectivity::standard, Connectivity::four, Connectivity::eight};

}  // namespace

Result<Options> to_options(const runmark_options& c) {
  if (c.abi_version != RUNMARK_ABI_VERSION) {
    return Error{"options of ABI version " + std::to_string(c.abi_version) + ", the library has " +
                 std::to_string(RUNMARK_ABI_VERSION) + "; runmark_options_init fills them"};
  }
  const auto unknown = [](const char* name, unsigned value) {
    return Error{std::string(name) + " " + std::to_string(value) + ": there is none of that number"};
  };
  const unsigned pipeline = number(c.pipeline);
  const unsigned connectivity = number(c.connectivity);
  if (pipeline >= pipelines.size()) return unknown("pipeline", pipeline);
  if (connectivity >= connectivities.size()) return unknown("connectivity", connectivity);
  if (c.filter < 0 || c.filter > filter_standard) {
    return Error{"filter " + std::to_string(c.filter) + ": must be 0 to 63, or RUNMARK_FILTER_DEFAULT"};
  }
  Options o;
  o.pipeline = pipelines[pipeline];
  o.max_width = c.max_width;
  o.max_height = c.max_height;
  o.region = {c.region[0], c.region[1], c.region[2], c.region[3]};
  o.min_marker_size = c.min_marker_size;
  o.max_marker_size = c.max_marker_size;
  o.inverted = c.inverted != 0;
  o.corrected_bits = c.corrected_bits;
  o.min_margin = c.min_margin;
  o.filter = static_cast<std::uint8_t>(c.filter);
  o.connectivity = connectivities[connectivity];
  o.min_contrast = c.min_contrast;
  o.fixed_threshold = c.fixed_threshold;
  o.above_is_dark = c.above_is_dark != 0;
  o.corner_offset = c.corner_offset;
  o.octaves = c.octaves;
  o.copy_rows = c.copy_rows != 0;
  o.keep_rejected = c.keep_rejected != 0;
  return o;
}

}  // namespace runmark::c_api

runmark_status runmark_options_init(runmark_options* options, std::uint32_t abi_version) {
  if (options == nullptr) return RUNMARK_BAD_ARGUMENT;
  if (abi_version != RUNMARK_ABI_VERSION) return RUNMARK_BAD_OPTIONS;
  const runmark::Options o;
  *options = {};
  options->abi_version = RUNMARK_ABI_VERSION;
  options->pipeline = RUNMARK_PIPELINE_DEFAULT;
  options->max_width = o.max_width;
  options->max_height = o.max_height;
  options->min_marker_size = o.min_marker_size;
  options->max_marker_size = o.max_marker_size;
  options->corrected_bits = o.corrected_bits;
  options->min_margin = o.min_margin;
  options->filter = RUNMARK_FILTER_DEFAULT;
  options->connectivity = RUNMARK_CONNECTIVITY_DEFAULT;
  options->min_contrast = o.min_contrast;
  options->fixed_threshold = o.fixed_threshold;
  options->corner_offset = o.corner_offset;
  options->octaves = o.octaves;
  return RUNMARK_OK;
}
