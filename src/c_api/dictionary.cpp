#include "c_api/guard.h"
#include "c_api/handles.h"

namespace {

using namespace runmark;
using namespace runmark::c_api;

runmark_status give(Result<Dictionary> result, runmark_dictionary** dictionary, runmark_error* error) {
  if (!result) return fail(error, RUNMARK_BAD_DICTIONARY, result.error());
  *dictionary = new runmark_dictionary{*std::move(result)};
  return RUNMARK_OK;
}

}  // namespace

std::size_t runmark_builtin_count() { return dictionary_names().size(); }

const char* runmark_builtin_name(std::size_t index) {
  const auto names = dictionary_names();
  return index < names.size() ? names[index].data() : nullptr;  // views of string literals
}

runmark_status runmark_dictionary_load(const char* name_or_path, runmark_dictionary** dictionary,
                                       runmark_error* error) {
  return guarded(error, [&] {
    if (name_or_path == nullptr || dictionary == nullptr) return fail(error, RUNMARK_BAD_ARGUMENT);
    *dictionary = nullptr;
    return give(load_dictionary(name_or_path), dictionary, error);
  });
}

runmark_status runmark_dictionary_parse(const char* text, std::size_t size, const char* name,
                                        runmark_dictionary** dictionary, runmark_error* error) {
  return guarded(error, [&] {
    if (text == nullptr || name == nullptr || dictionary == nullptr) return fail(error, RUNMARK_BAD_ARGUMENT);
    *dictionary = nullptr;
    return give(parse_codes({text, size}, name), dictionary, error);
  });
}

void runmark_dictionary_free(runmark_dictionary* dictionary) { delete dictionary; }

runmark_status runmark_get_dictionary_info(const runmark_dictionary* dictionary,
                                           runmark_dictionary_info* info) {
  if (dictionary == nullptr || info == nullptr) return RUNMARK_BAD_ARGUMENT;
  const Dictionary& d = dictionary->value;
  *info = {d.name.c_str(),   static_cast<std::int32_t>(d.codes.size()),
           d.width,          static_cast<std::int32_t>(d.cells.size()),
           d.corrected_bits, d.distance};
  return RUNMARK_OK;
}
