// SPDX-License-Identifier: MIT
#include "interpreter/internal/machine_of.hpp"

template class gloam::interpreter::Machine<gloam::numeric::Rearranged>;
