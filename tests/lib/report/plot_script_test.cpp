#include "plastica/report/plot_script.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/has.hpp"

// How panels of a page are laid out.

namespace plastica::report {
namespace {

using testing::has;

constexpr Sheet kColumn{false, 422.0, true};  // 85 mm

std::string one_panel(const Sheet& sheet, const std::vector<std::string>& title) {
  PlotScript script(sheet);
  script.begin_panels(1);
  script.set_x_label("displacement of the very far end of the boom of the crane [mm]");
  script.set_y_label("reaction of the head of the testing machine at its upper end [N]");
  script.begin_panel(title);
  script.add_series(script.add_points({{0.0, 1.0}, {1.0, 2.0}}), "using 1:2 with lines linewidth 2",
                    "curve");
  script.end_panel();
  return script.text();
}

TEST(PlotScript, CutsLabelsButNotTheirUnits) {
  const std::string narrow = one_panel(kColumn, {"t"});
  EXPECT_TRUE(has(narrow, "set xlabel 'displacement of the very far end of… [mm]'")) << narrow;
  EXPECT_TRUE(has(narrow, "… [N]' at screen")) << narrow;
  const std::string wide = one_panel({}, {"t"});
  EXPECT_TRUE(has(wide, "boom of the crane [mm]'"));
}

TEST(PlotScript, BreaksTitlesBetweenFacts) {
  const std::vector<std::string> title{
      "bar", "E 199.787 ± 0.091 GPa    σ_y 299.863 ± 0.062 MPa    misfit 0.33 %",
      "completed; largest displacement 403.4 mm (457 mm on the way)"};
  const std::string narrow = one_panel(kColumn, title);
  EXPECT_TRUE(has(narrow,
                  "set title 'bar'.\"\\n\".'E 199.787 ± 0.091 GPa'.\"\\n\".'σ_y 299.863 ± 0.062 "
                  "MPa    misfit 0.33 %'.\"\\n\".'completed;'.\"\\n\".'largest displacement 403.4 "
                  "mm (457 mm on'.\"\\n\".'the way)'"))
      << narrow;
  EXPECT_TRUE(has(one_panel({}, title), "'" + title[1] + "'"));
}

TEST(PlotScript, MakesRoomForItsTitlesAndPutsPanelsBelowEachOther) {
  const auto panels = [](const Sheet& sheet, const std::string& title) {
    PlotScript script(sheet);
    script.begin_panels(3);
    for (int k = 0; k < 3; ++k) {
      script.begin_panel({title});
      script.add_series(script.add_points({{0.0, 1.0}}), "using 1:2 with lines linewidth 2",
                        "curve");
      script.end_panel();
    }
    return script.height();
  };
  EXPECT_NEAR(panels({}, "two words and more of them"), panels({}, "one"), 1e-12);
  // A line of 20 units more: above the panels, and in their row.
  EXPECT_NEAR(panels({}, "one title that two lines of a panel have to take up"),
              panels({}, "one") + 20.0, 1e-12);
  EXPECT_GT(panels(kColumn, "one"), 2.0 * panels({}, "one") - 200.0);
}

}  // namespace
}  // namespace plastica::report
