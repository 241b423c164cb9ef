#include "tests/cli/bad_chain_scene.hpp"

namespace plastica::testing {
namespace {

class BadRegion : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadRegion, IsRefusedInOneLine) { expect_refusal(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Region, BadRegion,
    ::testing::Values(
        add_to_chain("OfNothing", "[[region]]\nfrom = 'start'\nto = 0.5\n",
                     "25: region[1]: needs a section or a material"),
        add_to_chain(
            "WhoseRegionHasADimensionOfItsOwn",
            "[[region]]\nfrom = 0.5\nto = 'end'\nwidth = '40 mm'\n",
            "28: region[1].width = '40 mm': is not a key of region[1]; its keys are from, to, "
            "section, to_section, material"),
        add_to_chain("WithoutEnd", "[[region]]\nfrom = 'start'\nmaterial = 'S235'\n",
                     "25: region[1].to: is missing"),
        add_to_chain("ThatRunsBack", "[[region]]\nfrom = 0.5\nto = 0.25\nmaterial = 'S235'\n",
                     "27: region[1].to = 0.25: must lie beyond from = 0.5"),
        add_to_chain("OutOfRange", "[[region]]\nfrom = 0.5\nto = 'end'\nsection.width = '-1 mm'\n",
                     "28: region[1].section.width = -1 mm: must be above 0 m"),
        add_to_chain("OfUnknownMaterial", "[[region]]\nfrom = 0.5\nto = 'end'\nmaterial = 'S1'\n",
                     "28: region[1].material = S1: must be one of S235, …"),
        add_to_chain(
            "WithAnUnknownKey",
            "[[region]]\nfrom = 0.5\nto = 'end'\nsection.width = '1 mm'\nshape = 'circle'\n",
            "29: region[1].shape = 'circle': is not a key of region[1]; its keys are from, to, "
            "section, to_section, material"),
        add_to_chain("ThatTapersToAnotherShape",
                     "[[region]]\nfrom = 0.5\nto = 'end'\nto_section.shape = 'circle'\n"
                     "to_section.radius = '1 mm'\n",
                     "28: region[1].to_section.shape = circle: must be that of section, rectangle"),
        add_to_chain("ThatTapersToNothing",
                     "[[region]]\nfrom = 0.5\nto = 'end'\nto_section.height = '0 mm'\n",
                     "28: region[1].to_section.height = 0 mm: must be above 0 m"),
        add_to_chain("ThatTapersWithATypingError",
                     "[[region]]\nfrom = 0.5\nto = 'end'\nto_sektion.height = '1 mm'\n",
                     "28: region[1].to_sektion: is not a key of region[1]; "
                     "did you mean to_section?"),
        add_to_chain("OfAnotherKindOfSurface",
                     "[[region]]\nfrom = 0.5\nto = 'end'\nsection.shape = 'circle'\n"
                     "section.radius = '10 mm'\n",
                     "28: region[1].section.shape = circle: yields by another kind of surface than "
                     "the rest of the beam: take rules.yield_model = per_axis or fibre"),
        add_to_chain(
            "OfAnotherHardeningLaw",
            "[[region]]\nfrom = 0.5\nto = 'end'\nmaterial.hardening.law = 'linear'\n"
            "material.hardening.tangent_modulus = '1 GPa'\n",
            "28: region[1].material.hardening.law = linear: must be that of the rest of the "
            "beam, ideal"),
        add_to_chain("OfAnotherRateLaw",
                     "[[region]]\nfrom = 0.5\nto = 'end'\n[region.material.rate]\n"
                     "law = 'johnson_cook'\nreference_rate = '1 1/s'\ncoefficient = 0.01\n"
                     "strain_rate = '1 1/s'\n",
                     "29: region[1].material.rate.law = johnson_cook: must be that of the rest of "
                     "the beam, none")),
    name_of_case);

}  // namespace
}  // namespace plastica::testing
