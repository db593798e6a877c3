// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A secret's watermark sequences, each made when it is first asked for, by any thread.
#pragma once

#include <map>
#include <mutex>
#include <span>
#include <vector>

#include <wm3d/detect/family.hpp>
#include <wm3d/key/stream.hpp>

namespace wm3d::watermark {

class Sequences {
public:
    Sequences(key::Secret secret, double rmax) : secret_(std::move(secret)), rmax_(rmax) {}

    std::span<const double> operator()(unsigned level) {
        const std::lock_guard lock(guard_);
        auto [entry, is_new] = made_.try_emplace(level);
        if (is_new)
            entry->second = key::watermark_sequence(secret_, level, rmax_);
        return entry->second;
    }

    /// As the detector takes it. Valid while this object lives.
    detect::SequenceOfLevel function() {
        return [this](unsigned level) { return (*this)(level); };
    }

private:
    key::Secret secret_;
    double rmax_;
    std::mutex guard_;
    std::map<unsigned, std::vector<double>> made_;
};

} // namespace wm3d::watermark
