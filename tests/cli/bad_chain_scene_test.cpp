#include "tests/cli/bad_chain_scene.hpp"

namespace plastica::testing {
namespace {

class BadChainScene : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadChainScene, IsRefusedInOneLine) { expect_refusal(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Beam, BadChainScene,
    ::testing::Values(
        change_chain("UnknownShape", "length = '4 m'", "shape = 'bow'",
                     "2: beam.shape = bow: must be one of straight, arc, polyline"),
        change_chain(
            "SectionTwice", "[rules]", "[section]\nwidth = '1 m'\n[rules]",
            "4: beam.section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }: is "
            "given twice: the file has [section], too"),
        change_chain("MaterialTwice", "[rules]", "[material]\nname = 'S235'\n[rules]",
                     "5: beam.material = S355: is given twice: the file has [material], too"),
        change_chain("SectionOutOfRange", "width = '20 mm'", "width = '-20 mm'",
                     "4: beam.section.width = -20 mm: must be above 0 m"),
        change_chain("UnknownKeyOfSection", "height", "depth",
                     "4: beam.section.depth = '20 mm': is not a key of beam.section; its keys are "
                     "profile, shape, …"),
        change_chain("UnknownMaterial", "S355", "S3555",
                     "5: beam.material = S3555: must be one of S235, S275, S355, …"),
        change_chain("NoSegments", "segments = 8", "segments = 0",
                     "3: beam.segments = 0: must be from 1 to 1e+07"),
        change_chain("ArcWithoutAngle", "length", "shape = 'arc'\nlength",
                     "1: beam.arc_angle: is missing"),
        change_chain("ArcAngleWithoutUnit", "length", "shape = 'arc'\narc_angle = 45\nlength",
                     "3: beam.arc_angle = 45: an angle needs a unit (examples: rad, deg)"),
        change_chain("ArcAngleZero", "length", "shape = 'arc'\narc_angle = '0 deg'\nlength",
                     "3: beam.arc_angle = 0: must be above 0 and at most a full turn, 2 pi rad"),
        change_chain("ArcAngleOfAStraightBeam", "length", "arc_angle = '45 deg'\nlength",
                     "2: beam.arc_angle = 45 deg: belongs to beam.shape = \"arc\""),
        change_chain(
            "ArcAlongTheBeam", "length",
            "shape = 'arc'\narc_angle = '45 deg'\narc_towards = 'z'\nlength",
            "4: beam.arc_towards = 1: is its z component and must be 0: the beam starts along "
            "z"),
        change_chain(
            "UnknownDirection", "length",
            "shape = 'arc'\narc_angle = '45 deg'\narc_towards = 'up'\nlength",
            "4: beam.arc_towards = 'up': must be one of \"x\", \"y\", \"z\", \"-x\", \"-y\", "
            "\"-z\""),
        change_chain("DirectionOfNoSize", "length",
                     "shape = 'arc'\narc_angle = '45 deg'\narc_towards = [0, 0, 0]\nlength",
                     "4: beam.arc_towards = [0, 0, 0]: has no direction"),
        change_chain("PolylineWithoutPoints", "length", "shape = 'polyline'\nlength",
                     "1: beam.points: is missing"),
        change_chain("PolylineOfOnePoint", "length = '4 m'",
                     "shape = 'polyline'\npoints = [['0 m', '0 m', '0 m']]",
                     "3: beam.points = [['0 m', '0 m', '0 m']]: must be at least two points"),
        change_chain("PointOfTwoCoordinates", "length = '4 m'",
                     "shape = 'polyline'\npoints = [['0 m', '0 m', '0 m'], ['0 m', '1 m']]",
                     "3: beam.points[2] = ['0 m', '1 m']: must have three components: x, y and z"),
        change_chain(
            "PointsOfAnotherLength", "length",
            "shape = 'polyline'\n"
            "points = [['0 m', '0 m', '0 m'], ['0 m', '0 m', '3 m']]\nlength",
            "3: beam.points = [['0 m', '0 m', '0 m'], ['0 m', '0 m', '3 m']]: add up to 3 m, "
            "and the beam's length is 4 m"),
        change_chain("PointTwice", "length = '4 m'",
                     "shape = 'polyline'\npoints = [['0 m', '0 m', '0 m'], ['0 m', '0 m', '0 m'], "
                     "['0 m', '0 m', '1 m']]",
                     "3: beam.points[2]: is the same as the one before")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Lengths, BadChainScene,
    ::testing::Values(
        change_chain(
            "SegmentLengthsOfAnotherBeam", "segments = 8", "segment_lengths = ['1 m', '2 m']",
            "3: beam.segment_lengths = ['1 m', '2 m']: add up to 3 m, and the beam's length is "
            "4 m"),
        change_chain(
            "OtherNumberOfSegmentLengths", "segments = 8",
            "segments = 8\nsegment_lengths = ['2 m', '2 m']",
            "4: beam.segment_lengths = ['2 m', '2 m']: are 2 lengths, and beam.segments is 8"),
        change_chain("SegmentOfNoLength", "segments = 8", "segment_lengths = ['4 m', '0 m']",
                     "3: beam.segment_lengths[2] = 0 m: must be above 0"),
        change_chain(
            "FractionsThatAreNotAll", "segments = 8", "segment_lengths = [0.5, 0.25]",
            "3: beam.segment_lengths = [0.5, 0.25]: are fractions that add up to 0.75: must be 1; "
            "lengths need a unit"),
        change_chain(
            "FractionsAndLengths", "segments = 8", "segment_lengths = ['2 m', 0.5]",
            "3: beam.segment_lengths[2] = 0.5: a length needs a unit (examples: m, mm, in)"),
        change_chain("JointLengthsOfAnotherBeam", "segments = 8",
                     "segments = 8\njoint_lengths = ['0.5 m', '0.5 m']",
                     "4: beam.joint_lengths = 2 values: must be 7 for the beam's segments"),
        change_chain("JointOfNegativeLength", "segments = 8",
                     "segments = 2\njoint_lengths = ['-1 m']",
                     "4: beam.joint_lengths[1] = -1: must be positive and finite")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Support, BadChainScene,
    ::testing::Values(
        change_chain("Nowhere", "at = 'start'\nkind", "kind", "10: support[1].at: is missing"),
        change_chain("OfNoKind", "kind = 'clamp'\n", "", "10: support[1].kind: is missing"),
        change_chain(
            "OfUnknownKind", "'clamp'", "'clamped'",
            "12: support[1].kind = 'clamped': must be one of \"clamp\", \"pin\", \"roller\", "
            "\"guide\", \"elastic\", \"pillar\", \"inclined_roller\", \"hinge\""),
        change_chain(
            "AtAnUnknownPlace", "'start'", "'middle'",
            "11: support[1].at = middle: must be \"start\", \"end\", { segment = 3 } (its outer "
            "end), or a fraction of the length: 0.25, \"25 %\""),
        change_chain("BeyondTheEnd", "at = 0.5", "at = 1.5",
                     "14: support[2].at = 1.5: must be a fraction of the length, 0 to 1"),
        change_chain(
            "BehindTheLastSegment", "at = 0.5", "at = { segment = 9 }",
            "14: support[2].at = { segment = 9 }: must be a segment from 1 to 8, or 0 for the "
            "start"),
        change_chain(
            "AtAWholeNumber", "at = 0.5", "at = 1",
            "14: support[2].at = 1: is neither a segment nor a fraction: write { segment = 1 } "
            "for the outer end of that segment, or a fraction of the length with a point, 0.25 "
            "(the end is 1.0 or \"end\")"),
        change_chain("AtAWholeNumberBelowZero", "at = 0.5", "at = -1",
                     "14: support[2].at = -1: must be a fraction of the length, 0 to 1"),
        change_chain("AtASegmentThatIsAFraction", "at = 0.5", "at = { segment = 1.5 }",
                     "14: support[2].at.segment = 1.5: must be an integer from 0 to 2147483647"),
        change_chain("AtATableWithoutASegment", "at = 0.5", "at = { joint = 1 }",
                     "14: support[2].at.segment: is missing"),
        change_chain(
            "MoreStretchesThanSegments", "segments = 8", "segments = 1",
            "3: beam.segments = 1: must be at least 2, since segments end at support[2].at = 0.5"),
        change_chain(
            "RegionWithinASegmentOfGivenLength", "[beam]\nlength = '4 m'\nsegments = 8",
            "region = [{ from = 0.3, to = 'end', material = 'S235' }]\n"
            "[beam]\nlength = '4 m'\nsegment_lengths = ['1 m', '2 m', '1 m']",
            "1: region[1].from = 0.3: must be where a segment ends, which beam.segment_lengths "
            "sets; the nearest ends are 0.25 and 0.75"),
        change_chain(
            "ThatHoldsAWord", "'clamp'", "'clamp'\nhold = ['y', 'pitch']",
            "13: support[1].hold[2] = 'pitch': must be one of \"x\", \"y\", \"z\", \"rx\", "
            "\"ry\", \"rz\""),
        change_chain("ThatHoldsTwice", "'clamp'", "'clamp'\nhold = ['y', 'y']",
                     "13: support[1].hold[2] = y: is in the list twice"),
        change_chain("ThatHoldsNothing", "'clamp'", "'clamp'\nhold = []",
                     "13: support[1].hold = []: must hold something"),
        change_chain("WithASpringThatItHolds", "'elastic'", "'elastic'\nhold = ['y']",
                     "16: support[2].hold = y: has a spring, too"),
        change_chain("ElasticWithoutSpring", "stiffness = ['0 N/m', '1 kN/m', '0 N/m']\n", "",
                     "13: support[2]: an elastic support needs stiffness or rotational_stiffness"),
        change_chain("WithSpringsOfAnotherKind", "'elastic'", "'roller'",
                     "16: support[2].stiffness = ['0 N/m', '1 kN/m', '0 N/m']: belongs to kind = "
                     "\"elastic\""),
        change_chain(
            "WithAStiffnessInNewton", "1 kN/m", "1 kN",
            "16: support[2].stiffness[2] = 1 kN: \"kN\" is not a unit of stiffness (examples: "
            "N/m, kN/mm, lbf/in)"),
        change_chain("WithANegativeSpring", "1 kN/m", "-1 kN/m",
                     "16: support[2].stiffness = -1000: must be at least 0"),
        change_chain("WithARotationalStiffnessPerLength",
                     "stiffness = ['0 N/m', '1 kN/m', '0 N/m']",
                     "rotational_stiffness = ['1 N/m', '0 N/m', '0 N/m']",
                     "16: support[2].rotational_stiffness[1] = 1 N/m: \"N/m\" is not a unit of "
                     "rotational stiffness (examples: N m/rad, kN m/deg)"),
        change_chain("BedThatEndsWhereItBegins", "at = 0.5\n", "at = 0.5\nto = 0.5\n",
                     "17: support[2].stiffness[1] = 0 N/m: …"),
        change_chain("BedThatRunsBack",
                     "at = 0.5\nkind = 'elastic'\nstiffness = ['0 N/m', '1 kN/m', '0 N/m']",
                     "at = 0.5\nto = 0.25\nkind = 'elastic'\nstiffness = ['0 Pa', '1 kPa', '0 Pa']",
                     "15: support[2].to = 0.25: must lie beyond at = 0.5"),
        change_chain("ClampOverALength", "kind = 'clamp'", "kind = 'clamp'\nto = 0.25",
                     "13: support[1].to = 0.25: belongs to kind = \"elastic\""),
        change_chain("InclinedRollerWithoutANormal", "'clamp'", "'inclined_roller'",
                     "10: support[1].normal: is missing"),
        change_chain(
            "ClampWithANormal", "'clamp'", "'clamp'\nnormal = 'y'",
            "13: support[1].normal = y: belongs to kind = \"pillar\" or \"inclined_roller\""),
        change_chain("WithAGapOfAClamp", "'clamp'", "'clamp'\ngap = '1 mm'",
                     "13: support[1].gap = 1 mm: belongs to kind = \"pillar\""),
        add_to_chain("PillarWithANegativeGap",
                     "[[support]]\nat = 'end'\nkind = 'pillar'\ngap = '-1 mm'\n",
                     "28: support[3].gap = -0.001: must be at least 0"),
        add_to_chain("PillarThatHolds", "[[support]]\nat = 'end'\nkind = 'pillar'\nhold = ['x']\n",
                     "28: support[3].hold: a pillar only pushes; what holds is another support"),
        add_to_chain("InAPlaceThatIsTaken", "[[support]]\nat = { segment = 4 }\nkind = 'roller'\n",
                     "26: support[3].at = { segment = 4 }: support[2] holds y at the same place"),
        change_chain(
            "ThatMovesWhatItDoesNotHold", "stiffness = ['0 N/m', '1 kN/m', '0 N/m']",
            "hold = ['y']\ntranslation = ['0 mm', '0 mm', '5 mm']",
            "17: support[2].translation = 0.005: moves z, which the support does not hold"),
        change_chain("WithAHistoryOfNothing", "'clamp'", "'clamp'\nhistory = 'ramp'",
                     "13: support[1].history = ramp: has no translation or rotation to move"),
        change_chain(
            "WithARotationInMetres", "'clamp'", "'clamp'\nrotation = ['1 m', '0 rad', '0 rad']",
            "13: support[1].rotation[1] = 1 m: \"m\" is not a unit of angle (examples: rad, "
            "deg)")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Rules, BadChainScene,
    ::testing::Values(
        change_chain("UnknownYieldModel", "'interaction'", "'mises'",
                     "7: rules.yield_model = mises: must be one of elastic, per_axis, interaction, "
                     "conservative, fibre"),
        change_chain(
            "ReportWithInteraction", "yield_model = 'interaction'", "formulas = 'report'",
            "6: rules.yield_model: must be per_axis (or elastic) with Wendelius' formulas, "
            "which clip each moment on its own"),
        change_chain("TubeThatDoesNotFit", "shape = 'rectangle'",
                     "shape = 'rectangular_tube', inner_width = '30 mm', inner_height = '10 mm'",
                     "4: section.inner_width = 0.03: must be below section.width = 0.02"),
        change_chain("ReportWithHalfJoints", "yield_model = 'interaction'",
                     "yield_model = 'per_axis'\nformulas = 'report'\nend_rule = 'half_joint'",
                     "9: rules.end_rule = half_joint: Wendelius' report clamps its ends rigidly: "
                     "equal, half or "
                     "three_halves"),
        change_chain(
            "ReportWithHingeLength", "yield_model = 'interaction'",
            "yield_model = 'per_axis'\nformulas = 'report'\nhinge_length = '20 mm'",
            "9: rules.hinge_length = 0.02: must be 0 or unset with Wendelius' formulas, whose "
            "strain is over a joint's own length"),
        change_chain(
            "ReportWithHardening", "'interaction'\n",
            "'per_axis'\nformulas = 'report'\n"
            "[[region]]\nfrom = 0.5\nto = 'end'\nmaterial.hardening.law = 'linear'\n",
            "5: material.hardening.law: must be ideal with Wendelius' formulas, which have no "
            "hardening"),
        change_chain(
            "FibresWithACap", "'interaction'", "'fibre'\nyield_cap = 'fully_plastic'",
            "8: rules.yield_cap = fully_plastic: a fibre section yields fibre by fibre and has "
            "no cap"),
        change_chain("ConservativeFullyPlastic", "'interaction'",
                     "'conservative'\nyield_cap = 'fully_plastic'",
                     "8: rules.yield_cap = fully_plastic: the conservative surface is one of first "
                     "yield"),
        change_chain(
            "BreakOfAnElasticBeam", "'interaction'", "'elastic'\nbreak_limit_x = '5 %'",
            "7: rules.yield_model = elastic: leaves no permanent strain that a break limit "
            "could be held against"),
        change_chain("BreakLimitOfZero", "'interaction'", "'interaction'\nbreak_limit_x = 0",
                     "8: rules.break_limit_x = 0: must be above 0"),
        change_chain(
            "BreakLimitInMegapascal", "'interaction'", "'interaction'\nbreak_limit_z = '1 MPa'",
            "8: rules.break_limit_z = 1 MPa: \"MPa\" is not a unit of strain (examples: %, 1, "
            "mm/mm, um/m)"),
        change_chain("EndRuleThatSetsLengths",
                     "segments = 8\n"
                     "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
                     "material = 'S355'\n[rules]\n",
                     "segment_lengths = [0.5, 0.5]\n[rules]\nend_rule = 'half'\n",
                     "5: rules.end_rule = half: sets the segment lengths itself")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Solver, BadChainScene,
    ::testing::Values(
        change_chain(
            "UnknownControl", "steps = 10", "control = 'force'",
            "9: solver.control = force: must be one of auto, load, displacement, arc_length"),
        change_chain("NoSteps", "steps = 10", "steps = 0",
                     "9: solver.steps = 0: must be from 1 to "
                     "1e+07"),
        change_chain("ToleranceOfZero", "steps = 10", "tolerance = 0",
                     "9: solver.tolerance = 0: must be above 0 and below 1"),
        change_chain(
            "TurnWithoutUnit", "steps = 10", "largest_rotation = 0.1",
            "9: solver.largest_rotation = 0.1: an angle needs a unit (examples: rad, deg)"),
        change_chain(
            "WatchOffTheBeam", "steps = 10", "control_at = { segment = 12 }",
            "9: solver.control_at = { segment = 12 }: must be a segment from 1 to 8, or 0 for "
            "the start"),
        change_chain("WatchOfLoadControl", "steps = 10", "control = 'load'\ncontrol_at = 'end'",
                     "10: solver.control_at = end: is of no use with load control"),
        change_chain(
            "TwistOfABentBeam", "steps = 10", "level = 'twist'",
            "9: solver.level = twist: load[1].force has a component along y, and twist is about "
            "the beam's axis z alone"),
        change_chain(
            "PlaneOfASpatialScene", "steps = 10\n", "level = 'planar'\n[gravity]\nx = '1 m/s^2'\n",
            "9: solver.level = planar: gravity has a component along x, out of the y-z plane"),
        change_chain("CouponOfAChain", "steps = 10", "level = 'coupon'",
                     "9: solver.level = coupon: a scene with supports is no coupon")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Probe, BadChainScene,
    ::testing::Values(
        change_chain("ByItsOldKey", "kind = 'displacement'", "quantity = 'displacement'",
                     "23: probe[1].quantity = displacement: is called kind"),
        change_chain("OfNoKind", "kind = 'displacement'\n", "", "21: probe[1].kind: is missing"),
        change_chain("OfACoupon", "'displacement'", "'load'",
                     "23: probe[1].kind = load: is recorded of a coupon alone"),
        add_to_chain("OfUnknownDirection", "component = 'up'\n",
                     "25: probe[1].component = 'up': must be one of \"x\", \"y\", \"z\", \"size\""),
        change_chain("OfNoEnergy", "'displacement'\nat = 'end'", "'energy'",
                     "21: probe[1].energy: is missing"),
        change_chain("OfEnergyAtAPlace", "'displacement'", "'energy'\nenergy = 'plastic'",
                     "25: probe[1].at = end: is of no use: energy is the whole beam's"),
        add_to_chain("OfEnergyOfAPoint", "energy = 'plastic'\n",
                     "25: probe[1].energy = plastic: belongs to kind = \"energy\""),
        change_chain("OfAReactionWithoutSupport", "'displacement'", "'reaction'",
                     "24: probe[1].at = end: has no support"),
        add_to_chain("Twice", "[[probe]]\nname = 'tip'\nkind = 'moment'\n",
                     "26: probe[2].name = tip: is the name of another probe, too")),
    name_of_case);

INSTANTIATE_TEST_SUITE_P(
    Whole, BadChainScene,
    ::testing::Values(
        add_to_chain(
            "SceneWithADriveToo", "[drive]\nstrain = [0]\n",
            "10: support: does not go with [drive]: a scene is a chain with supports and loads, or "
            "a coupon with a drive"),
        change_chain("SceneWithoutLoads",
                     "[[load]]\nat = 'end'\nforce = ['0 N', '-100 N', '0 N']\nhistory = 'ramp'\n",
                     "",
                     " load: is missing: give a [[load]], gravity, or a support's translation or "
                     "rotation"),
        change_chain(
            "BeamThatSlides", "kind = 'clamp'", "kind = 'roller'",
            "10: support: the supports together leave the beam free to move along z (level "
            "planar)"),
        change_chain(
            "BeamThatTurns",
            "kind = 'clamp'\n[[support]]\nat = 0.5\nkind = 'elastic'\n"
            "stiffness = ['0 N/m', '1 kN/m', '0 N/m']",
            "kind = 'pin'",
            "10: support: the supports together leave the beam free to rotate about x (level "
            "planar)")),
    name_of_case);

}  // namespace
}  // namespace plastica::testing
