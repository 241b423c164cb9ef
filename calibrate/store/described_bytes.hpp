#pragma once

#include <string_view>
#include <type_traits>
#include <utility>

#include "calibrate/result/describe.hpp"
#include "calibrate/result/fitted_parameter.hpp"
#include "calibrate/store/coders.hpp"
#include "plastica/base/renamed.hpp"

/// Described records (result/describe.hpp) in journals; not installed.
namespace plastica::calibrate::store {

/// Puts, or gets, what a description says of a record.
template <typename Coder, typename Row>
class DescribedCoder {
 public:
  DescribedCoder(Coder& coder, Row& row) : coder_(coder), row_(row) {}

  template <typename Member>
  void operator()(std::string_view, std::string_view, const Member& member, std::string_view = {}) {
    coder_(member(row_));
  }
  template <typename Function>
  void derived(std::string_view, std::string_view, const Function&, std::string_view = {}) {}
  template <typename Columns>
  void since(int, const Columns& columns) {
    columns(*this);
  }
  template <typename Member, typename Columns>
  void optional(std::string_view, const Member& member, const Columns& columns) {
    coder_.maybe(member(row_), [&](auto& to, auto& each) {
      DescribedCoder<std::remove_reference_t<decltype(to)>, std::remove_reference_t<decltype(each)>>
          of_inner(to, each);
      columns(of_inner);
    });
  }

 private:
  Coder& coder_;
  Row& row_;
};

void code_described(auto& coder, auto& row, const auto& description) {
  DescribedCoder described(coder, row);
  description(described);
}

void code_parameter(auto& coder, A<FittedParameter> auto& p) {
  coder(p.path, p.dimension, p.role);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(p)>>) {
    p.path = new_path(p.path);
  }
  code_described(coder, p, kDescribeParameter);
}

}  // namespace plastica::calibrate::store
