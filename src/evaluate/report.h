#pragma once

#include <iosfwd>

#include "evaluate/scores.h"

namespace runmark {

/// The whole result as tables for a person.
void write_text(std::ostream& out, const Scores& scores);

/// One JSON object: totals, breakdowns, mistakes, times. See docs/evaluation.md for its members.
void write_json(std::ostream& out, const Scores& scores);

/// One line a row of a breakdown, "total" first.
void write_csv(std::ostream& out, const Scores& scores);

}  // namespace runmark
