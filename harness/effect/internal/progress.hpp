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
    void count_frame() {
        ++frames_;
        ++frames_since_cut_;
    }

    [[nodiscard]] bool has_view() const { return came_ != Came::not_yet; }
    // Whether the next frame is the first of the view.
    [[nodiscard]] bool first_of_view() const { return frames_ == 0; }
    // Whether the history belongs to the view before the last.
    [[nodiscard]] bool history_lags() const { return came_ == Came::next && first_of_view(); }
    // Whether two frames of the view have run: both images of the history show it.
    [[nodiscard]] bool settled() const { return frames_ >= 2; }

    // Frames since the history began.
    [[nodiscard]] std::uint64_t frames_since_cut() const { return frames_since_cut_; }

    Progress() = default;

  private:
    enum class Came { not_yet, first, next };
    explicit Progress(Came came) : came_(came) {}

    Came came_ = Came::not_yet;
    std::uint64_t frames_ = 0;  // of the view
    std::uint64_t frames_since_cut_ = 0;
};

}  // namespace gloam::effect
