#include "world/flight_pace.hpp"

#include <gtest/gtest.h>

namespace toccata {
namespace {

StepWork plain_step() { return {.bodies = 1000, .placed = 1000, .looked = 500, .asked = 100}; }
StepWork first_step() { return {.bodies = 1000, .placed = 1000, .looked = 2000, .asked = 100}; }
StepWork quiet_step() { return {.bodies = 1000, .tested = 1000, .looked = 20, .asked = 5}; }

TEST(FlightPace, AStretchThatSavesTimeGoesOnToItsEndAndIsFollowedByAnother) {
  FlightPace pace;
  pace.note_plain(plain_step());
  for (int stretch = 0; stretch < 10; ++stretch) {
    pace.begin();
    EXPECT_TRUE(pace.note_flown(first_step()));
    for (int step = 1; step < pace.steps(); ++step) EXPECT_TRUE(pace.note_flown(quiet_step()));
    EXPECT_EQ(pace.end_well(), 0);
    EXPECT_GE(pace.steps(), 4);
    EXPECT_LE(pace.steps(), 64);
  }
}

TEST(FlightPace, AStretchIsBrokenOffBeforeItCostsMoreThanPlainSteps) {
  FlightPace pace;
  pace.note_plain(plain_step());
  pace.begin();
  int steps = 0;
  while (pace.note_flown(plain_step())) ++steps;
  EXPECT_LT(steps, pace.steps());
  int before = 0;
  for (int i = 0; i < 5; ++i) {
    const int pause = pace.end_badly();
    EXPECT_GE(pause, before);
    EXPECT_GE(pause, 100);
    before = pause;
  }
  EXPECT_EQ(before, 1600);
}

TEST(FlightPace, NowAndThenItLooksAnewWhatPlainStepsCost) {
  FlightPace pace;
  int plain = 0;
  for (int stretch = 0; stretch < 32; ++stretch) plain += pace.end_well();
  EXPECT_EQ(plain, 6);
}

TEST(FlightPace, WhereNothingIsToBeSavedNoStretchGoesOn) {
  FlightPace pace;
  pace.note_plain({.bodies = 1000});
  pace.begin();
  EXPECT_FALSE(pace.note_flown(quiet_step()));
}

}  // namespace
}  // namespace toccata
