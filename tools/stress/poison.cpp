// SPDX-License-Identifier: MIT
#include "stress/poison.hpp"

#include "stress/poison_parts.hpp"

namespace gloam::stress {

Rows poison(const Context& context) {
    Rows rows = poisoned_passes(context);
    for (const auto& part : {poisoned_gathers, poisoned_filters, poisoned_history}) {
        append(rows, part(context));
    }
    return rows;
}

}  // namespace gloam::stress
