#include "tests/cli/bad_input.hpp"

namespace plastica::testing {
namespace {

constexpr const char* kChainScene =
    "[beam]\n"                                                                // 1
    "length = '4 m'\n"                                                        // 2
    "segments = 8\n"                                                          // 3
    "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"  // 4
    "material = 'S355'\n"                                                     // 5
    "[rules]\n"                                                               // 6
    "yield_model = 'interaction'\n"                                           // 7
    "[solver]\n"                                                              // 8
    "steps = 10\n"                                                            // 9
    "[[support]]\n"                                                           // 10
    "at = 'start'\n"                                                          // 11
    "kind = 'clamp'\n"                                                        // 12
    "[[support]]\n"                                                           // 13
    "at = 0.5\n"                                                              // 14
    "kind = 'elastic'\n"                                                      // 15
    "stiffness = ['0 N/m', '1 kN/m', '0 N/m']\n"                              // 16
    "[[load]]\n"                                                              // 17
    "at = 'end'\n"                                                            // 18
    "force = ['0 N', '-100 N', '0 N']\n"                                      // 19
    "history = 'ramp'\n"                                                      // 20
    "[[probe]]\n"                                                             // 21
    "name = 'tip'\n"                                                          // 22
    "kind = 'displacement'\n"                                                 // 23
    "at = 'end'\n";                                                           // 24

/// The scene with one piece changed, and the line that `simulate` answers with behind the file.
BadInput change(std::string name, const std::string& from, const std::string& to,
                const std::string& line) {
  return bad_scene(std::move(name), changed(kChainScene, from, to), line);
}

/// The scene with more at its end, from line 25 on.
BadInput add(std::string name, const std::string& text, const std::string& line) {
  const std::string last = "at = 'end'\n";
  return change(std::move(name), "'displacement'\n" + last, "'displacement'\n" + last + text, line);
}

class BadChainScene : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadChainScene, IsRefusedInOneLine) { expect_refusal(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Beam, BadChainScene,
    ::testing::Values(
        change("UnknownShape", "length = '4 m'", "shape = 'bow'",
               "2: beam.shape = bow: must be one of straight, arc, polyline"),
        change("SectionTwice", "[rules]", "[section]\nwidth = '1 m'\n[rules]",
               "4: beam.section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }: is "
               "given twice: the file has [section], too"),
        change("MaterialTwice", "[rules]", "[material]\nname = 'S235'\n[rules]",
               "5: beam.material = S355: is given twice: the file has [material], too"),
        change("SectionOutOfRange", "width = '20 mm'", "width = '-20 mm'",
               "4: beam.section.width = -20 mm: must be above 0 m"),
        change("UnknownKeyOfSection", "height", "depth",
               "4: beam.section.depth = '20 mm': is not a key of beam.section; its keys are "
               "profile, shape, …"),
        change("UnknownMaterial", "S355", "S3555",
               "5: beam.material = S3555: must be one of S235, S275, S355, …"),
        change("NoSegments", "segments = 8", "segments = 0",
               "3: beam.segments = 0: must be from 1 to 1e+07"),
        change("ArcWithoutAngle", "length", "shape = 'arc'\nlength",
               "1: beam.arc_angle: is missing"),
        change("ArcAngleWithoutUnit", "length", "shape = 'arc'\narc_angle = 45\nlength",
               "3: beam.arc_angle = 45: an angle needs a unit (examples: rad, deg)"),
        change("ArcAngleZero", "length", "shape = 'arc'\narc_angle = '0 deg'\nlength",
               "3: beam.arc_angle = 0: must be above 0 and at most a full turn, 2 pi rad"),
        change("ArcAngleOfAStraightBeam", "length", "arc_angle = '45 deg'\nlength",
               "2: beam.arc_angle = 45 deg: belongs to beam.shape = \"arc\""),
        change("ArcAlongTheBeam", "length",
               "shape = 'arc'\narc_angle = '45 deg'\narc_towards = 'z'\nlength",
               "4: beam.arc_towards = 1: is its z component and must be 0: the beam starts along "
               "z"),
        change("UnknownDirection", "length",
               "shape = 'arc'\narc_angle = '45 deg'\narc_towards = 'up'\nlength",
               "4: beam.arc_towards = 'up': must be one of \"x\", \"y\", \"z\", \"-x\", \"-y\", "
               "\"-z\""),
        change("DirectionOfNoSize", "length",
               "shape = 'arc'\narc_angle = '45 deg'\narc_towards = [0, 0, 0]\nlength",
               "4: beam.arc_towards = [0, 0, 0]: has no direction"),
        change("PolylineWithoutPoints", "length", "shape = 'polyline'\nlength",
               "1: beam.points: is missing"),
        change("PolylineOfOnePoint", "length = '4 m'",
               "shape = 'polyline'\npoints = [['0 m', '0 m', '0 m']]",
               "3: beam.points = [['0 m', '0 m', '0 m']]: must be at least two points"),
        change("PointOfTwoCoordinates", "length = '4 m'",
               "shape = 'polyline'\npoints = [['0 m', '0 m', '0 m'], ['0 m', '1 m']]",
               "3: beam.points[2] = ['0 m', '1 m']: must have three components: x, y and z"),
        change("PointsOfAnotherLength", "length",
               "shape = 'polyline'\n"
               "points = [['0 m', '0 m', '0 m'], ['0 m', '0 m', '3 m']]\nlength",
               "3: beam.points = [['0 m', '0 m', '0 m'], ['0 m', '0 m', '3 m']]: add up to 3 m, "
               "and the beam's length is 4 m"),
        change("PointTwice", "length = '4 m'",
               "shape = 'polyline'\npoints = [['0 m', '0 m', '0 m'], ['0 m', '0 m', '0 m'], "
               "['0 m', '0 m', '1 m']]",
               "3: beam.points[2]: is the same as the one before")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Lengths, BadChainScene,
    ::testing::Values(
        change("SegmentLengthsOfAnotherBeam", "segments = 8", "segment_lengths = ['1 m', '2 m']",
               "3: beam.segment_lengths = ['1 m', '2 m']: add up to 3 m, and the beam's length is "
               "4 m"),
        change("OtherNumberOfSegmentLengths", "segments = 8",
               "segments = 8\nsegment_lengths = ['2 m', '2 m']",
               "4: beam.segment_lengths = ['2 m', '2 m']: are 2 lengths, and beam.segments is 8"),
        change("SegmentOfNoLength", "segments = 8", "segment_lengths = ['4 m', '0 m']",
               "3: beam.segment_lengths[2] = 0 m: must be above 0"),
        change("SharesThatAreNotAll", "segments = 8", "segment_lengths = [0.5, 0.25]",
               "3: beam.segment_lengths = [0.5, 0.25]: are shares that add up to 0.75: must be 1; "
               "lengths need a unit"),
        change("SharesAndLengths", "segments = 8", "segment_lengths = ['2 m', 0.5]",
               "3: beam.segment_lengths[2] = 0.5: a length needs a unit (examples: m, mm, in)"),
        change("JointLengthsOfAnotherBeam", "segments = 8",
               "segments = 8\njoint_lengths = ['0.5 m', '0.5 m']",
               "4: beam.joint_lengths = 2 values: must be 7 for the beam's segments"),
        change("JointOfNegativeLength", "segments = 8", "segments = 2\njoint_lengths = ['-1 m']",
               "4: beam.joint_lengths[1] = -1: must be positive and finite")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Region, BadChainScene,
    ::testing::Values(
        add("OfNothing", "[[region]]\nfrom = 'start'\nto = 0.5\n",
            "25: region[1]: needs a section or a material"),
        add("WithoutEnd", "[[region]]\nfrom = 'start'\nmaterial = 'S235'\n",
            "25: region[1].to: is missing"),
        add("ThatRunsBack", "[[region]]\nfrom = 0.5\nto = 0.25\nmaterial = 'S235'\n",
            "27: region[1].to = 0.25: must lie beyond from = 0.5"),
        add("OutOfRange", "[[region]]\nfrom = 0.5\nto = 'end'\nsection.width = '-1 mm'\n",
            "28: region[1].section.width = -1 mm: must be above 0 m"),
        add("OfUnknownMaterial", "[[region]]\nfrom = 0.5\nto = 'end'\nmaterial = 'S1'\n",
            "28: region[1].material = S1: must be one of S235, …"),
        add("WithAnUnknownKey",
            "[[region]]\nfrom = 0.5\nto = 'end'\nsection.width = '1 mm'\nshape = 'circle'\n",
            "29: region[1].shape = 'circle': is not a key of region[1]; its keys are section, "
            "material, from, to")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Support, BadChainScene,
    ::testing::Values(
        change("Nowhere", "at = 'start'\nkind", "kind", "10: support[1].at: is missing"),
        change("OfNoKind", "kind = 'clamp'\n", "", "10: support[1].kind: is missing"),
        change("OfUnknownKind", "'clamp'", "'clamped'",
               "12: support[1].kind = 'clamped': must be one of \"clamp\", \"pin\", \"roller\", "
               "\"guide\", \"elastic\", \"pillar\""),
        change("AtAnUnknownPlace", "'start'", "'middle'",
               "11: support[1].at = middle: must be \"start\", \"end\", { segment = 3 } (its outer "
               "end), or a fraction of the length: 0.25, \"25 %\""),
        change("BeyondTheEnd", "at = 0.5", "at = 1.5",
               "14: support[2].at = 1.5: must be a fraction of the length, 0 to 1"),
        change("BehindTheLastSegment", "at = 0.5", "at = { segment = 9 }",
               "14: support[2].at = { segment = 9 }: must be a segment from 1 to 8, or 0 for the "
               "start"),
        change("AtAWholeNumber", "at = 0.5", "at = 1",
               "14: support[2].at = 1: is neither a segment nor a fraction: write { segment = 1 } "
               "for the outer end of that segment, or a fraction of the length with a point, 0.25 "
               "(the end is 1.0 or \"end\")"),
        change("AtAWholeNumberBelowZero", "at = 0.5", "at = -1",
               "14: support[2].at = -1: must be a fraction of the length, 0 to 1"),
        change("AtASegmentThatIsAFraction", "at = 0.5", "at = { segment = 1.5 }",
               "14: support[2].at.segment = 1.5: must be a whole number from 0 to 2147483647"),
        change("AtATableWithoutASegment", "at = 0.5", "at = { joint = 1 }",
               "14: support[2].at.segment: is missing"),
        change(
            "MoreStretchesThanSegments", "segments = 8", "segments = 1",
            "3: beam.segments = 1: must be at least 2, since segments end at support[2].at = 0.5"),
        change("RegionWithinASegmentOfGivenLength", "[beam]\nlength = '4 m'\nsegments = 8",
               "region = [{ from = 0.3, to = 'end', material = 'S235' }]\n"
               "[beam]\nlength = '4 m'\nsegment_lengths = ['1 m', '2 m', '1 m']",
               "1: region[1].from = 0.3: must be where a segment ends, which beam.segment_lengths "
               "sets; the nearest ends are 0.25 and 0.75"),
        change("ThatHoldsAWord", "'clamp'", "'clamp'\nhold = ['y', 'pitch']",
               "13: support[1].hold[2] = 'pitch': must be one of \"x\", \"y\", \"z\", \"rx\", "
               "\"ry\", \"rz\""),
        change("ThatHoldsTwice", "'clamp'", "'clamp'\nhold = ['y', 'y']",
               "13: support[1].hold[2] = y: is in the list twice"),
        change("ThatHoldsNothing", "'clamp'", "'clamp'\nhold = []",
               "13: support[1].hold = []: must hold something"),
        change("WithASpringThatItHolds", "'elastic'", "'elastic'\nhold = ['y']",
               "16: support[2].hold = y: has a spring, too"),
        change("ElasticWithoutSpring", "stiffness = ['0 N/m', '1 kN/m', '0 N/m']\n", "",
               "13: support[2]: an elastic support needs stiffness or rotational_stiffness"),
        change("WithSpringsOfAnotherKind", "'elastic'", "'roller'",
               "16: support[2].stiffness = ['0 N/m', '1 kN/m', '0 N/m']: belongs to kind = "
               "\"elastic\""),
        change("WithAStiffnessInNewton", "1 kN/m", "1 kN",
               "16: support[2].stiffness[2] = 1 kN: \"kN\" is not a unit of stiffness (examples: "
               "N/m, kN/mm, lbf/in)"),
        change("WithANegativeSpring", "1 kN/m", "-1 kN/m",
               "16: support[2].stiffness = -1000: must be finite and not negative"),
        change("WithARotationalStiffnessPerLength", "stiffness = ['0 N/m', '1 kN/m', '0 N/m']",
               "rotational_stiffness = ['1 N/m', '0 N/m', '0 N/m']",
               "16: support[2].rotational_stiffness[1] = 1 N/m: \"N/m\" is not a unit of "
               "rotational stiffness (examples: N m/rad, kN m/deg)"),
        change("BedThatEndsWhereItBegins", "at = 0.5\n", "at = 0.5\nto = 0.5\n",
               "16: support[2].stiffness[1] = 0 N/m: …"),
        change("BedThatRunsBack",
               "at = 0.5\nkind = 'elastic'\nstiffness = ['0 N/m', '1 kN/m', '0 N/m']",
               "at = 0.5\nto = 0.25\nkind = 'elastic'\nstiffness = ['0 Pa', '1 kPa', '0 Pa']",
               "15: support[2].to = 0.25: must lie beyond at = 0.5"),
        change("ClampOverALength", "kind = 'clamp'", "kind = 'clamp'\nto = 0.25",
               "13: support[1].to = 0.25: belongs to kind = \"elastic\""),
        change("InclinedRollerWithoutANormal", "'clamp'", "'inclined_roller'",
               "10: support[1].normal: is missing"),
        change("ClampWithANormal", "'clamp'", "'clamp'\nnormal = 'y'",
               "13: support[1].normal = 'y': belongs to kind = \"pillar\" or \"inclined_roller\""),
        change("WithAGapOfAClamp", "'clamp'", "'clamp'\ngap = '1 mm'",
               "13: support[1].gap = 1 mm: belongs to kind = \"pillar\""),
        add("PillarWithANegativeGap", "[[support]]\nat = 'end'\nkind = 'pillar'\ngap = '-1 mm'\n",
            "28: support[3].gap = -0.001: must be finite and not negative"),
        add("PillarThatHolds", "[[support]]\nat = 'end'\nkind = 'pillar'\nhold = ['x']\n",
            "28: support[3].hold: a pillar only pushes; what holds is another support"),
        add("InAPlaceThatIsTaken", "[[support]]\nat = { segment = 4 }\nkind = 'roller'\n",
            "26: support[3].at = { segment = 4 }: support[2] holds y at the same place"),
        change("ThatMovesWhatItDoesNotHold", "stiffness = ['0 N/m', '1 kN/m', '0 N/m']",
               "hold = ['y']\ntranslation = ['0 mm', '0 mm', '5 mm']",
               "17: support[2].translation = 0.005: moves z, which the support does not hold"),
        change("WithAHistoryOfNothing", "'clamp'", "'clamp'\nhistory = 'ramp'",
               "13: support[1].history = ramp: has no translation or rotation to move"),
        change("WithARotationInMetres", "'clamp'", "'clamp'\nrotation = ['1 m', '0 rad', '0 rad']",
               "13: support[1].rotation[1] = 1 m: \"m\" is not a unit of angle (examples: rad, "
               "deg)")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Load, BadChainScene,
    ::testing::Values(
        change("OfNothing", "force = ['0 N', '-100 N', '0 N']\n", "",
               "17: load[1]: needs force or moment"),
        change("InOneNumber", "['0 N', '-100 N', '0 N']", "'-100 N'",
               "19: load[1].force = '-100 N': must be a list in brackets"),
        change("WithoutUnit", "'-100 N'", "-100",
               "19: load[1].force[2] = -100: a force needs a unit (examples: N, kN, lbf)"),
        change("OfAMomentInNewton", "force = ['0 N', '-100 N', '0 N']",
               "moment = ['1 N', '0 N m', '0 N m']",
               "19: load[1].moment[1] = 1 N: \"N\" is not a unit of moment (examples: N m, kN m, "
               "lbf in)"),
        change("SpreadInNewton", "at = 'end'\nforce", "at = 'start'\nto = 'end'\nforce",
               "20: load[1].force[1] = 0 N: \"N\" is not a unit of force per length (examples: "
               "N/m, kN/m, lbf/in)"),
        change("SpreadOverNothing", "at = 'end'\nforce = ['0 N', '-100 N', '0 N']",
               "at = 'end'\nto = 'end'\nforce = ['0 N/m', '-100 N/m', '0 N/m']",
               "19: load[1].to = end: must lie beyond at = end"),
        change("ThatFollowsAWord", "history", "follows = 'yes'\nhistory",
               "20: load[1].follows = 'yes': must be true or false"),
        change("OfUnknownKey", "history", "direction = 'y'\nhistory",
               "20: load[1].direction = 'y': is not a key of load[1]; its keys are at, to, force, "
               "moment, follows, history"),
        change(
            "OfUnknownHistory", "'ramp'", "'step'",
            "20: load[1].history = step: must be \"ramp\", \"constant\", { cycles }, "
            "{ turning_points }, { time, factor }, { smooth_step }, { period, cycles } or { table, "
            "time, factor }"),
        change("OfASineWithoutEnd", "'ramp'", "{ period = '1 s' }",
               "20: load[1].history.cycles: is missing"),
        change(
            "OfASineInMetres", "'ramp'", "{ period = '1 m', cycles = 3 }",
            "20: load[1].history.period = 1 m: \"m\" is not a unit of time (examples: s, min, h)"),
        change("OfASineOfNoTime", "'ramp'", "{ period = '0 s', cycles = 3 }",
               "20: load[1].history.period = 0 s: must be above 0 s"),
        change("OfASineWithAnAmplitude", "'ramp'", "{ period = '1 s', cycles = 3, amplitude = 2 }",
               "20: load[1].history.amplitude = 2: is not a key of load[1].history; its keys are "
               "period, cycles, phase, offset"),
        change("OfAStepBackInTime", "'ramp'", "{ smooth_step = ['2 s', '1 s'] }",
               "20: load[1].history.smooth_step = ['2 s', '1 s']: must be two times, from and to, "
               "the first not before 0"),
        change(
            "OfNoTable", "'ramp'", "{ table = 'shaker.csv', time = 't', factor = 'a' }",
            "20: load[1].history.table = shaker.csv: is not a file in the folder of scene.toml…"),
        bad_scene("OfATableInKilonewtons",
                  changed(kChainScene, "'ramp'", "{ table = 'f.csv', time = 't', factor = 'F' }"),
                  "20: load[1].history.factor = F: …", {{"f.csv", "t [s],F [kN]\n0,0\n1,2\n"}}),
        change("OfNoCycles", "'ramp'", "{ cycles = 0 }",
               "20: load[1].history.cycles = 0: must be a whole number from 1 to 100000"),
        change("OfTwoHistories", "'ramp'", "{ cycles = 2, turning_points = [1] }",
               "20: load[1].history = { cycles = 2, turning_points = [1] }: must be \"ramp\", …"),
        change("WithTimesOfNoFactors", "'ramp'", "{ time = ['0 s', '1 s'] }",
               "20: load[1].history.factor: is missing"),
        change("WithMoreTimesThanFactors", "'ramp'", "{ time = ['0 s', '1 s'], factor = [1] }",
               "20: load[1].history = 2 times, 1 factors: must be as many of one as of the other, "
               "and at least one"),
        change("WithTimesThatRunBack", "'ramp'",
               "{ time = ['0 s', '2 s', '1 s'], factor = [0, 1, 2] }",
               "20: load[1].history.time = 1: must rise from one to the next"),
        change("WithTimesInMetres", "'ramp'", "{ time = ['0 m'], factor = [1] }",
               "20: load[1].history.time[1] = 0 m: \"m\" is not a unit of time (examples: s, min, "
               "h)"),
        change("OfNoTurningPoints", "'ramp'", "{ turning_points = [] }",
               "20: load[1].history.turning_points = []: must not be empty"),
        change("MisspelledHistory", "'ramp'", "{ turning_point = [1] }",
               "20: load[1].history.turning_point = [1]: is not a key of load[1].history; did you "
               "mean turning_points?"),
        change("ConstantWithoutDuration", "'ramp'", "'constant'",
               "8: solver.duration = 0: must be above 0 where every history is constant"),
        add("AndGravityInMetres", "[gravity]\ny = '-9.81 m'\n",
            "26: gravity.y = -9.81 m: \"m\" is not a unit of acceleration (examples: m/s^2, "
            "gravity)"),
        add("AndGravityOfUnknownKey", "[gravity]\nup = '1 m/s^2'\n",
            "26: gravity.up = '1 m/s^2': is not a key of gravity; its keys are x, y, z, "
            "acceleration, history"),
        change("ThatIsGravityInOneNumber", "[beam]", "gravity = '9.81 m/s^2'\n[beam]",
               "1: gravity = 9.81 m/s^2: must be a list of x, y and z, or a table of acceleration, "
               "or x, y and z, and history")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Rules, BadChainScene,
    ::testing::Values(
        change("UnknownYieldModel", "'interaction'", "'mises'",
               "7: rules.yield_model = mises: must be one of elastic, per_axis, interaction, "
               "conservative, fibre"),
        change("ReportWithInteraction", "yield_model = 'interaction'", "formulas = 'report'",
               "6: rules.yield_model: must be per_axis (or elastic) with the report's formulas, "
               "which clip each moment on its own"),
        change("TubeThatDoesNotFit", "shape = 'rectangle'", "shape = 'rectangular_tube'",
               "4: section.inner_width = 0.08: must be below section.width = 0.02"),
        change("ReportWithHalfJoints", "yield_model = 'interaction'",
               "yield_model = 'per_axis'\nformulas = 'report'\nend_rule = 'half_joint'",
               "9: rules.end_rule = half_joint: the report welds its ends: equal, half or "
               "three_halves"),
        change("ReportWithHingeLength", "yield_model = 'interaction'",
               "yield_model = 'per_axis'\nformulas = 'report'\nhinge_length = '20 mm'",
               "9: rules.hinge_length = 0.02: must be 0 or unset with the report's formulas, whose "
               "strain is over a joint's own length"),
        change("ReportWithHardening", "'interaction'\n",
               "'per_axis'\nformulas = 'report'\n"
               "[[region]]\nfrom = 0.5\nto = 'end'\nmaterial.hardening.law = 'linear'\n",
               "5: material.hardening.law: must be ideal with the report's formulas, which have no "
               "hardening"),
        change("FibresWithACap", "'interaction'", "'fibre'\nyield_cap = 'fully_plastic'",
               "8: rules.yield_cap = fully_plastic: a fibre section yields fibre by fibre and has "
               "no cap"),
        change("ConservativeFullyPlastic", "'interaction'",
               "'conservative'\nyield_cap = 'fully_plastic'",
               "8: rules.yield_cap = fully_plastic: the conservative surface is one of first "
               "yield"),
        change("BreakOfAnElasticBeam", "'interaction'", "'elastic'\nbreak_limit_x = '5 %'",
               "7: rules.yield_model = elastic: leaves no permanent strain that a break limit "
               "could be held against"),
        change("BreakLimitOfZero", "'interaction'", "'interaction'\nbreak_limit_x = 0",
               "8: rules.break_limit_x = 0: must be above 0"),
        change("BreakLimitInMegapascal", "'interaction'", "'interaction'\nbreak_limit_z = '1 MPa'",
               "8: rules.break_limit_z = 1 MPa: \"MPa\" is not a unit of strain (examples: %, 1, "
               "mm/mm, um/m)"),
        change("EndRuleThatSetsLengths",
               "segments = 8\n"
               "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
               "material = 'S355'\n[rules]\n",
               "segment_lengths = [0.5, 0.5]\n[rules]\nend_rule = 'half'\n",
               "5: rules.end_rule = half: sets the segment lengths itself")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Solver, BadChainScene,
    ::testing::Values(
        change("UnknownControl", "steps = 10", "control = 'force'",
               "9: solver.control = force: must be one of auto, load, displacement, arc_length"),
        change("NoSteps", "steps = 10", "steps = 0",
               "9: solver.steps = 0: must be from 1 to "
               "1e+07"),
        change("ToleranceOfZero", "steps = 10", "tolerance = 0",
               "9: solver.tolerance = 0: must be above 0 and below 1"),
        change("TurnWithoutUnit", "steps = 10", "largest_turn = 0.1",
               "9: solver.largest_turn = 0.1: an angle needs a unit (examples: rad, deg)"),
        change("WatchOffTheBeam", "steps = 10", "control_at = { segment = 12 }",
               "9: solver.control_at = { segment = 12 }: must be a segment from 1 to 8, or 0 for "
               "the start"),
        change("WatchOfLoadControl", "steps = 10", "control = 'load'\ncontrol_at = 'end'",
               "10: solver.control_at = end: is of no use with load control"),
        change("TwistOfABentBeam", "steps = 10", "level = 'twist'",
               "9: solver.level = twist: load[1].force has a component along y, and twist is about "
               "the beam's axis z alone"),
        change("PlaneOfASpatialScene", "steps = 10\n",
               "level = 'planar'\n[gravity]\nx = '1 m/s^2'\n",
               "9: solver.level = planar: gravity has a component along x, out of the y-z plane"),
        change("CouponOfAChain", "steps = 10", "level = 'coupon'",
               "9: solver.level = coupon: a scene with supports is no coupon")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Probe, BadChainScene,
    ::testing::Values(
        change("ByItsOldKey", "kind = 'displacement'", "quantity = 'displacement'",
               "23: probe[1].quantity = displacement: is called kind"),
        change("OfNoKind", "kind = 'displacement'\n", "", "21: probe[1].kind: is missing"),
        change("OfACoupon", "'displacement'", "'load'",
               "23: probe[1].kind = load: is recorded of a coupon alone"),
        add("OfUnknownDirection", "component = 'up'\n",
            "25: probe[1].component = 'up': must be one of \"x\", \"y\", \"z\", \"size\""),
        change("OfNoEnergy", "'displacement'\nat = 'end'", "'energy'",
               "21: probe[1].energy: is missing"),
        change("OfEnergyAtAPlace", "'displacement'", "'energy'\nenergy = 'plastic'",
               "25: probe[1].at = end: is of no use: energy is the whole beam's"),
        add("OfEnergyOfAPoint", "energy = 'plastic'\n",
            "25: probe[1].energy = plastic: belongs to kind = \"energy\""),
        change("OfAReactionWithoutSupport", "'displacement'", "'reaction'",
               "24: probe[1].at = end: has no support"),
        add("Twice", "[[probe]]\nname = 'tip'\nkind = 'moment'\n",
            "26: probe[2].name = tip: is the name of another probe, too")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Whole, BadChainScene,
    ::testing::Values(
        add("SceneWithADriveToo", "[drive]\nstrain = [0]\n",
            "10: support: does not go with [drive]: a scene is a chain with supports and loads, or "
            "a coupon with a drive"),
        change("SceneWithoutLoads",
               "[[load]]\nat = 'end'\nforce = ['0 N', '-100 N', '0 N']\nhistory = 'ramp'\n", "",
               " load: is missing: give a [[load]], gravity, or a support's translation or "
               "rotation"),
        change("BeamThatSlides", "kind = 'clamp'", "kind = 'roller'",
               "10: support: the supports together leave the beam free to move along z (level "
               "planar)"),
        change("BeamThatTurns",
               "kind = 'clamp'\n[[support]]\nat = 0.5\nkind = 'elastic'\n"
               "stiffness = ['0 N/m', '1 kN/m', '0 N/m']",
               "kind = 'pin'",
               "10: support: the supports together leave the beam free to rotate about x (level "
               "planar)")),
    name_of_case);

}  // namespace
}  // namespace plastica::testing
