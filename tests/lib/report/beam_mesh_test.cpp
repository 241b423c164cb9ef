#include "plastica/report/vtk/beam_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "plastica/model/section.hpp"
#include "plastica/report/vtk/vtkhdf_file.hpp"
#include "tests/support/motion_record.hpp"
#include "tests/support/scene_record.hpp"

namespace plastica::report {
namespace {

using plastica::testing::motion_record;
using plastica::testing::record_of;

/// Twice the area that edges enclose, the material to their left (Green): sum of x dy - y dx.
double area_of_edges(const SectionFaces& faces) {
  double sum = 0.0;
  for (const auto& [from, to] : faces.edges) {
    const Point2& a = faces.corners[from];
    const Point2& b = faces.corners[to];
    sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return sum;
}

double area_of_faces(const SectionFaces& faces) {
  double sum = 0.0;
  for (const auto& face : faces.faces) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Point2& a = faces.corners[face[k]];
      const Point2& b = faces.corners[face[(k + 1) % 4]];
      sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
  }
  return sum;
}

Section section_of(SectionShape shape) {
  Section section;
  section.shape = shape;
  section.width = 0.12;
  section.height = 0.2;
  section.flange_thickness = 0.02;
  section.web_thickness = 0.01;
  return section;
}

TEST(SectionFaces, CoverTheAreaOfTheSection) {
  // A polygon of 16 sides has 97.45 % of its circle.
  const double of_circle = 8.0 / std::numbers::pi * std::sin(std::numbers::pi / 8.0);
  for (const SectionShape shape :
       {SectionShape::Rectangle, SectionShape::Circle, SectionShape::RoundTube,
        SectionShape::RectangularTube, SectionShape::ISection}) {
    const Section section = section_of(shape);
    const bool round = shape == SectionShape::Circle || shape == SectionShape::RoundTube;
    const double area = section_properties(section, 0.3).area * (round ? of_circle : 1.0);
    const SectionFaces faces = section_faces(section);
    EXPECT_NEAR(area_of_edges(faces) / area, 1.0, 1e-12) << static_cast<int>(shape);
    EXPECT_NEAR(area_of_faces(faces) / area, 1.0, 1e-12) << static_cast<int>(shape);
  }
}

TEST(SectionFaces, OfNumbersAreTheRectangleAround) {
  Section section;
  section.shape = SectionShape::Numbers;
  section.numbers = {.area = 1e-3,
                     .second_moment_x = 1e-6,
                     .second_moment_y = 5e-7,
                     .section_modulus_x = 2e-5,
                     .section_modulus_y = 2e-5};
  const SectionFaces faces = section_faces(section);
  ASSERT_EQ(faces.corners.size(), 4U);
  EXPECT_NEAR(std::abs(faces.corners[0][0]), 5e-7 / 2e-5, 1e-15);  // I/W about y
  EXPECT_NEAR(std::abs(faces.corners[0][1]), 1e-6 / 2e-5, 1e-15);
}

/// The volume that a surface encloses, seen from outside counterclockwise: a sixth of the
/// determinants of its triangles' corners (Gauss).
double volume_of(const BeamMesh& mesh, const std::vector<Point3>& points) {
  double sum = 0.0;
  const auto add = [&](const Point3& a, const Point3& b, const Point3& c) {
    sum += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
            a[2] * (b[0] * c[1] - b[1] * c[0])) /
           6.0;
  };
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell) {
    const auto corner = [&](std::size_t k) -> const Point3& {
      return points[static_cast<std::size_t>(mesh.corners()[4 * cell + k])];
    };
    add(corner(0), corner(1), corner(2));
    add(corner(0), corner(2), corner(3));
  }
  return sum;
}

std::string bent_text(const std::string& section, const std::string& more = "") {
  return "material = 'S355'\n[beam]\nlength = '1 m'\nsegments = 6\nsection = " + section +
         "\n[rules]\nyield_model = 'elastic'\n[solver]\nsteps = 4\n" + more +
         "[[support]]\nat = 'start'\nkind = 'clamp'\n"
         "[[load]]\nat = 'end'\nforce = ['0 N', '-2 kN', '0 N']\n"
         "[[probe]]\nkind = 'displacement'\nat = 'end'\n";
}

TEST(BeamMesh, EnclosesTheBeamsVolumeBentOrNot) {
  const std::string tube =
      "{ shape = 'rectangular_tube', width = '40 mm', height = '60 mm', inner_width = '30 mm', "
      "inner_height = '50 mm' }";
  const std::string profile =
      "{ shape = 'i_section', width = '40 mm', height = '60 mm', flange_thickness = '6 mm', "
      "web_thickness = '4 mm' }";
  const double of_tube = 0.04 * 0.06 - 0.03 * 0.05;
  const double of_profile = 2.0 * 0.04 * 0.006 + 0.048 * 0.004;
  const std::string half = "[[region]]\nfrom = 0.5\nto = 1.0\nsection = " + profile + "\n";
  const auto check = [](const std::string& text, double volume) {
    const io::SceneRecord record = record_of(text);
    const BeamMesh mesh(record);
    for (const std::size_t frame : {kUndeformed, std::size_t{0}, std::size_t{4}}) {
      const std::vector<Point3> points = mesh.points_of(BeamPose(record, frame));
      ASSERT_EQ(points.size(), mesh.points());
      EXPECT_NEAR(volume_of(mesh, points) / volume, 1.0, 1e-9) << frame << text;
    }
  };
  check(bent_text(tube), of_tube);
  check(bent_text(profile), of_profile);
  check(bent_text(tube, half), 0.5 * (of_tube + of_profile));
}

/// Gives segments velocities. @param of  a segment: of its inner end, and its spin
template <class Of>
void set_velocities(io::SceneRecord& record, std::size_t frame, const Of& of) {
  ChainHistory& chain = record.response.chain;
  chain.velocity.assign(chain.rotation.size(), 0.0);
  chain.spin.assign(chain.rotation.size(), 0.0);
  const std::size_t n = record.outline.segments();
  for (std::size_t s = 0; s < n; ++s) {
    const auto [velocity, spin] = of(s);
    for (std::size_t k = 0; k < 3; ++k) {
      chain.velocity[3 * (frame * n + s) + k] = velocity[k];
      chain.spin[3 * (frame * n + s) + k] = spin[k];
    }
  }
}

TEST(BeamMesh, MovesEachPointAsItsRigidBodyDoes) {
  io::SceneRecord record = motion_record({.segments = 8});
  constexpr std::size_t kFrame = 20;
  const BeamPose pose(record, kFrame);
  ASSERT_EQ(pose.fragments().size(), 3U);
  // Fragments turn about the origin, each at its own speed; segments of one move as one.
  const auto spin_of = [](std::size_t segment) {
    const double speed = segment < 4 ? 1.0 : segment < 6 ? -2.0 : 5.0;
    return Point3{0.3 * speed, -0.7 * speed, 1.1 * speed};
  };
  set_velocities(record, kFrame, [&](std::size_t s) {
    return std::pair(cross(spin_of(s), pose.inner(s)), spin_of(s));
  });
  const BeamMesh mesh(record);
  const std::vector<Point3> points = mesh.points_of(pose);
  const std::vector<Point3> velocities = mesh.velocities_of(pose);
  ASSERT_EQ(velocities.size(), mesh.points());
  const std::size_t of_segment = mesh.points() / 8;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Point3 exact = cross(spin_of(p / of_segment), points[p]);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(velocities[p][k], exact[k], 1e-12) << p << ' ' << k;
    }
  }
}

TEST(BeamMesh, EndsASegmentWithTheVelocityOfItsJoint) {
  io::SceneRecord record = motion_record({.segments = 8});
  // Segment s moves along x by s: ends meet in the joint's velocity, unless it is cut.
  set_velocities(record, 20, [](std::size_t s) {
    return std::pair(Point3{static_cast<double>(s), 0.0, 0.0}, Point3{});
  });
  const BeamMesh mesh(record);
  const std::vector<Point3> velocities = mesh.velocities_of(BeamPose(record, 20));
  const std::size_t ring = mesh.points() / 8 / 3;
  for (std::size_t s = 0; s < 8; ++s) {
    const bool joined = s != 3 && s != 5 && s != 7;
    const auto inner = static_cast<double>(s);
    const double outer = joined ? inner + 1.0 : inner;
    for (std::size_t c = 0; c < ring; ++c) {
      EXPECT_EQ(velocities[3 * ring * s + c][0], inner);
      EXPECT_EQ(velocities[3 * ring * s + ring + c][0], 0.5 * (inner + outer));
      EXPECT_EQ(velocities[3 * ring * s + 2 * ring + c][0], outer);
    }
  }
}

TEST(BeamMesh, KeepsItsCellsThroughCuts) {
  const io::SceneRecord record = motion_record({.segments = 8});
  const BeamMesh mesh(record);
  const std::vector<std::int32_t> whole = mesh.fragment_of(BeamPose(record, 0));
  const BeamPose cut(record, 20);
  ASSERT_EQ(cut.fragments().size(), 3U);
  const std::vector<std::int32_t> parts = mesh.fragment_of(cut);
  ASSERT_EQ(parts.size(), mesh.cells());
  for (std::size_t c = 0; c < mesh.cells(); ++c) {
    EXPECT_EQ(whole[c], 0);
    const std::int32_t s = mesh.segment()[c];
    EXPECT_EQ(parts[c], s < 4 ? 0 : s < 6 ? 1 : 2);
    EXPECT_TRUE(mesh.joint()[c] == s || mesh.joint()[c] == s + 1);
  }
}

TEST(XdmfText, EscapesTheNameOfTheFileBesideIt) {
  const io::SceneRecord record = motion_record({.segments = 8});
  const std::string text = xdmf_text(record, "a<b>&\"c\".vtkhdf");
  EXPECT_EQ(text.find("a<b>"), std::string::npos);
  EXPECT_NE(text.find("a&lt;b&gt;&amp;"), std::string::npos);
}

}  // namespace
}  // namespace plastica::report
