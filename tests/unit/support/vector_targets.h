#pragma once

#include <hwy/targets.h>

#include <cstdint>
#include <vector>

namespace runmark::test {

/// The vector extensions compiled in that this processor has, a bit of Highway's each; SCALAR is the plain
/// form.
inline std::vector<std::int64_t> vector_targets() {
  std::vector<std::int64_t> all;
  for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1)
    all.push_back(left & -left);
  return all;
}

/// From now on only these are used; 0 stands for all.
inline void use_vector_targets(std::int64_t targets) {
  hwy::SetSupportedTargetsForTest(targets);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

/// Calls `work(target)` for every extension, while only that one is used.
template <class Work>
void on_every_vector_target(Work&& work) {
  for (const std::int64_t target : vector_targets()) {
    use_vector_targets(target);
    work(target);
    use_vector_targets(0);
  }
}

}  // namespace runmark::test
