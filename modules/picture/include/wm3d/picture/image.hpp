// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace wm3d::picture {

using Rgb = std::array<std::uint8_t, 3>;

struct Image {
    std::size_t width = 0, height = 0;
    std::vector<Rgb> pixels; ///< row by row from the top, #width * #height

    Image() = default;
    Image(std::size_t w, std::size_t h, Rgb colour = {255, 255, 255})
        : width(w), height(h), pixels(w * h, colour) {}

    Rgb& at(std::size_t x, std::size_t y) { return pixels[y * width + x]; }
    const Rgb& at(std::size_t x, std::size_t y) const { return pixels[y * width + x]; }
};

/// Lays images of the same height side by side, `gap` white pixels apart.
/// \throw ParameterError  if heights differ
Image beside(const std::vector<Image>& images, std::size_t gap = 4);

/// Root mean square of the differences over all channels, 0 to 255.
/// \throw ParameterError  if the sizes differ
double rms_difference(const Image& a, const Image& b);

/// Largest difference of a channel, 0 to 255.
/// \throw ParameterError  if the sizes differ
int largest_difference(const Image& a, const Image& b);

/// \throw OutputError  if the file can't be written
void write_png(const std::filesystem::path& file, const Image& image);

} // namespace wm3d::picture
