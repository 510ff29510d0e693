// SPDX-License-Identifier: MIT
#pragma once
// What compare.py asks of a program: the red of each shot with each pass, and the least time of a frame.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

struct Shot {
    double width, height, eye[3], target[3], step[3];  // step: of the eye, from frame to frame
    double fovy, tall;  // degrees; the height of an orthographic view, 0 in perspective
};

// From one file into the other. look(pass, shot) begins a shot; frame(shot) draws it, and returns the red.
template <class Look, class Frame>
void each_shot(char** files, const std::vector<std::string>& passes, const Look& look, const Frame& frame) {
    std::ofstream result(files[1], std::ios::binary);
    for (std::size_t pass = 0; pass < passes.size(); ++pass) {
        result << passes[pass] << "\n";
        std::ifstream asked(files[0]);
        for (Shot shot; asked >> shot.width >> shot.height;) {
            for (double* at : {shot.eye, shot.target, shot.step}) asked >> at[0] >> at[1] >> at[2];
            asked >> shot.fovy >> shot.tall;
            look(pass, shot);
            std::string red;
            std::chrono::duration<double, std::milli> least(1e9);
            for (int i = 0; i < 8; ++i) {
                const auto begin = std::chrono::steady_clock::now();
                red = frame(shot);
                least = std::min<decltype(least)>(least, std::chrono::steady_clock::now() - begin);
                for (int k = 0; k < 3; ++k) shot.eye[k] += shot.step[k];
            }
            result << least.count() << "\n" << red;
        }
    }
    if (!result.flush()) throw std::runtime_error("cannot write the results");
}
