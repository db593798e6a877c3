// SPDX-License-Identifier: GPL-3.0-or-later
#include "binary.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <wm3d/core/parallel.hpp>

namespace wm3d::io {

namespace {

constexpr std::size_t element_block = 16384;

/// Calls f with a value of the C++ type of `type`.
template<typename F>
auto with_type(Scalar type, F&& f) {
    switch (type) {
    case Scalar::i8:
        return f(std::int8_t{});
    case Scalar::u8:
        return f(std::uint8_t{});
    case Scalar::i16:
        return f(std::int16_t{});
    case Scalar::u16:
        return f(std::uint16_t{});
    case Scalar::i32:
        return f(std::int32_t{});
    case Scalar::u32:
        return f(std::uint32_t{});
    case Scalar::f32:
        return f(float{});
    case Scalar::f64:
        break;
    }
    return f(double{});
}

template<typename T>
void swap_bytes(T& value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    std::reverse(raw, raw + sizeof(T));
    std::memcpy(&value, raw, sizeof(T));
}

/// Nearest finite value of T; halves go to even, as floating-point rounding does.
template<typename T>
T to_nearest(double value) {
    using Limits = std::numeric_limits<T>;
    value = std::clamp(value, static_cast<double>(Limits::lowest()), static_cast<double>(Limits::max()));
    if constexpr (Limits::is_integer)
        value = std::nearbyint(value);
    return static_cast<T>(value);
}

} // namespace

std::size_t size_of(Scalar type) {
    return with_type(type, [](auto t) { return sizeof(t); });
}

bool is_integer(Scalar type) {
    return type != Scalar::f32 && type != Scalar::f64;
}

bool is_signed(Scalar type) {
    return with_type(type, [](auto t) { return std::numeric_limits<decltype(t)>::is_signed; });
}

double largest_integer(Scalar type) {
    return with_type(type,
                     [](auto t) { return static_cast<double>(std::numeric_limits<decltype(t)>::max()); });
}

double load(const char* at, Scalar type, bool swap) {
    return with_type(type, [&](auto value) {
        std::memcpy(&value, at, sizeof(value));
        if (swap)
            swap_bytes(value);
        return static_cast<double>(value);
    });
}

void save(char* at, Scalar type, bool swap, double value) {
    with_type(type, [&](auto stored) {
        stored = to_nearest<decltype(stored)>(value);
        if (swap)
            swap_bytes(stored);
        std::memcpy(at, &stored, sizeof(stored));
        return 0;
    });
}

void put(std::string& out, Scalar type, double value) {
    out.resize(out.size() + size_of(type));
    save(out.data() + out.size() - size_of(type), type, swaps(std::endian::little), value);
}

double nearest(Scalar type, double value) {
    return with_type(type, [&](auto t) { return static_cast<double>(to_nearest<decltype(t)>(value)); });
}

double step_near(Scalar type, double magnitude) {
    return with_type(type, [&](auto t) {
        using T = decltype(t);
        if constexpr (std::numeric_limits<T>::is_integer) {
            return 1.0;
        } else {
            const T near = to_nearest<T>(magnitude);
            return static_cast<double>(std::nextafter(near, std::numeric_limits<T>::infinity())) -
                   static_cast<double>(near);
        }
    });
}

void RecordPlaces::add(std::size_t offset) {
    if (size_ == 0)
        first_ = offset;
    if (size_ == 1)
        step_ = offset - first_;
    if (listed_.empty() && offset != (*this)[size_])
        for (std::size_t i = 0; i < size_; ++i)
            listed_.push_back(first_ + i * step_);
    if (!listed_.empty())
        listed_.push_back(offset);
    ++size_;
}

Vec3 BinaryStore::add(std::size_t offset) {
    records_.add(offset);
    Vec3 position;
    for (std::size_t k = 0; k < 3; ++k)
        position[static_cast<int>(k)] =
            load(bytes_.data() + offset + layout_.within[k], layout_.types[k], layout_.swap);
    return position;
}

double BinaryStore::step(const Welding& welding) const {
    const Vec3 largest = largest_coordinates(welding.mesh);
    double coarsest = 0;
    for (std::size_t k = 0; k < 3; ++k)
        coarsest = std::max(coarsest, step_near(layout_.types[k], largest[static_cast<int>(k)]));
    return coarsest;
}

std::vector<Vec3> BinaryStore::settle(const Welding& welding, std::span<const Vec3> wanted) const {
    const std::vector<Vec3>& old = welding.mesh.positions;
    std::vector<Vec3> settled = old;
    parallel_blocks(old.size(), element_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            for (int k = 0; k < 3; ++k)
                if (wanted[v][k] != old[v][k])
                    settled[v][k] = nearest(layout_.types[static_cast<std::size_t>(k)], wanted[v][k]);
    });
    return settled;
}

PatchedFiles BinaryStore::patch(const Welding& welding, std::span<const Vec3> wanted,
                                std::string_view) const {
    std::string out(bytes_);
    for (std::size_t slot = 0; slot < records_.size(); ++slot) {
        const Index v = welding.vertex_of_slot[slot];
        for (std::size_t k = 0; k < 3; ++k) {
            const int axis = static_cast<int>(k);
            if (wanted[v][axis] != welding.mesh.positions[v][axis])
                save(out.data() + records_[slot] + layout_.within[k], layout_.types[k], layout_.swap,
                     wanted[v][axis]);
        }
    }
    return {std::move(out), {}};
}

} // namespace wm3d::io
