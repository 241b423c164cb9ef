#pragma once

namespace plastica {

/// Which formulas set up a joint: the report's to the letter, or the right ones (design 2.4).
enum class Formulas { Mechanics, Report };

/// The largest moment of an ideal joint: at first yield of the extreme fibre (the report), or with
/// the whole section yielding.
enum class YieldCap { FirstYield, FullyPlastic };

/// What of the permanent strain is held against the break limit: its present size (the report),
/// or the sum of all of it, so that bending to and fro wears out.
enum class BreakMeasure { Net, Accumulated };

/// What happens to a joint over its limit: it is cut (from then on it carries nothing and keeps
/// the permanent strain that it broke with), or the break is only recorded.
enum class BreakPolicy { CutAll, RecordOnly };

/// How much of the beam is modelled. Coupon: a uniform state, one joint stands for all.
enum class Level { Auto, Coupon };

}  // namespace plastica
