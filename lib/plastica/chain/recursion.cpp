#include "plastica/chain/recursion.hpp"

namespace plastica::chain {

template class Recursion<Spatial<double>, false>;
template class Recursion<Spatial<double>, true>;
template class Recursion<Spatial<float>, false>;

}  // namespace plastica::chain
