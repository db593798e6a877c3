// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/json_lines.hpp>

#include <cerrno>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <wm3d/core/descriptor.hpp>
#include <wm3d/core/error.hpp>
#include <wm3d/core/json_depth.hpp>

namespace wm3d::study {

using nlohmann::ordered_json;

JsonLines::JsonLines(const std::string& path, const std::string& what, std::string_view schema,
                     const Reader& reader)
    : path_(path) {
    open();
    size_ = read_lines(what, schema, reader);
    was_empty_ = size_ == 0;
    cut(size_);
}

void JsonLines::fail_writing(int error) const {
    throw OutputError(fmt::format("{}: the file can't be written: {}", path_, std::strerror(error)));
}

/// Opens the file without changing anything in it, and keeps other processes from doing the same.
void JsonLines::open() {
    struct stat status {};
    if (::stat(path_.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
        throw OutputError(fmt::format("{}: this is no regular file; name a new file", path_));
    file_ = Descriptor(::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    if (!file_.valid())
        fail_writing(errno);
    // Any other reason: a file system without locks.
    if (::flock(file_.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        throw OutputError(fmt::format(
            "{}: another process is writing to this file; wait for it, or name a new file", path_));
}

/// \return  how many bytes the lines that are complete have
std::uintmax_t JsonLines::read_lines(const std::string& what, std::string_view schema, const Reader& reader) {
    std::ifstream in(path_, std::ios::binary);
    std::string line;
    std::uintmax_t whole = 0;
    for (std::size_t number = 1; std::getline(in, line) && !in.eof(); ++number) {
        whole += line.size() + 1;
        check_json_depth(line, fmt::format("{}, line {}", path_, number));
        try {
            reader(ordered_json::parse(line), number);
        } catch (const ordered_json::exception&) {
            throw InputError(fmt::format("{}: line {} is no {}; remove the line, or name a new file", path_,
                                         number, what));
        }
    }
    // Somebody else's file may have no line end at all, and must not be taken for a first line cut off.
    if (whole == 0 && !line.empty() && !line.starts_with(fmt::format(R"({{"schema":"{}")", schema)))
        throw InputError(
            fmt::format("{}: this file was not begun by wm3d, so it is left alone; name a new file", path_));
    return whole;
}

void JsonLines::cut(std::uintmax_t size) {
    struct stat status {};
    if (::fstat(file_.get(), &status) != 0)
        fail_writing(errno);
    if (static_cast<std::uintmax_t>(status.st_size) != size &&
        ::ftruncate(file_.get(), static_cast<off_t>(size)) != 0)
        fail_writing(errno);
}

void JsonLines::append(const ordered_json& line) {
    const std::string text = line.dump() + '\n';
    if (!write_all(file_.get(), text)) {
        const int reason = errno;
        [[maybe_unused]] const int ignored = ::ftruncate(file_.get(), static_cast<off_t>(size_));
        fail_writing(reason);
    }
    size_ += text.size();
}

} // namespace wm3d::study
