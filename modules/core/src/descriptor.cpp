// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/descriptor.hpp>

#include <cerrno>

#include <fcntl.h>

namespace wm3d {

bool write_all(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(fd, bytes.data(), bytes.size());
        if (written >= 0)
            bytes.remove_prefix(static_cast<std::size_t>(written));
        else if (errno != EINTR)
            return false;
    }
    return true;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

void sync_folder_of(const std::filesystem::path& file) {
    const Descriptor folder(::open(folder_of(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.valid())
        static_cast<void>(::fsync(folder.get()));
}

} // namespace wm3d
