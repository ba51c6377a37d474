// The runs beside a run from which its error bars are found: coarser lattices, finer intervals.
#include "base/require.hpp"
#include "coupling/error_bars.hpp"
#include "coupling/output_schedule.hpp"
#include "io/later_end.hpp"
#include "support/heated_slab.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace vug {
namespace {

using namespace test;

TEST(Twins, KeepTheTimeTheSizeAndTheLatticeDiffusivity) {
  const CaseFile file(slab);
  const Scene scene = file.scene();
  const Twins found = find_twins(scene);
  EXPECT_EQ(found.ratio, 2);
  ASSERT_EQ(found.twins.size(), 2u);
  for (const Twin& twin : found.twins) {
    const Scene& coarse = twin.scene;
    EXPECT_NEAR(coarse.lattice.time_step / std::pow(coarse.lattice.spacing, 2),
                scene.lattice.time_step / std::pow(scene.lattice.spacing, 2), 1e-9);
    EXPECT_NEAR(static_cast<double>(last_step(coarse)) * coarse.lattice.time_step, 0.64, 1e-12);
    EXPECT_NEAR(static_cast<double>(*coarse.output.interval_steps) * coarse.lattice.time_step, 0.16, 1e-12);
  }
  EXPECT_EQ(found.twins[0].scene.lattice.nx, 12);
  EXPECT_EQ(found.twins[1].scene.lattice.ny, 3);
}

/// Or a bar would hold what the history does between the rows of the coarser lattices.
TEST(Twins, HaveRowsAtTheSameTimes) {
  const CaseFile file(slab);
  const Scene scene = file.scene({"time.steps=800"});
  for (const Twin& twin : find_twins(scene).twins)
    EXPECT_NEAR(row_interval(twin.scene), row_interval(scene), 1e-12) << twin.scene.lattice.nx;
}

/// A run of 145 steps lasts as long as 36.25 steps of four times the length: the last row lies in the 37th.
TEST(Twins, DoNotEndBeforeTheRun) {
  const CaseFile file(slab);
  const Scene scene = file.scene({"time.steps=145"});
  const Twins found = find_twins(scene);
  EXPECT_EQ(found.twins[0].scene.time.steps, 37);
  EXPECT_EQ(found.twins[1].scene.time.steps, 10);
  EXPECT_EQ(steps_over(144, 2), 36);
  EXPECT_EQ(steps_over(225, 1.5), 100);
  EXPECT_EQ(steps_over(1, 4), 1);
}

/// Though their rows follow from the end of the run.
TEST(Twins, MayBeContinuedToALaterEnd) {
  const CaseFile file(slab);
  const auto twin = [&](const char* steps) {
    return find_twins(file.scene({std::string("time.steps=") + steps})).twins[0].scene;
  };
  const Scene before = twin("40000");
  EXPECT_TRUE(time_of_same_case(twin("80000"), before.source_text, before.overrides));
}

TEST(Twins, TakeAnotherRatioWhereTwoDoesNotFit) {
  const CaseFile file(slab);
  EXPECT_EQ(find_twins(file.scene({"lattice.size=[0.027, 0.018]"})).ratio, 1.5);
  EXPECT_EQ(find_twins(file.scene({"lattice.size=[0.027, 0.018]"})).twins.size(), 2u);
  EXPECT_EQ(find_twins(file.scene({"lattice.size=[0.028, 0.014]"})).twins.size(), 1u);
  EXPECT_THROW(find_twins(file.scene({"lattice.size=[0.029, 0.013]"})), InputError);
}

TEST(Twins, OfAPictureTakeLargerSquaresOfPixels) {
  const CaseFile file(slab);
  const Twins found = find_twins(pictured(file, 24, 12));
  EXPECT_EQ(found.ratio, 2);
  ASSERT_EQ(found.twins.size(), 2u);
  EXPECT_EQ(found.twins[0].scene.geometry.image.coarsen, 2);
  EXPECT_EQ(found.twins[1].scene.geometry.image.coarsen, 4);
  const Twins finer = find_twins(pictured(file, 48, 24, {"geometry.coarsen=2"}));
  EXPECT_EQ(finer.twins[0].scene.geometry.image.coarsen, 4);
  // 27 x 18 cells have the ratio 1.5, but no cell is 1.5 pixels wide; 3 is possible
  EXPECT_EQ(find_twins(pictured(file, 27, 18, {"lattice.size=[0.027, 0.018]", "geometry.pixel_size=1e-3"})).ratio, 3);
  EXPECT_THROW(find_twins(pictured(file, 25, 35, {"lattice.size=[0.025, 0.035]", "geometry.pixel_size=1e-3"})),
               InputError);
}

/// A coarser lattice would be another rock.
TEST(TwinsOfRock, HaveHalfTheIntervalsOnTheSameLattice) {
  const Scene scene = read_scene(test::small_rock, rock_intervals);
  const Twins found = find_twins(scene);
  EXPECT_EQ(found.ratio, 0);
  ASSERT_EQ(found.twins.size(), 1u);
  const Scene& finer = found.twins[0].scene;
  EXPECT_EQ(finer.accuracy.update_interval, 3);
  EXPECT_EQ(finer.accuracy.wall_interval, 7);
  EXPECT_EQ(finer.accuracy.heat_interval, 2);
  EXPECT_EQ(finer.accuracy.solute_interval, 1);
  EXPECT_EQ(finer.accuracy.exchange_interval, 1);
  EXPECT_EQ(finer.accuracy.precision, Precision::double_precision);
  EXPECT_EQ(finer.lattice.nx, scene.lattice.nx);
  EXPECT_EQ(finer.lattice.time_step, scene.lattice.time_step);
  EXPECT_EQ(last_step(finer), last_step(scene));
}

TEST(TwinsOfRock, HaveHalfTheToleranceWhereThatChoosesIntervals) {
  const Twins found =
      find_twins(read_scene(test::small_rock, {"accuracy.tolerance=4e-3", "accuracy.precision=single"}));
  ASSERT_EQ(found.twins.size(), 1u);
  EXPECT_DOUBLE_EQ(found.twins[0].scene.accuracy.tolerance, 2e-3);
  EXPECT_EQ(found.twins[0].scene.accuracy.precision, Precision::double_precision);
}

TEST(TwinsOfRock, AreNoneWhereEveryStepIsTaken) {
  EXPECT_THROW(find_twins(read_scene(test::small_rock, {"accuracy.preset=reference"})), InputError);
}

}  // namespace
}  // namespace vug
