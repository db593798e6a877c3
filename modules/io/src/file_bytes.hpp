// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The bytes of a file, which can go and come back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

namespace wm3d::io {

/// The bytes of a file in memory. While nobody needs them, a regular file's can go: the memory goes back to the system, and
/// once they are needed they are read again into the same place, so that views of them hold for the life of the object.
/// Calls may run at the same time, but not `let_go` while views are read.
class FileBytes {
public:
    explicit FileBytes(std::string bytes) : bytes_(std::move(bytes)) {}
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    /// Says where they can be read again.
    void came_from(std::filesystem::path path) { path_ = std::move(path); }

    /// They are here, for now.
    /// \throw InputError  if the file was changed since they went, or can't be read
    std::string_view here();

    /// Lets them go, where they can come back and are at least so many.
    void let_go(std::size_t fewest);

    /// \pre  nobody looks at them any more
    std::string take() &&;

private:
    void read_again();

    std::mutex guard_;
    std::string bytes_;
    std::filesystem::path path_;
    bool gone_ = false;
    std::uint64_t digest_ = 0; ///< of what went
};

} // namespace wm3d::io
