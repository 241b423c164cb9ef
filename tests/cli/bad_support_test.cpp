#include "tests/cli/bad_chain_scene.hpp"

namespace plastica::testing {
namespace {

class BadSupport : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadSupport, IsRefusedInOneLine) { expect_refusal(GetParam()); }

/// A roller at the end, and another support with these keys, whose first is on line 29.
BadInput with_support(std::string name, const std::string& keys, const std::string& line) {
  return add_to_chain(std::move(name),
                      "[[support]]\nat = 'end'\nkind = 'roller'\n[[support]]\n" + keys, line);
}

INSTANTIATE_TEST_SUITE_P(
    Hinge, BadSupport,
    ::testing::Values(
        with_support("AtTheTip", "at = 'end'\nkind = 'hinge'\n",
                     "29: support[4].at = end: a hinge must be within the beam; at an end, a pin "
                     "lets it turn"),
        with_support("AtTheSamePlaceAsAnother",
                     "at = 0.25\nkind = 'hinge'\n[[support]]\nat = 0.25\nkind = 'hinge'\n",
                     "32: support[5].at = 0.25: support[4] is a hinge at the same place"),
        with_support("ThatHolds", "at = 0.25\nkind = 'hinge'\nhold = ['rx']\n",
                     "31: support[4].hold: a hinge lets go; what holds the beam there is another "
                     "support"),
        with_support(
            "ThatIsSprung",
            "at = 0.25\nkind = 'hinge'\nrotational_stiffness = ['1 N m/rad', '0 N m/rad', "
            "'0 N m/rad']\n",
            "31: support[4].rotational_stiffness = ['1 N m/rad', '0 N m/rad', '0 N m/rad']: "
            "belongs to kind = \"elastic\""),
        with_support("WithATypingErrorInItsPlace", "at = 1.25\nkind = 'hinge'\n",
                     "29: support[4].at = 1.25: must be a fraction of the length, 0 to 1")),
    name_of_case);

constexpr const char* kBed = "stiffness = ['0 MPa', '5 MPa', '0 MPa']\n";

INSTANTIATE_TEST_SUITE_P(
    Bed, BadSupport,
    ::testing::Values(
        with_support("ThatRunsBack", std::string("at = 0.75\nto = 0.25\nkind = 'elastic'\n") + kBed,
                     "30: support[4].to = 0.25: must lie beyond at = 0.75"),
        with_support("OfNoStiffness", "at = 0.25\nto = 0.75\nkind = 'elastic'\n",
                     "28: support[4]: an elastic support needs stiffness or rotational_stiffness"),
        with_support("OfStiffnessZero",
                     "at = 0.25\nto = 0.75\nkind = 'elastic'\nstiffness = ['0 MPa', '0 MPa', "
                     "'0 MPa']\n",
                     "28: support[4]: an elastic support needs stiffness or rotational_stiffness"),
        with_support(
            "OfASpringsUnit",
            "at = 0.25\nto = 0.75\nkind = 'elastic'\nstiffness = ['0 N/m', '5 N/m', "
            "'0 N/m']\n",
            "32: support[4].stiffness[1] = 0 N/m: \"N/m\" is not a unit of stress (examples: "
            "Pa, MPa, ksi): with to, a stiffness is per length"),
        with_support("ThatIsNegative",
                     "at = 0.25\nto = 0.75\nkind = 'elastic'\nstiffness = ['0 MPa', '-5 MPa', "
                     "'0 MPa']\n",
                     "32: support[4].stiffness = -5e+06: must be at least 0"),
        with_support("WithTwoBegins",
                     std::string("at = 0.25\nfrom = 0.25\nto = 0.75\nkind = 'elastic'\n") + kBed,
                     "29: support[4].at = 0.25: stands beside from: one of them is enough"),
        with_support("ThatDoesNotEnd", std::string("from = 0.25\nkind = 'elastic'\n") + kBed,
                     "29: support[4].from = 0.25: needs to; a single place is at"),
        with_support("OfAClamp", "at = 0.25\nto = 0.75\nkind = 'clamp'\n",
                     "30: support[4].to = 0.75: belongs to kind = \"elastic\"")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    InclinedRoller, BadSupport,
    ::testing::Values(
        with_support("WithoutDirection",
                     "at = 0.25\nkind = 'inclined_roller'\nnormal = [0, 0, 0]\n",
                     "31: support[4].normal = [0, 0, 0]: has no direction"),
        with_support("InAPlane", "at = 0.25\nkind = 'inclined_roller'\nnormal = [1, 1]\n",
                     "31: support[4].normal = [1, 1]: must have three components: x, y and z"),
        with_support("OfAnAngle", "at = 0.25\nkind = 'inclined_roller'\nangle = '30 deg'\n",
                     "28: support[4].normal: is missing"),
        with_support("ThatHoldsMore",
                     "at = 0.25\nkind = 'inclined_roller'\nnormal = 'y'\nhold = ['y']\n",
                     "32: support[4].hold: an inclined roller holds along its normal; what else "
                     "holds is another support"),
        with_support("WithAGap",
                     "at = 0.25\nkind = 'inclined_roller'\nnormal = 'y'\ngap = '1 mm'\n",
                     "32: support[4].gap = 1 mm: belongs to kind = \"pillar\"")),
    name_of_case);

}  // namespace
}  // namespace plastica::testing
