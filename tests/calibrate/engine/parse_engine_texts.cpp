#include "tests/calibrate/engine/parse_engine_texts.hpp"

#include <cstdlib>
#include <limits>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace plastica::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) {
    if (at != ' ' || !part.empty()) parts.push_back(part);
  }
  return parts;
}

std::array<double, 3> triple(const std::string& text) {
  const auto parts = split(text, ' ');
  return {std::stod(parts.at(0)), std::stod(parts.at(1)), std::stod(parts.at(2))};
}

/// The attributes of an element of XML.
std::map<std::string, std::string> attributes(const std::string& element) {
  static const std::regex pair(R"re((\w+)="([^"]*)")re");
  std::map<std::string, std::string> found;
  for (std::sregex_iterator at(element.begin(), element.end(), pair), end; at != end; ++at) {
    found[(*at)[1]] = (*at)[2];
  }
  return found;
}

bool ends_with(const std::string& text, const std::string& ending, std::string& before) {
  if (!text.ends_with(ending)) return false;
  before = text.substr(0, text.size() - ending.size());
  return true;
}

/// The axis in "joint_1_x", which is taken off.
std::size_t take_axis(std::string& name) {
  const auto axis = static_cast<std::size_t>(name.back() - 'x');
  name.resize(name.size() - 2);
  return axis;
}

/// The numbers and words of a table's row, whatever brackets are between them.
std::vector<std::string> words_of(const std::string& row) {
  static const std::regex word(R"re([-+\w.]+)re");
  std::vector<std::string> words;
  for (std::sregex_iterator at(row.begin(), row.end(), word), end; at != end; ++at) {
    words.push_back(at->str());
  }
  return words;
}

/// The words of a table between a line and the next one that begins with an end.
std::vector<std::string> table_of(const std::string& text, const std::string& head,
                                  const std::string& end) {
  const std::size_t begin = text.find(head);
  if (begin == std::string::npos) throw std::logic_error(head + " is missing");
  const std::size_t from = begin + head.size();
  return words_of(text.substr(from, text.find("\n" + end, from) - from));
}

/// Reads numbers one after the other.
class Reader {
 public:
  explicit Reader(std::vector<std::string> words) : words_(std::move(words)) {}
  bool more() const { return at_ < words_.size(); }
  const std::string& word() { return words_.at(at_++); }
  double number() {
    const std::string& text = word();
    if (text == "true" || text == "false") return text == "true" ? 1.0 : 0.0;
    return std::strtod(text.c_str(), nullptr);
  }
  std::array<double, 3> triple() {
    const double x = number();
    const double y = number();
    return {x, y, number()};
  }
  void skip(int count) { at_ += static_cast<std::size_t>(count); }

 private:
  std::vector<std::string> words_;
  std::size_t at_ = 0;
};

ParsedBeam parse_tables(std::vector<std::string> segments, std::vector<std::string> joints,
                        bool two_frames) {
  ParsedBeam beam;
  for (Reader row(std::move(segments)); row.more();) {
    ParsedSegment segment;
    segment.length = row.number();
    segment.mass = row.number();
    segment.inertia = row.triple();
    segment.center = row.triple();
    row.skip(4);
    beam.segments.push_back(segment);
  }
  for (Reader row(std::move(joints)); row.more();) {
    ParsedJoint& joint = beam.joints[row.word()];
    row.skip(1);
    const auto child = static_cast<std::size_t>(row.number());
    joint.half_joint = row.number() == 1.0;
    if (two_frames) row.skip(7);
    joint.point = row.triple();
    row.skip(4);
    // The frame in the child, whose axes are the world's in these tests.
    for (std::size_t k = 0; two_frames && k < 3; ++k) {
      joint.point[k] += beam.segments.at(child).center[k];
    }
    for (bool& holds : joint.holds) holds = row.number() == 1.0;
    row.skip(3);
    joint.length = row.number();
    joint.stiffness = row.triple();
    joint.hardened_stiffness = row.triple();
    joint.yield_moment = row.triple();
    joint.break_angle = row.triple();
    if (!two_frames) joint.damping = row.triple();
  }
  return beam;
}

}  // namespace

ParsedBeam parse_csv(const std::string& text) {
  ParsedBeam beam;
  std::map<std::string, std::size_t> column;
  for (const std::string& line : split(text, '\n')) {
    if (line.starts_with("#")) continue;
    auto cells = split(line, ',');
    if (column.empty()) {
      for (std::size_t i = 0; i < cells.size(); ++i) column[cells[i]] = i;
      continue;
    }
    cells.resize(column.size());
    const auto cell = [&](const std::string& name) { return cells.at(column.at(name)); };
    const auto numbers = [&](const std::string& name, const std::string& unit) {
      std::array<double, 3> values{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string value = cell(name + " " + "xyz"[k] + " [" + unit + "]");
        values[k] = value.empty() ? kInfinity : std::stod(value);
      }
      return values;
    };
    ParsedJoint& joint = beam.joints[cell("joint")];
    joint.point[2] = std::stod(cell("at [m]"));
    joint.half_joint = cell("half joint") == "1";
    joint.length = std::stod(cell("tributary length [m]"));
    for (std::size_t k = 0; k < 3; ++k) {
      joint.holds[k] = cell("hold").find("xyz"[k]) != std::string::npos;
    }
    joint.stiffness = numbers("stiffness", "N m/rad");
    joint.hardened_stiffness = numbers("hardened stiffness", "N m/rad");
    joint.yield_moment = numbers("yield moment", "N m");
    joint.break_angle = numbers("break angle", "rad");
  }
  return beam;
}

ParsedBeam parse_mjcf(const std::string& text) {
  ParsedBeam beam;
  static const std::regex element(R"re(<(\w+) [^>]*>)re");
  for (std::sregex_iterator at(text.begin(), text.end(), element), end; at != end; ++at) {
    auto has = attributes(at->str());
    const std::string kind = (*at)[1];
    std::string name = has["name"];
    if (kind == "joint" && has["type"] == "hinge") {
      const std::size_t axis = take_axis(name);
      beam.joints[name].stiffness[axis] = std::stod(has["stiffness"]);
    } else if (kind == "inertial") {
      beam.segments.push_back(
          {0.0, std::stod(has["mass"]), triple(has["diaginertia"]), triple(has["pos"])});
    } else if (kind == "numeric") {
      const double value = std::stod(has["data"]);
      std::string joint;
      if (ends_with(name, "_tributary_length", joint)) beam.joints[joint].length = value;
      if (ends_with(name, "_yield_moment", joint)) {
        const std::size_t axis = take_axis(joint);
        beam.joints[joint].yield_moment[axis] = value;
      }
      if (ends_with(name, "_hardened_stiffness", joint)) {
        const std::size_t axis = take_axis(joint);
        beam.joints[joint].hardened_stiffness[axis] = value;
      }
      if (ends_with(name, "_break_angle", joint)) {
        const std::size_t axis = take_axis(joint);
        beam.joints[joint].break_angle[axis] = value;
      }
    }
  }
  return beam;
}

ParsedBeam parse_agx(const std::string& text) {
  return parse_tables(table_of(text, "\nSEGMENTS = [", "]"), table_of(text, "\nJOINTS = [", "]"),
                      true);
}

ParsedBeam parse_chrono(const std::string& text) {
  return parse_tables(table_of(text, "kSegments[] = {", "}"), table_of(text, "kJoints[] = {", "}"),
                      false);
}

ParsedBeam parse_opensees(const std::string& text) {
  struct Law {
    double stiffness = 0.0;
    double hardened = 0.0;
    double moment = kInfinity;
    double permanent = kInfinity;
  };
  ParsedBeam beam;
  std::map<std::string, Law> laws;
  std::string joint;
  static const std::regex head(R"re(# ((?:joint|support)_\w+)(.*))re");
  for (const std::string& line : split(text, '\n')) {
    std::smatch match;
    if (std::regex_match(line, match, head)) {
      joint = match[1];
      beam.joints[joint].half_joint = match[2] != "";
      continue;
    }
    const auto words = split(line, ' ');
    if (words.empty()) continue;
    const auto number = [&](std::size_t i) { return std::stod(words.at(i)); };
    if (words[0] == "uniaxialMaterial") {
      Law law;
      if (words[1] == "Elastic") law.stiffness = number(3);
      if (words[1] == "ElasticPP") law = {number(3), 0.0, number(3) * number(4)};
      if (words[1] == "Steel01") law = {number(4), number(4) * number(5), number(3)};
      if (words[1] == "MinMax") {
        law = laws.at(words.at(3));
        if (number(5) != -number(7)) throw std::logic_error(line);
        // angle = permanent + (moment + H permanent)/k
        const double slope = law.stiffness * law.hardened / (law.stiffness - law.hardened);
        law.permanent = (number(7) - law.moment / law.stiffness) / (1.0 + slope / law.stiffness);
      }
      laws[words.at(2)] = law;
    }
    if (words[0] == "element" && words[1] == "zeroLength") {
      std::size_t mat = 6;
      std::size_t dir = mat;
      while (words.at(dir) != "-dir") ++dir;
      for (std::size_t k = 0; mat + k < dir; ++k) {
        const auto axis = static_cast<std::size_t>(number(dir + 1 + k)) - 4;
        const Law& law = laws.at(words.at(mat + k));
        beam.joints[joint].stiffness.at(axis) = law.stiffness;
        beam.joints[joint].hardened_stiffness.at(axis) = law.hardened;
        beam.joints[joint].yield_moment.at(axis) = law.moment;
        beam.joints[joint].break_angle.at(axis) = law.permanent;
      }
    }
  }
  return beam;
}

}  // namespace plastica::testing
