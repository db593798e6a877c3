// SPDX-License-Identifier: GPL-3.0-or-later
// The `vn` lines of an OBJ file and the corners that name them; the rest of its faces has been checked
// before.
#include <charconv>
#include <cstdint>

#include "normals.hpp"
#include "obj_lines.hpp"
#include "text.hpp"

namespace wm3d::io {

namespace {

/// "7", "7/1", "7//3" or "7/1/3": the numbers as they stand, 0 where there is none.
struct Corner {
    std::int64_t vertex = 0, normal = 0;
};

std::int64_t number_in(std::string_view text) {
    std::int64_t value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

Corner parse_corner(std::string_view word) {
    Corner corner{number_in(word), 0};
    if (const std::size_t first = word.find('/'); first != std::string_view::npos)
        if (const std::size_t second = word.find('/', first + 1); second != std::string_view::npos)
            corner.normal = number_in(word.substr(second + 1));
    return corner;
}

class NormalReader {
public:
    /// `source` has no continued lines; the offsets hold in `patched` as well.
    NormalReader(const Source& source, std::string_view patched, NormalUses& uses)
        : scan_(source, 0), store_(std::make_unique<TextStore>(patched)), uses_(uses) {}

    std::optional<NormalTable> run() {
        while (!scan_.at_end()) {
            scan_.skip_blanks();
            if (begins("vn"))
                read_normal();
            else if (begins("v"))
                ++vertices_;
            else if (begins("f"))
                read_face();
            scan_.skip_line();
        }
        for (Index& n : uses_.normal_of_corner)
            if (n >= normals_.size())
                n = no_index; // named but not there, which readers have to bear
        if (normals_.empty())
            return std::nullopt;
        return NormalTable{std::move(normals_), std::move(store_)};
    }

private:
    /// Whether the line's keyword is this one; if so, goes on behind it.
    bool begins(std::string_view keyword) {
        const std::string_view rest = scan_.source().bytes.substr(scan_.offset(), keyword.size() + 1);
        if (rest.size() <= keyword.size() || !rest.starts_with(keyword) ||
            (rest.back() != ' ' && rest.back() != '\t'))
            return false;
        scan_.jump(scan_.offset() + keyword.size());
        return true;
    }

    void read_normal() {
        std::array<std::size_t, 3> offsets{};
        normals_.push_back(scan_.any_vector("a normal", offsets));
        store_->add(offsets);
    }

    void read_face() {
        for (scan_.skip_blanks(); !scan_.at_line_end(); scan_.skip_blanks()) {
            const std::string_view word = scan_.word();
            if (word.starts_with('#'))
                break;
            const Corner corner = parse_corner(word);
            uses_.faces.corners.push_back(from_zero(corner.vertex, vertices_));
            uses_.normal_of_corner.push_back(from_zero(corner.normal, normals_.size()));
        }
        uses_.faces.close_face();
    }

    /// OBJ counts from 1, or back from the latest with negative numbers.
    static Index from_zero(std::int64_t number, std::size_t so_far) {
        const std::int64_t index = number > 0 ? number - 1 : static_cast<std::int64_t>(so_far) + number;
        return number == 0 || index < 0 || index >= no_index ? no_index : static_cast<Index>(index);
    }

    TextScanner scan_;
    std::unique_ptr<TextStore> store_;
    NormalUses& uses_;
    std::vector<Vec3> normals_;
    std::size_t vertices_ = 0;
};

} // namespace

std::optional<NormalTable> obj_normals(const Source& patched, NormalUses& uses) {
    const std::string joined = join_continued_lines(patched.bytes);
    return NormalReader({patched.name, joined}, patched.bytes, uses).run();
}

} // namespace wm3d::io
