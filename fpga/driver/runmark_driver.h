/* Drives the runmark core (fpga/rtl/runmark_top.sv) through its registers (docs/registers.md). Needs nothing
 * but C99 and a way to read and write a 32-bit register: on a Zynq a volatile pointer, in simulation an
 * AXI4-Lite transfer. No function waits for the core, keeps state or allocates. */
#ifndef RUNMARK_DRIVER_H
#define RUNMARK_DRIVER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
  uint32_t (*read)(void* context, uint32_t at);
  void (*write)(void* context, uint32_t at, uint32_t value);
  void* context;
} runmark_device;

typedef struct {
  uint16_t width, height; /* pixels */
  uint16_t threshold;     /* paper profile: grey level, 0 to 256 */
  uint8_t filter;         /* cases (a) to (f) in bits 0 to 5 */
  uint8_t max_turns;      /* of a chain, 1 to 31 */
  uint16_t min_height;    /* of a chain, pixels */
  uint8_t corner_offset;  /* paper profile: pixels, from 1 */
  uint8_t max_errors;     /* wrong bits of a marker, to 63 */
  uint32_t min_area;      /* of a marker, half pixels; hardware profile: pixels */
  uint32_t max_area;      /* 0xFFFFFFFF: no limit */
  uint8_t min_contrast;   /* hardware profile: of dark and light, grey levels */
  uint16_t min_side;      /* hardware profile: of a marker, pixels */
  uint8_t cells;          /* hardware profile: along a marker's side, border included, 6 to 10 */
  uint8_t min_margin;     /* hardware profile: in 1/256 of the contrast */
  uint32_t control;       /* RUNMARK_CONTROL_ bits; RUN is left to runmark_run */
  uint32_t frame_address; /* where the core may keep two grey frames; a multiple of 4096 */
} runmark_settings;

/* One record of results: a marker, or the end of a frame. */
typedef struct {
  int end_of_frame;
  uint16_t id; /* at the end of a frame its number, counted from 0 at reset */
  uint8_t rotation, errors, inverted;
  uint16_t bottom; /* crack line on which the outline closed: one below the marker's last row */
  /* Top-left, top-right, bottom-right, bottom-left as drawn. Paper profile: cracks, pixels are x - 0.5;
   * hardware profile (fine): sixteenths of a pixel, pixels are x / 16. */
  int32_t x[4], y[4];
  int fine;
  uint32_t clearance, scale;        /* fine: one over the other is the decision margin */
  uint8_t malformed, lost, dropped; /* end: the frame had bad lines, was given up, had chains dropped */
  uint16_t record_peak, end_peak;   /* end: most records and open ends at once */
} runmark_record;

enum { RUNMARK_MARKER_WORDS = 6, RUNMARK_FINE_MARKER_WORDS = 12, RUNMARK_END_WORDS = 2 };

typedef enum {
  RUNMARK_OK = 0,
  RUNMARK_NO_CORE,     /* ID does not answer as a runmark core does */
  RUNMARK_BAD_SIZE,    /* frame below 3x3 (hardware profile: 16x3) or larger than the core was built for */
  RUNMARK_BAD_SETTING, /* another setting is out of its range */
  RUNMARK_TOO_MANY_CODES
} runmark_status;

/* Sets everything and stops the core. Frames under way end as they would have. */
runmark_status runmark_configure(const runmark_device* device, const runmark_settings* settings);
/* Loads the dictionary: row by row, bit 0 of a code the bottom-right cell, 1 = white; paper profile: 36 bits.
 * Only while the core is stopped and no frame is open. */
runmark_status runmark_load_codes(const runmark_device* device, const uint64_t* codes, unsigned count);
/* Takes in frames from the next start of frame on, or stops at the next start of frame. */
void runmark_run(const runmark_device* device, int run);
/* Offers one beat of video (RUNMARK_CONTROL_FEED): 1, or 0 when the core cannot take it yet. */
int runmark_feed(const runmark_device* device, uint32_t pixel, int first_of_frame, int last_of_line);
/* The next record from the result register (RUNMARK_CONTROL_READ_RESULTS): 1, or 0 when there is none. */
int runmark_next_result(const runmark_device* device, runmark_record* record);
/* Reads a record from its words, as a DMA of the result stream leaves them: how many words it took. */
unsigned runmark_read_record(const uint32_t* words, runmark_record* record);

#ifdef __cplusplus
}
#endif

#endif
