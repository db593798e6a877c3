// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/ledger/ledger.hpp>

#include <array>
#include <chrono>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sodium.h>
#include <sqlite3.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/hex.hpp>

#include "sqlite.hpp"

namespace wm3d::ledger {

namespace {

using nlohmann::ordered_json;

constexpr int application_id = 0x774d3364; // "wM3d": tells a ledger from other SQLite files

constexpr std::string_view schema = R"(
    CREATE TABLE owner (fingerprint TEXT NOT NULL, commitment TEXT NOT NULL);
    CREATE TABLE copies (
        number INTEGER PRIMARY KEY, time TEXT NOT NULL, work TEXT NOT NULL, file TEXT NOT NULL,
        recipient TEXT NOT NULL, copy TEXT NOT NULL, level INTEGER NOT NULL, settings TEXT NOT NULL,
        tool TEXT NOT NULL, previous TEXT NOT NULL, digest TEXT NOT NULL,
        UNIQUE (work, recipient));)";

/// What version 2 adds to version 1.
constexpr std::string_view schema_of_receipts = R"(
    ALTER TABLE copies ADD COLUMN receipt TEXT NOT NULL DEFAULT '';
    CREATE TABLE receipts (digest TEXT PRIMARY KEY, text TEXT NOT NULL);)";

constexpr std::string_view columns =
    "number, time, work, file, recipient, copy, level, settings, tool, previous, digest";

Entry entry_of(const Statement& row) {
    return {row.number(0),
            row.text(1),
            row.text(2),
            row.text(3),
            row.text(4),
            row.text(5),
            static_cast<unsigned>(row.number(6)),
            row.text(7),
            row.text(8),
            row.text(11),
            row.text(9),
            row.text(10)};
}

std::string sha256(std::string_view text) {
    std::array<unsigned char, crypto_hash_sha256_BYTES> digest{};
    crypto_hash_sha256(digest.data(), reinterpret_cast<const unsigned char*>(text.data()), text.size());
    return to_hex(digest);
}

ordered_json to_json(const Entry& entry) {
    ordered_json json{{"number", entry.number}, {"time", entry.time},           {"work", entry.work},
                      {"file", entry.file},     {"recipient", entry.recipient}, {"copy", entry.copy},
                      {"level", entry.level},   {"settings", nullptr},          {"tool", entry.tool}};
    if (!entry.receipt.empty()) // entries of version 1 keep their digests
        json["receipt"] = entry.receipt;
    json["previous"] = entry.previous;
    // Settings that are no JSON are an altered entry: kept as they are, so that the digest tells.
    json["settings"] = ordered_json::parse(entry.settings, nullptr, false);
    if (json["settings"].is_discarded())
        json["settings"] = entry.settings;
    return json;
}

/// Bytes that are no UTF-8 don't stop an export: they are shown as replacement characters.
std::string text_of(const ordered_json& json) {
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

std::string digest_of(const Entry& entry) {
    return sha256(text_of(to_json(entry)));
}

std::string now() {
    const auto seconds = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(seconds)));
}

/// A sentence for what SQLite reports about a ledger.
std::string sentence(const std::filesystem::path& path, const SqliteError& error) {
    const std::string name = path.string();
    switch (error.code()) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return fmt::format("{}: another program is writing to the ledger; try again when it is done", name);
    case SQLITE_FULL:
        return fmt::format("{}: the disk is full, so nothing was entered; make room and try again", name);
    case SQLITE_READONLY:
        return fmt::format("{}: the ledger may not be written to; check its permissions and its folder's",
                           name);
    case SQLITE_NOTADB:
        return fmt::format("{}: this is no ledger; name the file that `mark --ledger` made", name);
    case SQLITE_CANTOPEN:
        return fmt::format("{}: the ledger can't be opened; check the name and the permissions of its folder",
                           name);
    case SQLITE_CORRUPT:
        return fmt::format("{}: the ledger is cut short or damaged; restore it from a backup", name);
    default:
        return fmt::format("{}: the ledger can't be used: {}", name, error.what());
    }
}

/// Runs work on a ledger; what SQLite reports becomes an error of type E.
template<typename E, typename Work>
auto translated(const std::filesystem::path& path, Work&& work) {
    try {
        return work();
    } catch (const SqliteError& error) {
        throw E(sentence(path, error));
    }
}

std::int64_t pragma(const Connection& connection, std::string_view name) {
    Statement statement = connection.prepare(fmt::format("PRAGMA {}", name));
    return statement.step() ? statement.number(0) : 0;
}

int version_of(const Connection& connection) {
    return static_cast<int>(pragma(connection, "user_version"));
}

/// Entries with the columns that `entry_of` takes; \p rest of the statement follows.
Statement select_entries(const Connection& connection, std::string_view rest) {
    return connection.prepare(fmt::format("SELECT {}, {} FROM copies {}", columns,
                                          version_of(connection) < 2 ? "''" : "receipt", rest));
}

/// Within a transaction.
void upgrade(const Connection& connection) {
    if (version_of(connection) >= 2)
        return;
    connection.run(schema_of_receipts);
    connection.run("PRAGMA user_version = 2");
}

/// The digest of a work's receipt, if it has one.
std::string receipt_of(const Connection& connection, std::string_view work) {
    if (version_of(connection) < 2)
        return "";
    Statement row = connection.prepare(
        "SELECT receipt FROM copies WHERE work = ? AND receipt <> '' ORDER BY number LIMIT 1");
    row.bind(1, work);
    return row.step() ? row.text(0) : "";
}

/// Keeps a receipt.
/// \return  its digest
std::string keep_receipt(const Connection& connection, std::string_view text) {
    const std::string digest = sha256(text);
    connection.prepare("INSERT OR IGNORE INTO receipts VALUES (?, ?)").bind(1, digest).bind(2, text).step();
    return digest;
}

/// The owner, if it is a ledger of a version that this library knows.
Owner read_owner(const Connection& connection, const std::filesystem::path& path) {
    if (pragma(connection, "application_id") != application_id)
        throw InputError(fmt::format(
            "{}: this is a database but no ledger; name the file that `mark --ledger` made", path.string()));
    const std::int64_t version = pragma(connection, "user_version");
    if (version > Ledger::format_version)
        throw InputError(
            fmt::format("{}: the ledger has version {}, and this program knows {}; use a newer wm3d",
                        path.string(), version, Ledger::format_version));
    Statement owner = connection.prepare("SELECT fingerprint, commitment FROM owner");
    if (!owner.step())
        throw InputError(fmt::format(
            "{}: the ledger names no owner, so it is damaged; restore it from a backup", path.string()));
    return {owner.text(0), owner.text(1)};
}

/// Makes the tables, unless another program was quicker.
void create(const Connection& connection, const Owner& owner) {
    connection.run("BEGIN IMMEDIATE");
    if (pragma(connection, "application_id") == 0 && pragma(connection, "schema_version") == 0) {
        connection.run(schema);
        connection.run(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = 1", application_id));
        upgrade(connection);
        connection.prepare("INSERT INTO owner VALUES (?, ?)")
            .bind(1, owner.fingerprint)
            .bind(2, owner.commitment)
            .step();
    }
    connection.run("COMMIT");
}

/// The digest that a new entry goes on from.
std::string head_of(const Connection& connection, const Owner& owner) {
    Statement last = connection.prepare("SELECT digest FROM copies ORDER BY number DESC LIMIT 1");
    return last.step() ? last.text(0) : sha256(owner.commitment);
}

void insert(const Connection& connection, const Entry& entry) {
    Statement statement = connection.prepare(
        fmt::format("INSERT INTO copies ({}, receipt) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", columns));
    statement.bind(1, entry.number).bind(2, entry.time).bind(3, entry.work).bind(4, entry.file);
    statement.bind(5, entry.recipient).bind(6, entry.copy).bind(7, std::int64_t{entry.level});
    statement.bind(8, entry.settings).bind(9, entry.tool).bind(10, entry.previous).bind(11, entry.digest);
    statement.bind(12, entry.receipt);
    statement.step();
}

} // namespace

std::string to_json_line(const Entry& entry) {
    ordered_json json = to_json(entry);
    json["digest"] = entry.digest;
    return text_of(json);
}

struct Ledger::Database : Connection {
    using Connection::Connection;
};

Ledger::Ledger(const std::filesystem::path& path, const OpenOptions& options) : path_(path) {
    // A file without a byte is what a full disk left of a new ledger.
    const bool is_there = std::filesystem::exists(path) && !std::filesystem::is_empty(path);
    if (!is_there && !options.create)
        throw InputError(fmt::format("{}: there is no such ledger; `mark --for NAME --ledger FILE` makes one",
                                     path.string()));
    const auto open = [&] {
        database_ = std::make_unique<Database>(path.string(), options.create, options.patience_ms);
        if (options.create && options.owner && pragma(*database_, "schema_version") == 0)
            create(*database_, *options.owner);
        owner_ = read_owner(*database_, path);
    };
    is_there ? translated<InputError>(path, open) : translated<OutputError>(path, open);
    if (options.owner && owner_ != *options.owner)
        throw ParameterError(
            fmt::format("{}: the ledger belongs to key {} and not to key {}; every key has a ledger of "
                        "its own",
                        path.string(), owner_.fingerprint, options.owner->fingerprint));
}

Ledger::~Ledger() = default;
Ledger::Ledger(Ledger&&) noexcept = default;
Ledger& Ledger::operator=(Ledger&&) noexcept = default;

std::int64_t Ledger::size() const {
    return translated<InputError>(path_, [&] {
        Statement count = database_->prepare("SELECT COUNT(*) FROM copies");
        count.step();
        return count.number(0);
    });
}

void Ledger::visit(const std::function<void(const Entry&)>& take) const {
    translated<InputError>(path_, [&] {
        Statement row = select_entries(*database_, "ORDER BY number");
        while (row.step())
            take(entry_of(row));
    });
}

std::optional<Entry> Ledger::find(std::string_view work, std::string_view recipient) const {
    return translated<InputError>(path_, [&]() -> std::optional<Entry> {
        Statement row = select_entries(*database_, "WHERE work = ? AND recipient = ?");
        row.bind(1, work).bind(2, recipient);
        return row.step() ? std::optional(entry_of(row)) : std::nullopt;
    });
}

std::optional<Entry> Ledger::find(std::int64_t number) const {
    return translated<InputError>(path_, [&]() -> std::optional<Entry> {
        Statement row = select_entries(*database_, "WHERE number = ?");
        row.bind(1, number);
        return row.step() ? std::optional(entry_of(row)) : std::nullopt;
    });
}

std::vector<WorkReceipt> Ledger::receipts() const {
    return translated<InputError>(path_, [&] {
        std::vector<WorkReceipt> found;
        if (version_of(*database_) < 2)
            return found;
        Statement row = database_->prepare(
            "SELECT work, text FROM copies JOIN receipts ON receipts.digest = copies.receipt "
            "GROUP BY work ORDER BY MAX(number) DESC");
        while (row.step())
            found.push_back({row.text(0), row.text(1)});
        return found;
    });
}

bool Ledger::has_receipt(std::string_view work) const {
    return translated<InputError>(path_, [&] { return !receipt_of(*database_, work).empty(); });
}

bool Ledger::holds_receipt(const std::string& digest) const {
    Statement row = database_->prepare("SELECT text FROM receipts WHERE digest = ?");
    row.bind(1, digest);
    return row.step() && sha256(row.text(0)) == digest;
}

CheckReport Ledger::check() const {
    CheckReport report;
    report.head = sha256(owner_.commitment);
    const auto complain = [&](std::string defect) {
        constexpr std::size_t most = 20; // one early change may break all that follows
        if (report.defects.size() < most)
            report.defects.push_back(std::move(defect));
    };
    try {
        Statement integrity = database_->prepare("PRAGMA integrity_check(1)");
        if (integrity.step() && integrity.text(0) != "ok")
            complain("the file is damaged: " + integrity.text(0));
        visit([&](const Entry& entry) {
            if (entry.number != ++report.entries)
                complain(fmt::format("entry {} stands where {} should", entry.number, report.entries));
            if (entry.previous != report.head)
                complain(fmt::format(
                    "entry {} does not follow the one before it: one was changed, removed or put in",
                    entry.number));
            if (entry.digest != digest_of(entry))
                complain(fmt::format("entry {} was changed after it was entered", entry.number));
            if (!entry.receipt.empty() && !holds_receipt(entry.receipt))
                complain(fmt::format("the receipt of entry {} was changed or removed", entry.number));
            report.head = entry.digest;
        });
    } catch (const SqliteError& error) {
        complain(sentence(path_, error));
    } catch (const InputError& error) {
        complain(error.what());
    }
    return report;
}

Addition Ledger::add(Entry entry, std::string_view receipt) {
    translated<OutputError>(path_, [&] { database_->run("BEGIN IMMEDIATE"); });
    Addition addition(*this, std::move(entry)); // rolls back unless it is committed
    Entry& made = addition.entry_;
    translated<OutputError>(path_, [&] { upgrade(*database_); });
    if (const std::optional<Entry> old = find(made.work, made.recipient))
        throw ParameterError(
            fmt::format("{}: there is a copy of this work for '{}' already, entered as number {} at {}; "
                        "choose another name",
                        path_.string(), made.recipient, old->number, old->time));
    translated<OutputError>(path_, [&] {
        made.number = size() + 1;
        made.time = now();
        made.receipt = receipt_of(*database_, made.work);
        if (made.receipt.empty() && !receipt.empty())
            made.receipt = keep_receipt(*database_, receipt);
        made.previous = head_of(*database_, owner_);
        made.digest = digest_of(made);
        insert(*database_, made);
    });
    return addition;
}

Addition::Addition(Addition&& other) noexcept
    : ledger_(std::exchange(other.ledger_, nullptr)), entry_(std::move(other.entry_)) {}

Addition::~Addition() {
    if (!ledger_)
        return;
    try {
        ledger_->database_->run("ROLLBACK");
    } catch (const SqliteError&) {
        // SQLite rolled back by itself when the write failed
    }
}

void Addition::commit() {
    translated<OutputError>(ledger_->path_, [&] { ledger_->database_->run("COMMIT"); });
    ledger_ = nullptr;
}

} // namespace wm3d::ledger
