#pragma once

#include "runmark/detector.h"
#include "runmark/dictionary.h"
#include "runmark/runmark.h"

struct runmark_dictionary {
  runmark::Dictionary value;
};

struct runmark_detector {
  runmark::Detector value;
};
