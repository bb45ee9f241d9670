// Nanoseconds for one look-up of a code: of clutter (a miss), and of a code with as many wrong bits as are
// corrected (a hit); and what a dictionary takes to load.

#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <string>

#include "pattern/code_lookup.h"

namespace {

constexpr std::size_t samples = 1024;

void find(benchmark::State& state, const runmark::Dictionary& dictionary, bool hit) {
  const runmark::CodeLookup lookup(dictionary, dictionary.corrected_bits);
  const std::size_t bits = dictionary.cells.size();
  std::mt19937_64 random(1);
  std::array<std::uint64_t, samples> sampled{};
  for (std::uint64_t& code : sampled) {
    code = random() >> (64 - bits);
    if (!hit) continue;
    code = dictionary.codes[random() % dictionary.codes.size()];
    for (int i = 0; i < dictionary.corrected_bits; ++i) code ^= std::uint64_t{1} << random() % bits;
  }
  std::size_t next = 0;
  for (auto _ : state) benchmark::DoNotOptimize(lookup.find(sampled[next++ % samples]));
  state.counters["kB"] = static_cast<double>(lookup.memory()) / 1024;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  for (const std::string_view name : runmark::dictionary_names()) {
    if (name.starts_with("DICT_APRILTAG")) continue;  // the tag families under another name
    const std::string text(name);
    const auto dictionary = runmark::builtin_dictionary(name);
    benchmark::RegisterBenchmark(("miss/" + text).c_str(),
                                 [=](auto& state) { find(state, *dictionary, false); });
    benchmark::RegisterBenchmark(("hit/" + text).c_str(),
                                 [=](auto& state) { find(state, *dictionary, true); });
    benchmark::RegisterBenchmark(("load/" + text).c_str(), [=](auto& state) {
      for (auto _ : state) benchmark::DoNotOptimize(runmark::builtin_dictionary(text));
    });
  }
  benchmark::RunSpecifiedBenchmarks();
}
