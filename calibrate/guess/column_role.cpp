#include "calibrate/guess/column_role.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "plastica/io/units.hpp"

namespace plastica::calibrate {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::array<std::string_view, 10> kStrain{
    "应变", "strain",      "dehnung",     "stauchung",   "epsilon",
    "ε",    "deformación", "deformation", "déformation", "deformazione"};
constexpr std::array<std::string_view, 8> kStrainWhole{"e",    "eps",   "epsx", "epsy",
                                                       "epsz", "epsyy", "dms",  "ave"};
constexpr std::array<std::string_view, 10> kStress{"应力",     "stress",     "spannung", "sigma",
                                                   "σ",        "contrainte", "esfuerzo", "tensión",
                                                   "tensione", "sforzo"};
constexpr std::array<std::string_view, 2> kStressWhole{"s", "sig"};
constexpr std::array<std::string_view, 14> kElongation{
    "变形",           "elongation",   "extensom",     "verlängerung", "verlaengerung",
    "längenänderung", "feinweg",      "ansetz",       "allongement",  "lvdt",
    "clip",           "allungamento", "alargamiento", "delta l"};
constexpr std::array<std::string_view, 3> kElongationWhole{"dl", "δl", "d_l"};
constexpr std::array<std::string_view, 18> kTravel{
    "位移",        "travel",   "stroke",   "crosshead",      "displacement", "displ",
    "standardweg", "weg",      "course",   "déplacement",    "deplacement",  "traverse",
    "extension",   "position", "actuator", "desplazamiento", "spostamento",  "corsa"};
constexpr std::array<std::string_view, 2> kTravelWhole{"hub", "disp"};
constexpr std::array<std::string_view, 8> kForce{"载荷",  "力",     "force", "load",
                                                 "kraft", "fuerza", "forza", "effort"};
constexpr std::array<std::string_view, 5> kForceWhole{"f", "p", "last", "charge", "carga"};
constexpr std::array<std::string_view, 7> kTime{"时间",   "time",  "zeit", "temps",
                                                "tiempo", "tempo", "dauer"};
constexpr std::array<std::string_view, 1> kTimeWhole{"t"};
constexpr std::array<std::string_view, 17> kGeometry{
    "width",        "breite",      "largeur",         "thickness", "dicke",    "épaisseur",
    "diamet",       "durchmess",   "diamèt",          "area",      "section",  "querschnitt",
    "gauge length", "gage length", "original length", "final",     "messlänge"};
constexpr std::array<std::string_view, 7> kTrue{"true",   "wahre",    "vraie", "logarithm",
                                                "hencky", "verdader", "真"};
constexpr std::array<std::string_view, 4> kTrueWhole{"log", "ln", "wahr", "vera"};
constexpr std::array<std::string_view, 7> kEngineering{
    "engineering", "nominal", "technisch", "ingenier", "ingénieur", "ingegner", "工程"};
constexpr std::array<std::string_view, 1> kEngineeringWhole{"eng"};
/// What makes another quantity of it.
constexpr std::array<std::string_view, 27> kNot{
    "rate",      "geschwindigkeit", "speed",     "vitesse",  "velocity",   "modul",
    "young",     "energ",           "lateral",   "poisson",  "transv",     "trans.",
    "querdehn",  "width strain",    "radial",    "circumf",  "hoop",       "volum",
    "corr coef", "count",           "torque",    "fraction", "temperatur", "températur",
    "work",      "residual",        "drehmoment"};
/// Of torsion, and of bending; "elastischer" and "Vorschub" are of neither.
constexpr std::array<std::string_view, 12> kShear{
    "shear",        "scherspann", "scherdehn", "scherung", "schubspann", "schubverz",
    "cisaillement", "taglio",     "cortante",  "torsion",  "gleitung",   "剪"};
constexpr std::array<std::string_view, 8> kFlexural{"flexur",  "flexion", "biegespann", "biegedehn",
                                                    "bending", "biegung", "flessione",  "弯曲"};
/// What is wanted of the machine, taken out of the curve, or part of it.
constexpr std::array<std::string_view, 16> kLesser{
    "set ",  "setpoint", "soll",      "command",    "target",  "demand",  "peak",      "max",
    "error", "std",      "deviation", "abweichung", "plastic", "elastic", "plastisch", "elastisch"};

/// What makes a strain one without its elastic part, beside its word: "true plastic strain", not
/// "plastic specimen strain".
constexpr std::array<std::string_view, 10> kPlastic{
    "plastic",  "plastische", "plastischer", "plastique", "plástica",
    "plastica", "permanent",  "permanente",  "bleibende", "inelastic"};
/// Words that may stand between them.
constexpr std::array<std::string_view, 9> kBetween{"true",  "eng",        "engineering",
                                                   "log",   "equivalent", "logarithmic",
                                                   "wahre", "nominal",    "accumulated"};
/// Words that make it the whole strain.
constexpr std::array<std::string_view, 4> kTotal{"total", "elastic", "elastisch", "gesamt"};

bool has(std::string_view name, Words words) {
  return std::ranges::any_of(words,
                             [&](auto word) { return name.find(word) != std::string_view::npos; });
}

/// Whether one of the words stands by itself in a name: "log" in "log strain", not in "analog".
bool has_word(std::string_view name, Words words) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  return std::ranges::any_of(words, [&](std::string_view word) {
    for (std::size_t at = name.find(word); at != std::string_view::npos;
         at = name.find(word, at + 1)) {
      const std::size_t end = at + word.size();
      const bool begins = at == 0 || !is_letter(name[at - 1]);
      if (begins && (end == name.size() || !is_letter(name[end]))) return true;
    }
    return false;
  });
}

/// Whether a name is one of short words, but for what says how it is measured.
bool is(std::string_view name, Words words) {
  std::string bare(name);
  for (const std::string_view part : {"engineering", "true", "eng", "_", " ", "."}) {
    for (std::size_t at = bare.find(part); at != std::string::npos; at = bare.find(part)) {
      bare.erase(at, part.size());
    }
  }
  while (!bare.empty() && std::isdigit(static_cast<unsigned char>(bare.back())) != 0) {
    bare.pop_back();
  }
  return std::ranges::find(words, std::string_view(bare)) != words.end();
}

bool fits(std::string_view unit, Dimension dimension) {
  try {
    io::unit_conversion(unit, dimension);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// Whether it is the plastic strain alone.
bool is_plastic_strain(const std::string& name) {
  std::vector<std::string_view> words;
  const auto is_letter = [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code >= 0x80 || std::isalpha(code) != 0;
  };
  for (std::size_t begin = 0; begin < name.size();) {
    std::size_t end = begin;
    while (end < name.size() && is_letter(name[end])) ++end;
    if (end > begin) words.push_back(std::string_view(name).substr(begin, end - begin));
    begin = end + 1;
  }
  const auto is_one_of = [](std::string_view word, Words known) {
    return std::ranges::find(known, word) != known.end();
  };
  std::erase_if(words, [&](std::string_view word) { return is_one_of(word, kBetween); });
  const auto is_total = [&](std::string_view word) { return is_one_of(word, kTotal); };
  if (std::ranges::any_of(words, is_total)) return false;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (is_one_of(words[i - 1], kPlastic) && has(words[i], kStrain)) return true;
    if (is_one_of(words[i], kPlastic) && has(words[i - 1], kStrain)) return true;
  }
  return false;
}

/// The unit that ends a name: "Stress_MPa", "elongation_mm"; empty if that is none.
std::string unit_in_name(std::string_view name) {
  const std::size_t cut = name.find_last_of("_ ");
  if (cut == std::string_view::npos) return {};
  std::string unit(name.substr(cut + 1));
  // A factor: "Stress 10 MPa", "Stress x10 MPa". A single digit numbers things: "Stress 2 MPa".
  const std::string_view before = name.substr(0, cut);
  const std::string_view last = before.substr(before.find_last_of("_ ") + 1);
  if (io::is_scaled_unit(std::string(last) + ' ' + unit)) return {};
  if (unit == "percent" || unit == "pct") return "%";
  if (unit == "strain" || unit == "microstrain") return {};  // a name, more likely
  const bool is_number = !unit.empty() && std::isdigit(static_cast<unsigned char>(unit[0])) != 0;
  // "m", "s" and "1" end names that mean no unit.
  return unit.size() > 1 && !is_number && io::is_unit(unit) ? unit : std::string();
}

/// What the words say.
struct Said {
  bool strain, stress, elongation, travel, force, time, geometry;
};

Said said_by(const std::string& name) {
  return {has(name, kStrain) || is(name, kStrainWhole),
          has(name, kStress) || is(name, kStressWhole),
          has(name, kElongation) || is(name, kElongationWhole),
          has(name, kTravel) || is(name, kTravelWhole),
          has(name, kForce) || is(name, kForceWhole),
          has(name, kTime) || is(name, kTimeWhole),
          has(name, kGeometry)};
}

ColumnRole role_by_name(const Said& said) {
  using enum ColumnRole;
  if (said.geometry && !said.strain && !said.stress) return Geometry;
  if (said.stress) return Stress;
  if (said.strain) return Strain;
  if (said.elongation) return Elongation;
  if (said.travel) return Travel;
  if (said.force) return Force;
  return said.time ? Time : Other;
}

/// Where the unit tells strain from elongation, stress from force; Other where it fits none.
ColumnRole role_by_unit(const Said& said, std::string_view unit) {
  using enum ColumnRole;
  if (fits(unit, Dimension::Stress)) return Stress;
  if (fits(unit, Dimension::Force)) return Force;
  if (fits(unit, Dimension::Time)) return Time;
  if (fits(unit, Dimension::Area)) return Geometry;
  if (fits(unit, Dimension::Length)) {
    if (said.geometry) return Geometry;
    if (said.elongation || said.strain) return Elongation;
    return said.travel ? Travel : Other;
  }
  const bool deforms = said.strain || said.elongation || said.travel;
  const bool is_fraction = unit == "%" || (unit != "-" && unit != "1");
  return fits(unit, Dimension::Strain) && (deforms || is_fraction) && !said.geometry ? Strain
                                                                                     : Other;
}

}  // namespace

std::string_view words_of(ColumnRole role) {
  constexpr std::array<std::string_view, 8> kWords{
      "-", "time", "strain", "elongation", "crosshead travel", "stress", "force", "geometry"};
  return kWords[static_cast<std::size_t>(role)];
}

std::string lower_name(std::string_view name) {
  std::string lower(name);
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const auto code = static_cast<unsigned char>(lower[i]);
    if (code < 0x80) {
      lower[i] = static_cast<char>(std::tolower(code));
    } else if (code == 0xC3 && i + 1 < lower.size()) {
      // À to Þ are 32 below à to þ.
      const auto next = static_cast<unsigned char>(lower[i + 1]);
      if (next >= 0x80 && next <= 0x9E && next != 0x97) lower[i + 1] = static_cast<char>(next + 32);
      ++i;
    }
  }
  return lower;
}

ColumnMeaning meaning_of(std::string_view name, std::string_view unit) {
  ColumnMeaning meaning;
  const std::string lower = lower_name(name);
  if (io::is_unit(unit) || unit == "-") meaning.unit = std::string(unit);
  const bool is_clock = meaning.unit && fits(*meaning.unit, Dimension::Time);
  if (has(lower, kNot) && !is_clock) return meaning;
  const Said said = said_by(lower);
  const ColumnRole by_name = role_by_name(said);
  meaning.role = meaning.unit ? role_by_unit(said, *meaning.unit) : by_name;
  if (const std::string own = unit_in_name(name); unit.empty() && !own.empty()) {
    const ColumnRole role = role_by_unit(said, own);
    if (role != ColumnRole::Other) {
      meaning.role = role;
      meaning.unit = own;
    }
  }
  if (meaning.role == ColumnRole::Other) return meaning;
  meaning.is_true = has(lower, kTrue) || has_word(lower, kTrueWhole);
  meaning.is_engineering = has(lower, kEngineering) || has_word(lower, kEngineeringWhole);
  meaning.is_lesser = has(lower + " ", kLesser);
  meaning.is_weak = by_name == ColumnRole::Other;
  meaning.is_travel =
      meaning.role == ColumnRole::Travel ||
      (meaning.role == ColumnRole::Strain &&
       (said.travel || lower.find("nominal") != std::string::npos) && !said.elongation);
  meaning.is_plastic = meaning.role == ColumnRole::Strain && is_plastic_strain(lower);
  if (meaning.role == ColumnRole::Strain || meaning.role == ColumnRole::Stress) {
    if (has(lower, kShear)) meaning.test = Deformation::Torsion;
    if (has(lower, kFlexural)) meaning.test = Deformation::Bending;
  }
  meaning.why = meaning.is_weak ? "unit" : meaning.unit ? "name, unit" : "name";
  return meaning;
}

}  // namespace plastica::calibrate
