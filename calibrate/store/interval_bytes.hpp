#pragma once

#include "calibrate/inference/intervals.hpp"
#include "calibrate/store/coders.hpp"

/// How intervals become bytes and come back; not installed.
namespace plastica::calibrate::store {

void code_bootstrap(auto& coder, A<BootstrapResult> auto& b) {
  coder(b.resamples, b.failed, b.block, b.values);
  coder.each(b.intervals, [](auto& to, auto& i) { to(i.standard_error, i.low, i.high); });
}

void code_intervals(auto& coder, A<FitIntervals> auto& all) {
  coder.each(all.profiles, [](auto& to, auto& p) {
    to(p.low, p.high, p.low_end, p.high_end, p.threshold, p.value, p.rise, p.searched);
  });
  code_bootstrap(coder, all.residuals);
  code_bootstrap(coder, all.specimens);
}

}  // namespace plastica::calibrate::store
