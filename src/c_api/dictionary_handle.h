#pragma once

#include "runmark/dictionary.h"
#include "runmark/runmark.h"

struct runmark_dictionary {
  runmark::Dictionary value;
};
