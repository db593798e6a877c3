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
    std::string receipt;  ///< SHA-256 of the work's receipt, which is kept beside the entries; empty: none
    std::string previous; ///< digest of the entry before, of the owner's commitment for the first
    std::string
        digest; ///< SHA-256 of `line` without its last field: a change of any entry shows in all after it
};

/// An entry as a line of JSON, the form that is exported and hashed.
std::string to_json_line(const Entry& entry);

/// What tells how the copies of a work lie where their own shape doesn't: the receipt of its first copy.
struct WorkReceipt {
    std::string work;
    std::string text; ///< as it was entered; this library doesn't look into it
};

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
    /// Newest form of the file that this library reads and the one it writes. Version 1 had no receipts; such a file
    /// becomes one of version 2 with the first entry that is added.
    static constexpr int format_version = 2;

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

    /// The receipts of all works that have one, those of the latest works first.
    std::vector<WorkReceipt> receipts() const;

    bool has_receipt(std::string_view work) const;

    /// Whether the file is whole, numbers follow each other and every digest is what it should be.
    CheckReport check() const;

    /// Enters a copy, for the time being: number, time, receipt, previous and digest are filled in here, and nobody
    /// else can write until the addition is committed or given up.
    /// \param receipt  of the work; kept if it is the first one
    /// \throw ParameterError if the work has a copy for this recipient already
    /// \throw OutputError if it is locked or can't be written
    Addition add(Entry entry, std::string_view receipt = {});

private:
    friend class Addition;
    struct Database;

    bool holds_receipt(const std::string& digest) const;

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
