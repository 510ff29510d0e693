// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace gloam::effect {

// What the frames so far have left: how the last view came, and how many frames of it have run. What the next
// frame has to do follows from it.
class Progress {
  public:
    // A view without a history.
    void begin() { *this = Progress(Came::first); }
    // A view to which the history is reprojected.
    void advance() {
        came_ = Came::next;
        frames_ = 0;
    }
    // A frame of the view has run.
    void count_frame() { ++frames_; }

    [[nodiscard]] bool has_view() const { return came_ != Came::not_yet; }
    // Whether the next frame is the first of the view.
    [[nodiscard]] bool first_of_view() const { return frames_ == 0; }
    // Whether the history belongs to the view before the last.
    [[nodiscard]] bool history_lags() const { return came_ == Came::next && first_of_view(); }

    Progress() = default;

  private:
    enum class Came { not_yet, first, next };
    explicit Progress(Came came) : came_(came) {}

    Came came_ = Came::not_yet;
    std::uint64_t frames_ = 0;  // of the view
};

}  // namespace gloam::effect
