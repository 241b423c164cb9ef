#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/base/status.hpp"
#include "plastica/solve/path_result.hpp"

namespace plastica {

/// A joint went over its break limit.
struct BreakEvent {
  std::size_t sample = 0;         ///< first sample of the drive at which the limit is exceeded
  double strain = 0.0;            ///< total strain at which it was reached, between two samples [1]
  double stress = 0.0;            ///< that the beam carried there [Pa]
  double permanent_strain = 0.0;  ///< the limit that was reached, in the break measure [1]
  double dissipation = 0.0;       ///< plastic work per volume up to there [J/m^3]
};

/// Why a joint of a chain broke: the strain that went over its limit.
/// `Cut`: the scene cut it.
enum class BreakCause { BendingX, BendingY, Biaxial, Torsion, Stretch, Cut };

/// The words of files for the causes, in their order.
inline constexpr std::array<std::string_view, 6> kBreakCauses{"bending_x", "bending_y", "biaxial",
                                                              "torsion",   "stretch",   "cut"};

/// One joint over its limit, or one that was cut.
struct BrokenJoint {
  int joint = 0;  ///< 0 … n_joints - 1
  BreakCause cause = BreakCause::BendingX;
  bool cut = false;                ///< whether it was cut then
  double strain = 0.0;             ///< the permanent strain [1]
  double limit = 0.0;              ///< that it exceeded [1]
  std::array<double, 3> moment{};  ///< about x, y, z of the joint [N m]
  std::array<double, 3> angle{};   ///< permanent [rad]
  double dissipation = 0.0;        ///< plastic work of the joint so far [J]
};

/// A fragment of a beam: a range of its segments. Segments and joints keep their numbers for life.
struct Fragment {
  int first = 0;  ///< segment
  int last = 0;   ///< segment, the last one included

  friend bool operator==(const Fragment&, const Fragment&) = default;
};

/// All joints that went over their limits, or were cut, at one time; statics end there. One that
/// was spared for the hinge beside it may do so again.
struct ChainBreak {
  double time = 0.0;    ///< [s]
  double factor = 0.0;  ///< as `ChainHistory::factor` there [1]
  std::vector<BrokenJoint> joints{};
  std::vector<Fragment> fragments{};  ///< of the beam after it, by rising segment
};

/// Decides at each break which of its joints are cut: it sets `BrokenJoint::cut`, which the scene's
/// policy has set before; other joints than those that it is told of are refused
/// (std::invalid_argument). Called in the thread that runs.
using BreakListener = std::function<void(ChainBreak&)>;

/// How far the energies of a path or motion balance [J]; see chain/README.md. All but the residual
/// are computed each on its own.
struct Energies {
  double elastic = 0.0;  ///< stored in the joints and in springs
  double kinetic = 0.0;
  double plastic = 0.0;                ///< plastic work done so far
  double damping = 0.0;                ///< dissipated by the joints' damping so far
  double numerical_dissipation = 0.0;  ///< dissipated by the scheme so far; negative: made by it
  double impact = 0.0;                 ///< lost in impacts so far
  double fracture = 0.0;               ///< elastic energy of joints that were cut, so far
  double external = 0.0;  ///< work of loads and moving supports so far, and the energy at time 0
  double residual = 0.0;  ///< external less all others: what the balance cannot explain
};

/// Error of the energy balance, over the largest of its entries but the residual [1]: the largest
/// |residual|, or what the scheme has made if that is more (none should make any).
/// @param rounding  energy that is nothing but rounding [J], >= 0: the error is over that at least
double energy_balance_error(std::span<const Energies> samples, double rounding = 0.0);

/// A motion whose energy or momentum is off by more than this fraction is not to be trusted.
inline constexpr double kBalanceTolerance = 0.01;

/// What a chain records at each sample. Joint 0 is at the start, joint N at the end: a joint of a
/// beam of N segments lies at each segment end; one that does not exist (a free end) has zeros.
struct ChainHistory {
  std::size_t joints = 0;  ///< N + 1
  std::size_t supports = 0;
  std::vector<double> time;      ///< [s] (n_samples)
  std::vector<double> factor;    ///< of the first load or motion that changes [1] (n_samples)
  std::vector<Energies> energy;  ///< (n_samples)
  std::vector<int> iterations;   ///< Newton iterations of all steps up to here (n_samples)
  /// Samples of which the shape is kept: frames, the first and the last among them; those beyond
  /// the last sample of a run that has ended early are empty (n_frames).
  std::vector<std::size_t> frame_sample;
  /// By frame, joint and axis (n_frames x n_joints x 3):
  std::vector<double> position;       ///< of the joint in world axes [m]
  std::vector<double> moment;         ///< about x, y, z of the joint [N m]
  std::vector<double> force;          ///< shear along x, y, axial along z [N]
  std::vector<double> angle;          ///< from the undeformed state [rad]
  std::vector<double> plastic_angle;  ///< [rad]
  /// By frame and segment (n_frames x N x 3): its rotation from the undeformed beam, as a
  /// rotation vector in world axes [rad].
  std::vector<double> rotation;
  /// Of a motion, by frame and segment (n_frames x N x 3), in world axes; empty for a path at rest:
  std::vector<double> velocity;  ///< of the point that `position` has: the inner end [m/s]
  std::vector<double> spin;      ///< angular velocity [rad/s]
  /// By frame and joint (n_frames x n_joints):
  std::vector<double> plastic_strain;  ///< the break measure: the largest of the joint's axes [1]
  /// Largest of bending over the section [Pa], >= 0: |M_x|/W_x + |M_y|/W_y, that of a corner; of a
  /// round section the root of the sum of their squares. Axial force and torque are not in it.
  std::vector<double> stress;
  /// By frame and support (n_frames x n_supports x 6): force [N] and moment [N m] on the beam.
  std::vector<double> reaction;
  std::vector<ChainBreak> events{};  ///< in the order of time
};

/// The largest axial force of a joint while it yielded.
struct AxialNote {
  double ratio = 0.0;     ///< |N| over N_p, at which all of the section yields [1]
  double fraction = 0.0;  ///< where, of the beam's length [1]
  double left = 1.0;      ///< moment that the section carries beside it, over that without [1]
  double thrust = 0.0;    ///< the largest compression of a joint that yields, where hardening takes
                          ///< it over N_p and one surface stands for the section; else 0 [1]
  /// What fraction of its hinge's elongation is missing in the chain, where joints stretch and its
  /// neighbour does not yield, too: 1 at a clamped end, 1/2 at a rigid support within the beam; 0:
  /// nothing, or nothing of it is looked for [1].
  double missing_elongation = 0.0;
};

/// What a run gives; sized by `make_response`, so that `run` does not allocate.
struct Response {
  Status status = Status::NotRun;
  /// Values of each probe at each sample (n_probes x n_samples), in the order of the scene.
  std::vector<std::vector<double>> probes;
  std::size_t samples = 0;  ///< samples that are valid; all of them if the status is usable
  /// Break measure at the last sample, or at the break of a beam that was cut there [1].
  double permanent_strain = 0.0;
  std::optional<BreakEvent> event;
  ChainHistory chain;  ///< of a chain; empty for a coupon
  PathCounters counters;
  std::optional<LimitLoad> limit;
  /// Of a path in statics that went on beyond; `peak_warnings` puts it in words.
  std::optional<Plateau> plateau;
  /// Of a path in statics; none where it came by no bifurcation.
  std::optional<CriticalPoints> critical;
  /// Of a path in statics, where `solver.buckling` and `solver.frequencies` ask for them.
  std::optional<BucklingModes> buckling;
  std::optional<VibrationModes> vibration;
  /// Set where joints yield, or would, that do not see the axial force (on each axis by itself; in
  /// motion, those that do not stretch), where it is beyond N_p in joints that do not stretch,
  /// where joints stretch but for this one, and where hardening joints yield in compression;
  /// `axial_warning` puts it in words.
  std::optional<AxialNote> axial;
  /// Of a path at a planar level: some joint is under thrust, while no support keeps the beam from
  /// leaving its plane, so that nothing tells whether it does.
  bool unheld_thrust = false;
  /// `plastica::energy_balance_error` [1]; of a motion above `kBalanceTolerance` its status is
  /// `NotBalanced`. At rest it falls with the square of the step.
  double energy_balance_error = 0.0;
  /// Of a motion: what the momentum of fragments that no support holds has changed by beyond the
  /// impulses of their loads, at most, over the largest sum of the segments' momenta so far; the
  /// same of the angular momentum about their mass centres (see chain/README.md) [1]. Above
  /// `kBalanceTolerance` the status is `NotBalanced`.
  double momentum_error = 0.0;
  /// The shortest and the longest step that a motion has taken [s]; 0: none.
  double shortest_step = 0.0, longest_step = 0.0;

  bool balances() const {
    return energy_balance_error <= kBalanceTolerance && momentum_error <= kBalanceTolerance;
  }
  /// Wall time of the run; of a batch's case CPU time of its thread. What ran in lanes has its
  /// fraction, by iterations and samples, of the time of all that ran beside it [s].
  double seconds = 0.0;
};

/// Sets `Response::energy_balance_error` of a chain. Where loads go straight into supports, and
/// nothing moves, all energies are rounding.
/// @param length  of the beam [m]
void set_energy_balance(double length, Response& response);

/// Before a run: nothing is known; what is sized stays so.
void clear_run(Response& response);
/// Before a run: nothing is known of its motion.
void clear_motion(Response& response);
/// Notes the length of a step that a motion has taken [s].
void note_step(double step, Response& response);
/// After a motion: the status of one that ended as it should, but does not balance.
void judge_balance(Response& response);

/// Derivatives of a response by the model's parameters; sized by `make_sensitivity`.
struct Sensitivity {
  std::vector<double> stress;            ///< d stress / d parameter (n_samples x n_parameters)
  std::vector<double> permanent_strain;  ///< d permanent_strain / d parameter (n_parameters)
};

}  // namespace plastica
