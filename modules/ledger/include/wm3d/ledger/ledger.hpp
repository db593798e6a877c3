// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The owner's ledger: which copy went to whom. An SQLite file whose entries are chained by hashes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wm3d::ledger {

/// A copy that was made for somebody.
struct Entry {
    std::int64_t number = 0; ///< 1, 2, ... in the order of entering
    std::string time;        ///< when it was entered, UTC: 2026-11-25T20:15:00Z
    std::string work;        ///< SHA-256 of the file that was marked, 64 hexadecimal digits
    std::string file;        ///< its name, for people
    std::string recipient;
    std::string copy;     ///< SHA-256 of the file that was written
    unsigned level = 0;   ///< of the mark's sphere
    std::string settings; ///< of the mark, a JSON object
    std::string tool;     ///< name and version of the program that marked
    std::string previous; ///< digest of the entry before, of the owner's commitment for the first
    std::string
        digest; ///< SHA-256 of `line` without its last field: a change of any entry shows in all after it
};

/// An entry as a line of JSON, the form that is exported and hashed.
std::string to_json_line(const Entry& entry);

/// Whose ledger it is.
struct Owner {
    std::string fingerprint;
    std::string commitment;

    bool operator==(const Owner&) const = default;
};

/// What `Ledger::check` found.
struct CheckReport {
    std::int64_t entries = 0;
    std::string head; ///< digest of the last entry; noted elsewhere, it also tells a ledger that lost its end
    std::vector<std::string> defects; ///< one sentence each; none in a whole ledger
};

struct OpenOptions {
    std::optional<Owner> owner; ///< whose it has to be
    bool create = false;        ///< make a new one, for `owner`, where there is none
    int patience_ms = 10000;    ///< how long to wait for another program that writes to it
};

class Addition;

/// An open ledger. Several programs may read and write one at a time.
class Ledger {
public:
    /// Newest form of the file that this library reads and the one it writes.
    static constexpr int format_version = 1;

    /// \throw InputError      if there is none, it is no ledger, cut, altered or of a newer version
    /// \throw ParameterError  if it belongs to another key
    /// \throw OutputError     if it can't be made
    explicit Ledger(const std::filesystem::path& path, const OpenOptions& options = {});
    ~Ledger();
    Ledger(Ledger&&) noexcept;
    Ledger& operator=(Ledger&&) noexcept;

    const Owner& owner() const { return owner_; }
    std::int64_t size() const;

    /// Calls `take` for every entry in order.
    /// \throw InputError  if it is locked or can't be read
    void visit(const std::function<void(const Entry&)>& take) const;
    std::optional<Entry> find(std::string_view work, std::string_view recipient) const;
    std::optional<Entry> find(std::int64_t number) const;

    /// Whether the file is whole, numbers follow each other and every digest is what it should be.
    CheckReport check() const;

    /// Enters a copy, for the time being: number, time, previous and digest are filled in here, and nobody
    /// else can write until the addition is committed or given up.
    /// \throw ParameterError if the work has a copy for this recipient already
    /// \throw OutputError if it is locked or can't be written
    Addition add(Entry entry);

private:
    friend class Addition;
    struct Database;

    std::filesystem::path path_;
    std::unique_ptr<Database> database_;
    Owner owner_;
};

/// An entry that counts once it is committed; otherwise the ledger stays as it was.
class Addition {
public:
    ~Addition();
    Addition(Addition&&) noexcept;
    Addition& operator=(Addition&&) = delete;

    const Entry& entry() const { return entry_; }

    /// \throw OutputError  if it can't be written; the ledger then stays as it was
    void commit();

private:
    friend class Ledger;
    Addition(Ledger& ledger, Entry entry) : ledger_(&ledger), entry_(std::move(entry)) {}

    Ledger* ledger_;
    Entry entry_;
};

} // namespace wm3d::ledger
