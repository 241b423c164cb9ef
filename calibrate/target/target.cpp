#include "calibrate/target/target.hpp"
