// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/picture/image.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include <png.h>

#include <wm3d/core/error.hpp>

namespace wm3d::picture {

namespace {

void require_same_size(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height)
        throw ParameterError("pictures of different sizes can't be compared; render both in the same size");
}

} // namespace

Image beside(const std::vector<Image>& images, std::size_t gap) {
    if (images.empty())
        return {};
    std::size_t width = gap * (images.size() - 1);
    for (const Image& image : images) {
        if (image.height != images.front().height)
            throw ParameterError("pictures of different heights can't stand side by side");
        width += image.width;
    }
    Image row(width, images.front().height);
    std::size_t left = 0;
    for (const Image& image : images) {
        for (std::size_t y = 0; y < image.height; ++y)
            for (std::size_t x = 0; x < image.width; ++x)
                row.at(left + x, y) = image.at(x, y);
        left += image.width + gap;
    }
    return row;
}

double rms_difference(const Image& a, const Image& b) {
    require_same_size(a, b);
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double d = int{a.pixels[i][c]} - int{b.pixels[i][c]};
            sum += d * d;
        }
    return a.pixels.empty() ? 0 : std::sqrt(sum / (3 * static_cast<double>(a.pixels.size())));
}

int largest_difference(const Image& a, const Image& b) {
    require_same_size(a, b);
    int largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            largest = std::max(largest, std::abs(int{a.pixels[i][c]} - int{b.pixels[i][c]}));
    return largest;
}

void write_png(const std::filesystem::path& file, const Image& image) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width);
    header.height = static_cast<png_uint_32>(image.height);
    header.format = PNG_FORMAT_RGB;
    if (png_image_write_to_file(&header, file.c_str(), 0, image.pixels.data(), 0, nullptr) == 0)
        throw OutputError(file.string() + ": the picture can't be written (" + header.message +
                          "); check the folder and the space on the disk");
}

} // namespace wm3d::picture
