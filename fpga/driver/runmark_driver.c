#include "runmark_driver.h"

#include "runmark_registers.h"

#define FIELD(word, name) ((word) >> name##_SHIFT & name##_MASK)

static uint32_t get(const runmark_device* device, uint32_t at) { return device->read(device->context, at); }

static void set(const runmark_device* device, uint32_t at, uint32_t value) {
  device->write(device->context, at, value);
}

runmark_status runmark_configure(const runmark_device* device, const runmark_settings* s) {
  if (get(device, RUNMARK_ID) != 0x524D4B31u) return RUNMARK_NO_CORE;
  const uint32_t largest = get(device, RUNMARK_LARGEST);
  const uint32_t width = FIELD(largest, RUNMARK_LARGEST_WIDTH);
  const uint32_t height = FIELD(largest, RUNMARK_LARGEST_HEIGHT);
  const int hardware = get(device, RUNMARK_PROFILE) == 1;
  if (s->width < (hardware ? 16 : 3) || s->height < 3 || s->width > width || s->height > height)
    return RUNMARK_BAD_SIZE;
  if (s->threshold > 256 || s->filter > 63 || s->max_turns == 0 || s->max_turns > 31 ||
      s->min_height > height || s->max_errors > 63 || s->frame_address % 4096 != 0 ||
      (hardware ? s->cells < 6 || s->cells > 10 : s->corner_offset == 0)) {
    return RUNMARK_BAD_SETTING;
  }
  /* No area is larger; the core does not look at higher bits. */
  const uint32_t largest_area = (hardware ? 1 : 2) * width * height;
  const uint32_t min_side = s->min_side < width ? s->min_side : width - 1;
  set(device, RUNMARK_CONTROL, s->control & ~RUNMARK_CONTROL_RUN);
  set(device, RUNMARK_SIZE,
      (uint32_t)s->width << RUNMARK_SIZE_WIDTH_SHIFT | (uint32_t)s->height << RUNMARK_SIZE_HEIGHT_SHIFT);
  set(device, RUNMARK_THRESHOLD, s->threshold);
  set(device, RUNMARK_FILTER, s->filter);
  set(device, RUNMARK_CHAIN_LIMITS,
      (uint32_t)s->max_turns << RUNMARK_CHAIN_LIMITS_MAX_TURNS_SHIFT |
          (uint32_t)s->min_height << RUNMARK_CHAIN_LIMITS_MIN_HEIGHT_SHIFT);
  set(device, RUNMARK_CORNER_OFFSET, s->corner_offset);
  set(device, RUNMARK_MIN_AREA, s->min_area < largest_area ? s->min_area : largest_area);
  set(device, RUNMARK_MAX_AREA, s->max_area < largest_area ? s->max_area : largest_area);
  set(device, RUNMARK_MIN_CONTRAST, s->min_contrast);
  set(device, RUNMARK_SQUARE,
      min_side << RUNMARK_SQUARE_MIN_SIDE_SHIFT | (uint32_t)s->min_margin << RUNMARK_SQUARE_MIN_MARGIN_SHIFT |
          (uint32_t)s->cells << RUNMARK_SQUARE_WIDTH_SHIFT);
  const uint32_t codes = FIELD(get(device, RUNMARK_MATCH), RUNMARK_MATCH_CODES);
  set(device, RUNMARK_MATCH,
      codes << RUNMARK_MATCH_CODES_SHIFT | (uint32_t)s->max_errors << RUNMARK_MATCH_MAX_ERRORS_SHIFT);
  set(device, RUNMARK_FRAME_ADDRESS, s->frame_address);
  return RUNMARK_OK;
}

runmark_status runmark_load_codes(const runmark_device* device, const uint64_t* codes, unsigned count) {
  const uint32_t capacity = get(device, RUNMARK_CAPACITY);
  if (count > FIELD(capacity, RUNMARK_CAPACITY_CODES)) return RUNMARK_TOO_MANY_CODES;
  set(device, RUNMARK_CODE_INDEX, 0);
  for (unsigned i = 0; i < count; ++i) {
    set(device, RUNMARK_CODE_HIGH, (uint32_t)(codes[i] >> 32));
    set(device, RUNMARK_CODE_LOW, (uint32_t)codes[i]);
  }
  const uint32_t errors = FIELD(get(device, RUNMARK_MATCH), RUNMARK_MATCH_MAX_ERRORS);
  set(device, RUNMARK_MATCH, count << RUNMARK_MATCH_CODES_SHIFT | errors << RUNMARK_MATCH_MAX_ERRORS_SHIFT);
  return RUNMARK_OK;
}

void runmark_run(const runmark_device* device, int run) {
  const uint32_t control = get(device, RUNMARK_CONTROL);
  set(device, RUNMARK_CONTROL, run ? control | RUNMARK_CONTROL_RUN : control & ~RUNMARK_CONTROL_RUN);
}

int runmark_feed(const runmark_device* device, uint32_t pixel, int first_of_frame, int last_of_line) {
  if ((get(device, RUNMARK_STATUS) & RUNMARK_STATUS_PIXEL_FREE) == 0) return 0;
  set(device, RUNMARK_PIXEL,
      (pixel & RUNMARK_PIXEL_DATA_MASK) | (first_of_frame ? RUNMARK_PIXEL_USER : 0u) |
          (last_of_line ? RUNMARK_PIXEL_LAST : 0u));
  return 1;
}

static int is_end(uint32_t head) { return (head & RUNMARK_RECORD_END) != 0; }

static int is_fine(uint32_t head) { return (head & RUNMARK_RECORD_FINE) != 0; }

static unsigned words_of(uint32_t head) {
  if (is_end(head)) return RUNMARK_END_WORDS;
  return is_fine(head) ? RUNMARK_FINE_MARKER_WORDS : RUNMARK_MARKER_WORDS;
}

unsigned runmark_read_record(const uint32_t* words, runmark_record* record) {
  const runmark_record none = {0};
  *record = none;
  record->id = (uint16_t)FIELD(words[0], RUNMARK_RECORD_ID);
  record->end_of_frame = is_end(words[0]);
  if (record->end_of_frame) {
    record->malformed = (words[0] & RUNMARK_RECORD_MALFORMED) != 0;
    record->lost = (words[0] & RUNMARK_RECORD_LOST) != 0;
    record->dropped = (words[0] & RUNMARK_RECORD_DROPPED) != 0;
    record->record_peak = (uint16_t)FIELD(words[1], RUNMARK_RECORD_RECORD_PEAK);
    record->end_peak = (uint16_t)FIELD(words[1], RUNMARK_RECORD_END_PEAK);
    return words_of(words[0]);
  }
  record->rotation = (uint8_t)FIELD(words[0], RUNMARK_RECORD_ROTATION);
  record->errors = (uint8_t)FIELD(words[0], RUNMARK_RECORD_ERRORS);
  record->inverted = (words[0] & RUNMARK_RECORD_INVERTED) != 0;
  record->bottom = (uint16_t)FIELD(words[1], RUNMARK_RECORD_BOTTOM);
  record->fine = is_fine(words[0]);
  if (record->fine) {
    record->clearance = words[2];
    record->scale = words[3];
    for (int i = 0; i < 4; ++i) {
      record->x[i] = (int32_t)words[4 + 2 * i];
      record->y[i] = (int32_t)words[5 + 2 * i];
    }
    return words_of(words[0]);
  }
  for (int i = 0; i < 4; ++i) {
    record->x[i] = (uint16_t)FIELD(words[2 + i], RUNMARK_RECORD_X);
    record->y[i] = (uint16_t)FIELD(words[2 + i], RUNMARK_RECORD_Y);
  }
  return words_of(words[0]);
}

int runmark_next_result(const runmark_device* device, runmark_record* record) {
  uint32_t words[RUNMARK_FINE_MARKER_WORDS];
  if ((get(device, RUNMARK_STATUS) & RUNMARK_STATUS_RESULT_READY) == 0) return 0;
  words[0] = get(device, RUNMARK_RESULT);
  const unsigned count = words_of(words[0]);
  /* The core puts a word into the queue in every clock, so the others of a record are there at once. */
  for (unsigned i = 1; i < count; ++i) words[i] = get(device, RUNMARK_RESULT);
  runmark_read_record(words, record);
  return 1;
}
