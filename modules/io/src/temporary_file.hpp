// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A file that gets its name only when it is whole.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <wm3d/core/descriptor.hpp>

namespace wm3d::io {

struct TemporaryOptions {
    std::optional<unsigned> mode = std::nullopt; ///< permissions; default: what the umask leaves
    bool unnamed = true;                         ///< have no name before commit, where the system can
};

/// A file in the folder of its target. Where the system can, it has no name at all until it is committed, so
/// that not even a killed process leaves it behind; else a name of its own, which the destructor removes.
class TemporaryFile {
public:
    /// Writes the bytes and flushes them to the disk.
    /// \throw OutputError
    TemporaryFile(std::filesystem::path target, std::string_view bytes, const TemporaryOptions& options = {});
    ~TemporaryFile();
    TemporaryFile(TemporaryFile&& other) noexcept;
    TemporaryFile& operator=(TemporaryFile&&) = delete;

    const std::filesystem::path& target() const { return target_; }

    enum class Existing {
        refuse,  ///< leave what has the target's name, and fail
        replace, ///< for good
        keep,    ///< replace, and keep the file until this object is destroyed, so that roll_back finds it
    };
    /// Takes the target's name.
    /// \throw OutputError  if that can't be had; then nothing has changed
    void commit(Existing existing);

    /// After commit: gives the name back to the file that was kept, or to nothing if there was none.
    void roll_back() noexcept;

private:
    void write(std::string_view bytes, std::optional<unsigned> mode);
    void open_named(unsigned mode);
    void give_name(const std::string& name);
    void keep_former();
    void replace_target();

    std::filesystem::path target_;
    Descriptor file_;
    std::string name_;   ///< of its own; empty: none
    std::string former_; ///< where the file is kept that had the target's name
    bool can_go_back_ = false;
};

} // namespace wm3d::io
