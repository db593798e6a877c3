// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Numbers in binary files, and patching coordinates in place.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "document.hpp"

namespace wm3d::io {

enum class Scalar : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };

std::size_t size_of(Scalar type);
bool is_integer(Scalar type);
bool is_signed(Scalar type);
/// Largest value of an integer type.
double largest_integer(Scalar type);

/// Reads the number at `at`; `swap` if the file's byte order is not the machine's.
double load(const char* at, Scalar type, bool swap);
/// Writes `value` rounded to the nearest that the type holds.
void save(char* at, Scalar type, bool swap, double value);
/// The value that save would store.
double nearest(Scalar type, double value);
/// Distance of neighbouring values near `magnitude`.
double step_near(Scalar type, double magnitude);

/// Appends the number as a little-endian file stores it.
void put(std::string& out, Scalar type, double value);

constexpr bool swaps(std::endian file) {
    return file != std::endian::native;
}

/// Where records begin in a file: evenly spaced, as nearly always, or listed.
class RecordPlaces {
public:
    void add(std::size_t offset);
    std::size_t size() const { return size_; }
    std::size_t operator[](std::size_t i) const { return listed_.empty() ? first_ + i * step_ : listed_[i]; }

private:
    std::size_t first_ = 0, step_ = 0, size_ = 0;
    std::vector<std::size_t> listed_; ///< empty as long as they are evenly spaced
};

/// Coordinates as numbers at computed or listed places of a binary file.
class BinaryStore final : public CoordinateStore {
public:
    struct Layout {
        std::array<Scalar, 3> types{Scalar::f32, Scalar::f32, Scalar::f32}; ///< of x, y, z
        std::array<std::size_t, 3> within{0, 4, 8};                         ///< their offsets in a record
        bool swap = false;
    };

    BinaryStore(std::string_view bytes, const Layout& layout) : bytes_(bytes), layout_(layout) {}

    void reserve(std::size_t) {}
    /// Adds the slot whose record starts at `offset`.
    /// \return its position
    Vec3 add(std::size_t offset);

    double step(const Welding& welding) const override;
    std::vector<Vec3> settle(const Welding& welding, std::span<const Vec3> wanted) const override;
    PatchedFiles patch(const Welding& welding, std::span<const Vec3> wanted,
                       std::string_view output_name) const override;

private:
    std::string_view bytes_;
    Layout layout_;
    RecordPlaces records_;
};

} // namespace wm3d::io
