// SPDX-License-Identifier: MIT
#include "stress/poison.hpp"

#include "stress/poison_parts.hpp"

namespace gloam::stress {

Rows poison(const Context& context) {
    Rows rows = poisoned_passes(context);
    for (const auto& part : {poisoned_fetches, poisoned_history}) {
        const Rows more = part(context);
        rows.insert(rows.end(), more.begin(), more.end());
    }
    return rows;
}

}  // namespace gloam::stress
