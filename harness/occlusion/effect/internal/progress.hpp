// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include "effect/internal/passes.hpp"
#include "effect/methods.hpp"

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

// Which samples the table of what all pixels share holds, and which the next frame needs. The table stays
// valid as long as the method uses the same points.
class Tabulated {
  public:
    // Takes the settings of the next frames.
    void take(const Settings& settings) {
        most_ = std::max(settings.samples, settings.samples_converged);
        table_size_ = settings.table_size;
        used_ = tabulates_samples(settings);
        if (!used_) return;
        const std::string& points = method_named(settings.method).points;
        const gpu::Extent extent = sample_table_extent(settings);
        if (points != points_ || extent != extent_) filled_ = 0;
        points_ = points;
        extent_ = extent;
    }

    // No pixel has taken a sample yet.
    void restart() { taken_ = 0; }

    // The samples that the next frame may read and the table lacks.
    [[nodiscard]] SampleTableParameters missing() const {
        return used_ ? SampleTableParameters{filled_ + 1, std::max(filled_, last_needed())}
                     : SampleTableParameters{1, 0};
    }

    // Call it after each frame: its samples have been taken and are in the table.
    void advance() {
        if (used_) filled_ = std::max(filled_, last_needed());
        taken_ = std::min(taken_ + most_, table_size_);
    }

  private:
    [[nodiscard]] std::uint32_t last_needed() const { return std::min(taken_, table_size_ - 1) + most_; }

    bool used_ = false;
    std::string points_;
    gpu::Extent extent_;
    std::uint32_t most_ = 0;        // samples of a frame
    std::uint32_t table_size_ = 0;  // samples after which the sequence starts over
    std::uint32_t taken_ = 0;       // by any pixel, largest number
    std::uint32_t filled_ = 0;      // samples in the table
};

}  // namespace gloam::effect
