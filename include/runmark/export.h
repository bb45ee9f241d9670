#pragma once

/// Marks what the shared library exports; everything else is compiled hidden.
#if defined(__GNUC__)
#define RUNMARK_EXPORT __attribute__((visibility("default")))
#else
#define RUNMARK_EXPORT
#endif
