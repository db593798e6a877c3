// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/copies.hpp"

#include <system_error>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/utf8.hpp>

namespace wm3d::cmd {

namespace {

namespace fs = std::filesystem;

/// Files that are about to be written. Until `keep` is called, the end of its life takes them away again and
/// puts back what stood there.
class ProvisionalFiles {
public:
    ProvisionalFiles() = default;
    ~ProvisionalFiles() {
        std::error_code ignored; // nothing better can be done
        for (const Place& place : places_) {
            if (kept_ || written_)
                fs::remove(kept_ ? place.aside : place.path, ignored);
            if (!kept_ && !place.aside.empty())
                fs::rename(place.aside, place.path, ignored);
        }
    }
    ProvisionalFiles(const ProvisionalFiles&) = delete;
    ProvisionalFiles& operator=(const ProvisionalFiles&) = delete;

    /// \param overwrite  whether what stands there may be moved aside; else nothing should stand there
    /// \throw OutputError  if it can't be
    void add(const fs::path& path, bool overwrite) {
        Place place{path, {}};
        if (overwrite && fs::exists(fs::symlink_status(path))) {
            place.aside = path;
            place.aside += ".before";
            std::error_code error;
            fs::rename(path, place.aside, error);
            if (error)
                throw OutputError(
                    fmt::format("{}: the file can't be replaced: {}", path.string(), error.message()));
        }
        places_.push_back(std::move(place));
    }

    void written() { written_ = true; } ///< the names are taken by what was written now
    void keep() { kept_ = true; }

private:
    struct Place {
        fs::path path, aside;
    };
    std::vector<Place> places_;
    bool written_ = false, kept_ = false;
};

} // namespace

std::string ledger_path(const std::string& named, const std::string& key_file) {
    return named.empty() ? fs::path(key_file).replace_extension(".ledger").string() : named;
}

ledger::Owner owner_of(const key::Key& key) {
    return {key.fingerprint(), key.commitment()};
}

void check_recipient(std::string_view name) {
    constexpr std::size_t most = 200;
    if (name.empty() || name.size() > most || !is_printable(name) || name.starts_with(' ') ||
        name.ends_with(' '))
        throw ParameterError(
            fmt::format("the name of a recipient has to be a line of 1 to {} bytes of UTF-8 that neither "
                        "starts nor ends with a space",
                        most));
}

void check_entry(const std::string& path, const key::Key& key, std::string_view work,
                 std::string_view recipient) {
    if (!fs::exists(path) || fs::is_empty(path))
        return; // it will be made
    if (const auto old = ledger::Ledger(path, {.owner = owner_of(key)}).find(work, recipient))
        throw ParameterError(
            fmt::format("{}: there is a copy of this work for '{}' already, entered as number {} at {}; "
                        "choose another name",
                        path, recipient, old->number, old->time));
}

bool has_receipt(const std::string& path, std::string_view work) {
    return fs::exists(path) && !fs::is_empty(path) && ledger::Ledger(path).has_receipt(work);
}

std::vector<fs::path> names_of(const fs::path& path, const io::PatchedFiles& files) {
    std::vector<fs::path> names{path};
    for (const io::SideFile& side : files.side_files)
        names.push_back(path.parent_path() / side.name);
    return names;
}

ledger::Entry enter_copy(const std::string& ledger, const key::Key& key, ledger::Entry entry,
                         std::string_view receipt, io::FileSet& files, const std::vector<fs::path>& names,
                         bool overwrite) {
    ledger::Ledger book(ledger, {.owner = owner_of(key), .create = true});
    ledger::Addition addition = book.add(std::move(entry), receipt);
    ProvisionalFiles provisional;
    for (const fs::path& name : names)
        provisional.add(name, overwrite);
    files.commit();
    provisional.written();
    addition.commit();
    provisional.keep();
    return addition.entry();
}

} // namespace wm3d::cmd
