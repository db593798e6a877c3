// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  As much of SQLite as the ledger needs, with objects that close what they opened.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace wm3d::ledger {

/// What SQLite says when something fails; `Ledger` makes a sentence of it.
class SqliteError : public std::runtime_error {
public:
    SqliteError(int code, const std::string& message) : std::runtime_error(message), code_(code) {}
    int code() const { return code_; } ///< primary result code: SQLITE_BUSY, SQLITE_FULL, ...

private:
    int code_;
};

/// A prepared statement. Parameters are numbered from 1, columns from 0.
class Statement {
public:
    Statement(sqlite3* connection, std::string_view sql);

    Statement& bind(int parameter, std::string_view text);
    Statement& bind(int parameter, std::int64_t number);

    /// Runs to the next row; false if there is none.
    bool step();

    std::string text(int column) const;
    std::int64_t number(int column) const;

private:
    void require(int code) const;

    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };
    sqlite3* connection_;
    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

class Connection {
public:
    /// \param writable  open for writing, and make the file if it is not there
    Connection(const std::string& path, bool writable, int patience_ms);

    Statement prepare(std::string_view sql) const { return {connection_.get(), sql}; }
    void run(std::string_view sql) const;

private:
    struct Close {
        void operator()(sqlite3* connection) const;
    };
    std::unique_ptr<sqlite3, Close> connection_;
};

} // namespace wm3d::ledger
