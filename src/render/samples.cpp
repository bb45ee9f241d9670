#include "render/samples.h"

#include <array>

namespace runmark::render {

namespace {

// A well-lit room with a dozen markers; each sample makes one thing harder.
Recipe room() {
  Recipe r;
  r.width = 1280;
  r.height = 720;
  r.sizes = {{24, 48, 5}, {48, 100, 4}, {100, 180, 2}};
  r.tilt = {0, 45};
  r.margin = {0.8, 2};
  r.occluded = 0;
  r.cut = 0;
  r.repeated = 0;
  r.wall = Wall::plaster;
  r.clutter = {14, 20};
  r.level = {1.05, 1.15};
  r.gradient = {0.1, 0.3};
  r.lamps = {};
  r.shadows = {};
  r.vignette = {1, {0.1, 0.2}};
  r.distortion = {};
  r.blur = {0.5, 0.7};
  r.motion = {};
  r.noise = {1, 2};
  r.jpeg = {};
  return r;
}

Recipe board() {
  Recipe r = room();
  r.board = 1;
  r.board_size = {45, 60};
  r.sizes = {{24, 48, 4}};
  r.wall = Wall::wood;
  r.shadows = {1, {2, 2}};
  return r;
}

Recipe tilted() {
  Recipe r = room();
  r.tilt = {50, 68};
  r.wall = Wall::tiles;
  r.distortion = {1, {-0.12, -0.1}};
  return r;
}

Recipe night() {
  Recipe r = room();
  r.level = {0.22, 0.25};
  r.noise = {7, 8};
  r.lamps = {1, {2, 2}};
  r.gradient = {0.4, 0.6};
  return r;
}

Recipe shaken() {
  Recipe r = room();
  r.sizes = {{48, 100, 6}, {100, 180, 3}};
  r.motion = {1, {6, 7}};
  r.blur = {1, 1.2};
  r.wall = Wall::brick;
  return r;
}

Recipe inverted() {
  Recipe r = room();
  r.inverted = true;
  r.wall = Wall::noise;
  return r;
}

Recipe blinds() {
  Recipe r = room();
  r.shadows = {1, {3, 3}};
  r.occluded = 2;
  r.wall = Wall::gradient;
  return r;
}

Recipe far() {
  Recipe r = room();
  r.sizes = {{12, 16, 6}, {16, 24, 16}, {24, 32, 6}};
  r.clutter = {40, 50};
  r.noise = {1, 1};
  r.jpeg = {1, {88, 88}};
  return r;
}

const std::array<Sample, 8> all{Sample{"room", "tag36h11", room()},
                                Sample{"board", "DICT_5X5_250", board()},
                                Sample{"tilted", "DICT_4X4_50", tilted()},
                                Sample{"night", "tag36h11", night()},
                                Sample{"shaken", "DICT_6X6_250", shaken()},
                                Sample{"inverted", "DICT_4X4_100", inverted()},
                                Sample{"blinds", "tagStandard41h12", blinds()},
                                Sample{"far", "tag25h9", far()}};

}  // namespace

std::span<const Sample> samples() { return all; }

}  // namespace runmark::render
